#include "tools/common/reused_image.h"

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace markerless_mocap {
namespace {

/// Holds the images that nobody uses.
class FreeImages {
 public:
  std::unique_ptr<sensor_msgs::Image> take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (images_.empty()) return std::make_unique<sensor_msgs::Image>();
    std::unique_ptr<sensor_msgs::Image> image = std::move(images_.back());
    images_.pop_back();
    return image;
  }
  void giveBack(std::unique_ptr<sensor_msgs::Image> image) {
    const std::lock_guard<std::mutex> lock(mutex_);
    images_.push_back(std::move(image));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<sensor_msgs::Image>> images_;
};

}  // namespace

sensor_msgs::Image::Ptr takeFreeImage() {
  static const auto free_images = std::make_shared<FreeImages>();
  return sensor_msgs::Image::Ptr(free_images->take().release(),
                                 [pool = free_images](sensor_msgs::Image* image) {
                                   pool->giveBack(std::unique_ptr<sensor_msgs::Image>(image));
                                 });
}

}  // namespace markerless_mocap
