#include "tools/offline/result_writer.h"

#include <std_msgs/String.h>

#include <utility>

#include "ros/camera_conversions.h"
#include "ros/hull_conversions.h"
#include "ros/ids_list.h"
#include "ros/image_conversions.h"
#include "ros/pose_conversions.h"
#include "ros/pose_tree_conversions.h"
#include "ros/segmentation_conversions.h"

namespace markerless_mocap {

ResultWriter::ResultWriter(BagWriter* bag, const BodyModel& model, std::string world_frame,
                           std::optional<PoseFilter> filter)
    : bag_(bag), model_(model), world_frame_(std::move(world_frame)), filter_(std::move(filter)) {}

std_msgs::Header ResultWriter::headerAt(int64_t stamp_ns) const {
  std_msgs::Header header;
  header.stamp = rosTime(stamp_ns);
  header.frame_id = world_frame_;
  return header;
}

void ResultWriter::writeStaticTransforms(int64_t stamp_ns, const tf2_msgs::TFMessage& transforms) {
  bag_->writeLatched("/tf_static", rosTime(stamp_ns), transforms);
}

void ResultWriter::writeDescription(int64_t stamp_ns, const std::string& urdf) {
  std_msgs::String text;
  text.data = urdf;
  bag_->writeLatched("/humans/bodies/" + model_.id() + "/human_description", rosTime(stamp_ns),
                     text);
}

void ResultWriter::write(int64_t stamp_ns, const PipelineResult& result) {
  const std_msgs::Header header = headerAt(stamp_ns);
  writeHull(header, result.hull);
  writeParts(header, result);
  bag_->write("/pose_tree", header.stamp, messageFromPoseTree(result.tree, header));
  writePose(stamp_ns, result.pose);
}

void ResultWriter::writeMasks(int64_t stamp_ns, const std::vector<RecordedCamera>& cameras,
                              const std::vector<cv::Mat>& masks, const std::string& topic) {
  std_msgs::Header header = headerAt(stamp_ns);
  for (size_t i = 0; i < masks.size(); ++i) {
    if (masks[i].empty()) continue;
    header.frame_id = cameras[i].frame;
    bag_->write("/" + cameras[i].name + "/" + topic, header.stamp,
                messageFromMat(masks[i], header));
  }
}

void ResultWriter::writeHull(const std_msgs::Header& header, const VisualHull& hull) {
  if (!grid_written_)
    bag_->writeLatched("/hull/grid", header.stamp, messageFromLattice(hull.lattice, header));
  grid_written_ = true;
  bag_->write("/hull/points", header.stamp, messageFromHull(hull, header));
}

void ResultWriter::writeParts(const std_msgs::Header& header, const PipelineResult& result) {
  bag_->write("/segmentation/points", header.stamp,
              labelledCloud(result.hull, result.parts, header));
  bag_->write("/segmentation/parts", header.stamp, messageFromParts(result.parts, header));
}

void ResultWriter::writePose(int64_t stamp_ns, const BodyPose& raw) {
  const std_msgs::Header header = headerAt(stamp_ns);
  bag_->write("/pose", header.stamp, messageFromPose(model_, raw, header));
  const BodyPose pose = filter_ ? filter_->filtered(stamp_ns, raw) : raw;
  if (pose.status == PoseStatus::kLost) return announce(false, header);
  bag_->write("/humans/bodies/" + model_.id() + "/joint_states", header.stamp,
              jointStateFromPose(model_, pose, header));
  tf2_msgs::TFMessage transforms;
  transforms.transforms = linkTransforms(model_, pose, header);
  bag_->write("/tf", header.stamp, transforms);
  announce(true, header);
}

void ResultWriter::announce(bool tracked, const std_msgs::Header& header) {
  if (announced_ == tracked) return;
  announced_ = tracked;
  IdsList list;
  list.header.stamp = header.stamp;
  if (tracked) list.ids.push_back(model_.id());
  bag_->writeLatched(kTrackedBodies, header.stamp, list);
}

}  // namespace markerless_mocap
