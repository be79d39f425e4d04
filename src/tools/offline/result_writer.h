#pragma once

#include <tf2_msgs/TFMessage.h>

#include <cstdint>
#include <optional>

#include "markerless_mocap/pipeline/pipeline.h"
#include "markerless_mocap/tracking/pose_filter.h"
#include "tools/common/bag_io.h"
#include "tools/common/recorded_cameras.h"

namespace markerless_mocap {

/// Writes the results of the pipeline on the topics of the nodes. Header stamp and record time are
/// the capture time. /pose is raw; tf and joint_states are filtered.
class ResultWriter {
 public:
  /// \param filter empty: tf and joint_states are raw, too
  ResultWriter(BagWriter* bag, const BodyModel& model, std::string world_frame,
               std::optional<PoseFilter> filter = std::nullopt);

  /// Call this once, before the first frame set.
  void writeStaticTransforms(int64_t stamp_ns, const tf2_msgs::TFMessage& transforms);
  /// Writes the URDF of the body, latched. Call this once, before the first frame set.
  void writeDescription(int64_t stamp_ns, const std::string& urdf);
  /// Writes hull, parts, tree and pose.
  void write(int64_t stamp_ns, const PipelineResult& result);
  void writePose(int64_t stamp_ns, const BodyPose& raw);
  /// \param masks one per camera; empty ones are skipped
  /// \param topic under the camera's name
  void writeMasks(int64_t stamp_ns, const std::vector<RecordedCamera>& cameras,
                  const std::vector<cv::Mat>& masks, const std::string& topic);

 private:
  std_msgs::Header headerAt(int64_t stamp_ns) const;
  void writeHull(const std_msgs::Header& header, const VisualHull& hull);
  void writeParts(const std_msgs::Header& header, const PipelineResult& result);
  /// Writes the list of tracked bodies when it changes, latched.
  void announce(bool tracked, const std_msgs::Header& header);

  BagWriter* bag_;
  const BodyModel& model_;
  std::string world_frame_;
  std::optional<PoseFilter> filter_;
  bool grid_written_ = false;
  std::optional<bool> announced_;  ///< whether the body is in the list; unset before the first
};

}  // namespace markerless_mocap
