#include "nodes/common/image_cache.h"

#include "ros/camera_conversions.h"

namespace markerless_mocap {
namespace {
constexpr size_t kKept = 16;  // images per camera: what the masks may lag behind
}

void ImageCache::add(size_t camera, const CameraImage& image) {
  auto& images = images_.at(camera);
  const int64_t stamp_ns = nanosecondsOf(image.header().stamp);
  // Older than all that is kept: time went backwards, what is kept belongs to the old time.
  if (images.size() == kKept && stamp_ns < images.begin()->first) images.clear();
  images[stamp_ns] = image;
  if (images.size() > kKept) images.erase(images.begin());
}

const CameraImage* ImageCache::find(size_t camera, int64_t stamp_ns) const {
  const auto found = images_.at(camera).find(stamp_ns);
  return found == images_.at(camera).end() ? nullptr : &found->second;
}

bool ImageCache::mayStillCome(size_t camera, int64_t stamp_ns) const {
  const auto& images = images_.at(camera);
  return !images.empty() && images.rbegin()->first < stamp_ns;
}

}  // namespace markerless_mocap
