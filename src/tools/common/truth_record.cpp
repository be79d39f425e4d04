#include "tools/common/truth_record.h"

#include <markerless_mocap/JointPositions.h>
#include <rosbag/view.h>
#include <sensor_msgs/JointState.h>

#include <map>
#include <stdexcept>

#include "ros/camera_conversions.h"
#include "tools/common/bag_io.h"
#include "tools/common/foreign_topic.h"
#include "tools/common/result_record.h"

namespace markerless_mocap {
namespace {

constexpr const char* kJoints = "/ground_truth/joints";
constexpr const char* kJointStates = "/ground_truth/joint_states";

void addJoints(const JointPositions& message, const std::string& path, TruthRecord* truth) {
  if (message.names.size() != message.positions.size())
    throw std::runtime_error(path + " has a " + kJoints + " with " +
                             std::to_string(message.names.size()) + " names for " +
                             std::to_string(message.positions.size()) + " positions");
  const bool first = truth->joints.names.empty();
  if (first) truth->joints.names = message.names;
  if (first) truth->world_frame = message.header.frame_id;
  if (message.names != truth->joints.names || message.header.frame_id != truth->world_frame)
    throw std::runtime_error(path + " changes the names or the frame of " + kJoints +
                             " during the recording");
  Eigen::Matrix3Xd points(3, message.positions.size());
  for (size_t i = 0; i < message.positions.size(); ++i)
    points.col(i) << message.positions[i].x, message.positions[i].y, message.positions[i].z;
  const int64_t stamp = nanosecondsOf(message.header.stamp);
  // Time starts again in a loop or a second recording; only the first pass is used.
  if (first || stamp > truth->joints.stamps_ns.back()) truth->joints.add(stamp, points);
}

void addAngles(const sensor_msgs::JointState& message, TruthRecord* truth) {
  AngleFrame frame;
  frame.stamp_ns = nanosecondsOf(message.header.stamp);
  if (!truth->angles.empty() && frame.stamp_ns <= truth->angles.back().stamp_ns) return;
  for (size_t i = 0; i < std::min(message.name.size(), message.position.size()); ++i)
    frame.angles[withoutId(message.name[i])] = message.position[i];
  truth->angles.push_back(std::move(frame));
}

}  // namespace

TruthRecord readTruth(const std::string& path) {
  rosbag::Bag bag;
  openForReading(path, bag);
  TruthRecord truth;
  const std::vector<std::string> topics{kJoints, kJointStates};
  for (const rosbag::MessageInstance& entry : rosbag::View(bag, rosbag::TopicQuery(topics))) {
    if (const auto joints = messageOf<JointPositions>(entry))
      addJoints(*joints, path, &truth);
    else if (const auto states = messageOf<sensor_msgs::JointState>(entry))
      addAngles(*states, &truth);
  }
  if (truth.joints.frames() == 0)
    throw std::runtime_error(path + " has no ground truth: no topic " + kJoints +
                             foreignTopic<JointPositions>(bag));
  return truth;
}

}  // namespace markerless_mocap
