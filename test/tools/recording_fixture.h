#pragma once

#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>

#include <string>
#include <vector>

#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"
#include "tools/common/camera_bag_writer.h"
#include "tools/common/recording.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {

constexpr int64_t kSecond = 1000000000;

/// Bags of a ring of four cameras.
class RecordingTest : public ToolTest {
 protected:
  /// One second at 10 Hz; the k-th instant lacks camera `missing` when k is 4.
  void writeBag(const std::string& name, int missing = -1, bool masks = false) const {
    CameraBagWriter bag(path(name), ringOfFour(), 0);
    bag.writeTransforms(kSecond);
    for (int k = 0; k < 10; ++k)
      for (int i = 0; i < 4; ++i)
        if (k != 4 || i != missing)
          bag.write(kSecond + k * kSecond / 10, i, smallImage(true),
                    masks ? smallMask() : cv::Mat());
    bag.commit();
  }

  /// One image of each camera; `change` may spoil what is known of a camera before it is written.
  template <class Change>
  void writeSpoilt(const std::string& name, const Change& change, bool with_tf = true) const {
    BagWriter bag(path(name));
    const auto ring = ringOfFour();
    const ros::Time stamp(1.0);
    for (size_t i = 0; i < ring.size(); ++i) {
      sensor_msgs::CameraInfo info = messageFromCalibration(ring[i]);
      info.header.stamp = stamp;
      info.header.frame_id = ring[i].name + "_optical";
      if (change(i, &info)) bag.write("/" + ring[i].name + "/camera_info", stamp, info);
      bag.write("/" + ring[i].name + "/image_raw", stamp,
                messageFromMat(smallImage(true), info.header));
      geometry_msgs::TransformStamped transform;
      transform.header.frame_id = "world";
      transform.child_frame_id = info.header.frame_id;
      transform.transform.rotation.w = 1.0;
      tf2_msgs::TFMessage tf;
      tf.transforms.push_back(transform);
      if (with_tf) bag.writeLatched("/tf_static", stamp, tf);
    }
    bag.commit();
  }

  std::string refusal(const std::string& name, const RecordingOptions& options = {}) const {
    return errorTextOf<std::exception>([&] { Recording recording(path(name), options); });
  }

  static std::vector<FrameSet> allOf(Recording& recording) {
    std::vector<FrameSet> frame_sets;
    while (auto frame_set = recording.next()) frame_sets.push_back(std::move(*frame_set));
    return frame_sets;
  }
};

}  // namespace markerless_mocap
