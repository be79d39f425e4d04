#include "tools/evaluate/mask_store.h"

#include <rosbag/view.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>

#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"
#include "tools/common/bag_io.h"

namespace markerless_mocap {

const int64_t* nearestStamp(const std::vector<int64_t>& stamps_ns, int64_t stamp_ns,
                            int64_t tolerance_ns) {
  const auto after = std::lower_bound(stamps_ns.begin(), stamps_ns.end(), stamp_ns);
  const int64_t* nearest = nullptr;
  if (after != stamps_ns.end()) nearest = &*after;
  if (after != stamps_ns.begin() && (!nearest || stamp_ns - *(after - 1) < *nearest - stamp_ns))
    nearest = &*(after - 1);
  return nearest && std::llabs(*nearest - stamp_ns) <= tolerance_ns ? nearest : nullptr;
}

MaskStore::MaskStore(const std::string& path, const std::vector<std::string>& topics,
                     const std::vector<int64_t>& stamps_ns, int64_t tolerance_ns) {
  rosbag::Bag bag;
  openForReading(path, bag);
  for (const rosbag::MessageInstance& message : rosbag::View(bag, rosbag::TopicQuery(topics))) {
    const auto image = messageOf<sensor_msgs::Image>(message);
    if (!image) continue;
    const int64_t stamp = nanosecondsOf(image->header.stamp);
    const int64_t* frame_set = nearestStamp(stamps_ns, stamp, tolerance_ns);
    if (!frame_set) continue;
    const auto camera = std::find(topics.begin(), topics.end(), message.getTopic());
    const auto key = std::make_pair(*frame_set, size_t(camera - topics.begin()));
    const int64_t gap = std::llabs(*frame_set - stamp);
    if (const auto old = masks_.find(key); old != masks_.end() && old->second.gap_ns <= gap)
      continue;
    Entry& entry = masks_[key];
    entry.gap_ns = gap;
    cv::imencode(".png", maskFromMessage(*image), entry.png, {cv::IMWRITE_PNG_COMPRESSION, 1});
  }
}

cv::Mat MaskStore::at(int64_t stamp_ns, size_t camera) const {
  const auto entry = masks_.find({stamp_ns, camera});
  return entry == masks_.end() ? cv::Mat() : cv::imdecode(entry->second.png, cv::IMREAD_GRAYSCALE);
}

}  // namespace markerless_mocap
