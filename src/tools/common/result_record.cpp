#include "tools/common/result_record.h"

#include <rosbag/view.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/String.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "evaluation/body_points.h"
#include "markerless_mocap/ros/messages.h"
#include "ros/camera_conversions.h"
#include "text/joined.h"
#include "tools/common/bag_io.h"
#include "tools/common/foreign_topic.h"
#include "tools/common/person_urdf.h"
#include "tools/common/stamped_transforms.h"

namespace markerless_mocap {
namespace {

constexpr const char* kRootLink = "body_";
constexpr double kDefaultStature = 1.75;  // m; default for the names of a body without description

std::string ofBody(const std::string& id, const char* topic) {
  return "/humans/bodies/" + id + "/" + topic;
}

StampedTransforms readTransforms(rosbag::Bag& bag) {
  StampedTransforms transforms;
  const std::vector<std::string> topics{"/tf", "/tf_static"};
  for (const rosbag::MessageInstance& entry : rosbag::View(bag, rosbag::TopicQuery(topics)))
    if (const auto message = messageOf<tf2_msgs::TFMessage>(entry))
      transforms.add(*message, entry.getTopic() == "/tf_static");
  return transforms;
}

/// Ids of all bodies in tf and /pose.
std::set<std::string> bodiesIn(rosbag::Bag& bag, const StampedTransforms& transforms) {
  std::set<std::string> ids;
  for (const std::string& frame : transforms.framesBeginningWith(kRootLink))
    ids.insert(frame.substr(std::string(kRootLink).size()));
  for (const rosbag::MessageInstance& entry : rosbag::View(bag, rosbag::TopicQuery("/pose")))
    if (const auto pose = messageOf<BodyPoseMsg>(entry)) ids.insert(pose->body_id);
  return ids;
}

std::string chooseBody(const std::set<std::string>& ids, const std::string& wanted,
                       const std::string& path, const rosbag::Bag& bag) {
  const std::string names = joined({ids.begin(), ids.end()});
  if (ids.empty())
    throw std::runtime_error(path + " has no results: neither a frame body_<id> in tf nor /pose" +
                             foreignTopic<tf2_msgs::TFMessage, BodyPoseMsg>(bag));
  if (wanted.empty() && ids.size() > 1)
    throw std::runtime_error(path + " has several bodies, " + names + ": choose one by --id");
  if (wanted.empty()) return *ids.begin();
  if (ids.count(wanted) == 0)
    throw std::runtime_error(path + " has no body " + wanted + ", it has " + names);
  return wanted;
}

void readBody(rosbag::Bag& bag, std::string urdf, ResultRecord* results) {
  const bool is_given = !urdf.empty();
  const rosbag::TopicQuery description(ofBody(results->body_id, "human_description"));
  for (const rosbag::MessageInstance& entry : rosbag::View(bag, description))
    if (const auto text = messageOf<std_msgs::String>(entry); text && !is_given) urdf = text->data;
  results->has_description = !urdf.empty();
  if (urdf.empty()) urdf = bodyUrdf("", results->body_id, kDefaultStature);
  try {
    results->body = std::make_shared<const BodyModel>(BodyModel::fromUrdf(urdf, results->body_id));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument((is_given ? "--urdf" : bag.getFileName()) + ": " + error.what());
  }
}

FrameStatus statusOf(const BodyPoseMsg& pose) {
  if (pose.status == BodyPoseMsg::TRACKED) return FrameStatus::kTracked;
  return pose.status == BodyPoseMsg::REINITIALIZED ? FrameStatus::kReinitialized
                                                   : FrameStatus::kLost;
}

using FramesByStamp = std::map<int64_t, ResultFrame>;

/// Status of each frame of the tracker.
FramesByStamp readStatuses(rosbag::Bag& bag, const StampedTransforms& transforms,
                           ResultRecord* results) {
  FramesByStamp frames;
  for (const rosbag::MessageInstance& entry : rosbag::View(bag, rosbag::TopicQuery("/pose"))) {
    const auto pose = messageOf<BodyPoseMsg>(entry);
    if (!pose || pose->body_id != results->body_id) continue;
    const int64_t stamp = nanosecondsOf(pose->header.stamp);
    ResultFrame& frame = frames[stamp];
    frame = {stamp, statusOf(*pose), pose->reason, {}};
    std::copy(pose->part_deviation.begin(), pose->part_deviation.end(), frame.part_sigma_m.begin());
    results->latencies.push_back(double(nanosecondsOf(entry.getTime()) - stamp) * 1e-9);
  }
  results->has_status = !frames.empty();
  if (!results->has_status)  // for other trackers, every transform counts as a pose
    for (const int64_t stamp : transforms.stampsOf(kRootLink + results->body_id))
      frames[stamp] = {stamp, FrameStatus::kTracked, "", {}};
  return frames;
}

/// Frames of all links in the world, which is the root of the first link's tree.
LinkPoses linkPoses(const BodyModel& body, const StampedTransforms& transforms, int64_t stamp_ns,
                    std::string* world) {
  LinkPoses T_world_link;
  for (const std::string& link : body.links()) {
    const StampedTransforms::Place place = transforms.find(link, stamp_ns);
    if (world->empty()) *world = place.root;
    T_world_link.push_back(place.T_root_frame);
    if (place.root.empty() || place.root != *world) T_world_link.back().matrix().setConstant(NAN);
  }
  return T_world_link;
}

void addPose(const StampedTransforms& transforms, ResultFrame* frame, ResultRecord* results) {
  frame->T_world_link =
      linkPoses(*results->body, transforms, frame->stamp_ns, &results->world_frame);
  Eigen::Matrix3Xd points = bodyPoints(*results->body, frame->T_world_link);
  if (!results->has_description) points.rightCols(tipNames().size()).setConstant(NAN);
  results->joints.add(frame->stamp_ns, points);
}

void readAngles(rosbag::Bag& bag, const FramesByStamp& frames, ResultRecord* results) {
  std::map<int64_t, AngleFrame> angles;
  const rosbag::TopicQuery topic(ofBody(results->body_id, "joint_states"));
  for (const rosbag::MessageInstance& entry : rosbag::View(bag, topic)) {
    const auto states = messageOf<sensor_msgs::JointState>(entry);
    if (!states) continue;
    const int64_t stamp = nanosecondsOf(states->header.stamp);
    const auto frame = frames.find(stamp);
    if (frame == frames.end() || frame->second.status == FrameStatus::kLost) continue;
    angles[stamp].stamp_ns = stamp;
    for (size_t i = 0; i < std::min(states->name.size(), states->position.size()); ++i)
      angles[stamp].angles[withoutId(states->name[i])] = states->position[i];
  }
  for (auto& entry : angles) results->angles.push_back(std::move(entry.second));
}

}  // namespace

std::string withoutId(const std::string& name) {
  return name.substr(0, name.rfind('_'));
}

ResultRecord readResults(const std::string& path, const std::string& id, const std::string& urdf) {
  rosbag::Bag bag;
  openForReading(path, bag);
  const StampedTransforms transforms = readTransforms(bag);
  ResultRecord results;
  results.body_id = chooseBody(bodiesIn(bag, transforms), id, path, bag);
  results.joints.names = bodyPointNames();
  readBody(bag, urdf, &results);
  FramesByStamp frames = readStatuses(bag, transforms, &results);
  readAngles(bag, frames, &results);
  for (auto& entry : frames) {
    if (entry.second.status != FrameStatus::kLost) addPose(transforms, &entry.second, &results);
    results.frames.push_back(std::move(entry.second));
  }
  return results;
}

}  // namespace markerless_mocap
