// With every pose: how far the nearest hand of anybody is from a frame of the robot, how sure that
// is, how fast it comes, and if this is near enough to stop. See README.md; this is no safety
// function.
#include <geometry_msgs/TransformStamped.h>
#include <nearest_hand/HandDistance.h>
#include <ros/ros.h>
#include <tf2_eigen/tf2_eigen.h>
#include <tf2_ros/transform_listener.h>
#include <visualization_msgs/Marker.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>

#include "hand.h"
#include "markerless_mocap/ros/messages.h"
#include "options.h"

using markerless_mocap::BodyPoseMsg;
using nearest_hand::HandDistance;

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr double kLongestWaitForTf = 0.2;  // s of the wall clock
constexpr size_t kTorso = 0;               // index in BodyPose.part_deviation

struct Arm {
  const char *hand, *part, *wrist;
  size_t index;  // in BodyPose.part_deviation
};
constexpr Arm kArms[] = {{"left", "l_arm", "l_wrist_", 2}, {"right", "r_arm", "r_wrist_", 3}};

/// Of hands whose distance or error is not known, and of all others, which one matters.
bool outweighs(const HandDistance& a, const HandDistance& b) {
  const double a_certain = a.distance - a.margin, b_certain = b.distance - b.margin;
  return std::isnan(a_certain) || (!std::isnan(b_certain) && a_certain < b_certain);
}

}  // namespace

class NearestHand {
 public:
  NearestHand(ros::NodeHandle& handle, const Options& options)
      : options_(options),
        distance_(handle.advertise<HandDistance>("hand_distance", 10)),
        marker_(handle.advertise<visualization_msgs::Marker>("hand_distance/marker", 10)) {
    for (const std::string& topic : options_.poses)
      subscribers_.push_back(handle.subscribe(topic, 30, &NearestHand::add, this));
    timer_ = handle.createWallTimer(ros::WallDuration(0.005), &NearestHand::work, this);
  }

 private:
  struct Waiting {
    BodyPoseMsg::ConstPtr pose;
    ros::WallTime since;
  };
  struct Body {
    HandDistance nearest;  // as of the last pose; stop and protective_distance are not yet set
    ros::WallTime heard;
    std::map<std::string, ClosingSpeed> speeds;  // by hand
  };

  void add(const BodyPoseMsg::ConstPtr& pose) {
    waiting_.push_back({pose, ros::WallTime::now()});
    work(ros::WallTimerEvent());
  }

  // tf may come later than the pose of the same stamp. Waiting in a callback would keep the node
  // from telling that nothing comes.
  void work(const ros::WallTimerEvent&) {
    while (!waiting_.empty()) {
      const Waiting next = waiting_.front();
      const bool tired = (ros::WallTime::now() - next.since).toSec() > kLongestWaitForTf;
      std::string lack;
      if (!framesAreThere(*next.pose, &lack) && !tired) break;
      waiting_.pop_front();
      update(*next.pose, lack);
      publish(next.pose->header.stamp);
    }
    if ((ros::WallTime::now() - published_).toSec() > options_.max_age) publish(ros::Time::now());
  }

  bool isNotSeen(const BodyPoseMsg& pose, const std::string& part) const {
    const auto& parts = pose.parts_not_seen;
    return std::find(parts.begin(), parts.end(), part) != parts.end();
  }

  std::vector<std::string> framesOf(const BodyPoseMsg& pose) const {
    std::vector<std::string> frames;
    if (pose.status == BodyPoseMsg::LOST) return frames;
    frames.push_back("torso_" + pose.body_id);
    for (const Arm& arm : kArms)
      if (!isNotSeen(pose, arm.part)) frames.push_back(arm.wrist + pose.body_id);
    return frames;
  }

  bool framesAreThere(const BodyPoseMsg& pose, std::string* lack) {
    for (const std::string& frame : framesOf(pose))
      if (!buffer_.canTransform(options_.robot_frame, frame, pose.header.stamp, lack)) return false;
    return true;
  }

  Eigen::Isometry3d robotFrom(const std::string& frame, const ros::Time& stamp) {
    return tf2::transformToEigen(buffer_.lookupTransform(options_.robot_frame, frame, stamp));
  }

  void update(const BodyPoseMsg& pose, const std::string& lack) {
    Body& body = bodies_[pose.body_id];
    if (pose.status != BodyPoseMsg::TRACKED || pose.header.stamp < body.nearest.header.stamp)
      body.speeds.clear();
    body.heard = ros::WallTime::now();
    body.nearest = unknown(HandDistance::LOST, lack);
    body.nearest.header.stamp = pose.header.stamp;
    body.nearest.body_id = pose.body_id;
    if (pose.status == BodyPoseMsg::LOST) body.nearest.reason = pose.body_id + ": " + pose.reason;
    if (pose.status != BodyPoseMsg::LOST && lack.empty()) measure(pose, &body);
  }

  void measure(const BodyPoseMsg& pose, Body* body) {
    HandDistance nearest;
    nearest.distance = std::numeric_limits<double>::infinity();
    for (const Arm& arm : kArms) {
      HandDistance hand = isNotSeen(pose, arm.part) ? unseenHand(pose, arm) : seenHand(pose, arm);
      hand.closing_speed = kUnknown;
      if (hand.state == HandDistance::KNOWN)
        hand.closing_speed = body->speeds[arm.hand].add(pose.header.stamp.toSec(), hand.distance);
      else
        body->speeds.erase(arm.hand);
      if (outweighs(hand, nearest)) nearest = hand;
    }
    nearest.header.stamp = pose.header.stamp;
    nearest.body_id = pose.body_id;
    body->nearest = nearest;
  }

  HandDistance seenHand(const BodyPoseMsg& pose, const Arm& arm) {
    const Eigen::Isometry3d T_robot_wrist = robotFrom(arm.wrist + pose.body_id, pose.header.stamp);
    const Eigen::Vector3d tips = T_robot_wrist * Eigen::Vector3d(0, 0, -options_.hand_length);
    const Eigen::Vector3d nearest = nearestToOrigin(T_robot_wrist.translation(), tips);
    return handAt(HandDistance::KNOWN, arm, nearest, nearest.norm(),
                  pose.part_deviation[arm.index]);
  }

  /// The hand of an arm that is not seen may be wherever it reaches.
  HandDistance unseenHand(const BodyPoseMsg& pose, const Arm& arm) {
    const Eigen::Vector3d chest =
        robotFrom("torso_" + pose.body_id, pose.header.stamp).translation();
    const double distance = std::max(0.0, chest.norm() - options_.reach);
    const Eigen::Vector3d nearest = chest.norm() > 0 ? chest.normalized() * distance : chest;
    HandDistance hand =
        handAt(HandDistance::UNSEEN, arm, nearest, distance, pose.part_deviation[kTorso]);
    hand.reason = pose.body_id + ": the " + arm.hand + " arm is not seen";
    return hand;
  }

  HandDistance handAt(uint8_t state, const Arm& arm, const Eigen::Vector3d& point, double distance,
                      double expected_error) const {
    HandDistance hand;
    hand.state = state;
    hand.hand = arm.hand;
    hand.point = tf2::toMsg(point);
    hand.distance = distance;
    hand.margin = options_.margin_deviations * expected_error;
    return hand;
  }

  HandDistance unknown(uint8_t state, const std::string& reason) const {
    HandDistance message;
    message.state = state;
    message.reason = reason;
    message.point.x = message.point.y = message.point.z = kUnknown;
    message.distance = message.margin = message.closing_speed = kUnknown;
    return message;
  }

  /// Of all bodies; a body of which nothing is known outweighs a hand that is far away.
  HandDistance nearestOfAll() const {
    if (bodies_.size() < options_.poses.size())
      return unknown(HandDistance::LOST,
                     "no pose has come yet from " +
                         std::to_string(options_.poses.size() - bodies_.size()) +
                         " of the trackers");
    HandDistance nearest = bodies_.begin()->second.nearest;
    for (const auto& [id, body] : bodies_) {
      const std::string stale = whyStale(id, body);
      if (!stale.empty()) return unknown(HandDistance::STALE, stale);
      if (outweighs(body.nearest, nearest)) nearest = body.nearest;
    }
    return nearest;
  }

  std::string whyStale(const std::string& id, const Body& body) const {
    const double silence = (ros::WallTime::now() - body.heard).toSec();
    const double age = (ros::Time::now() - body.nearest.header.stamp).toSec();
    if (silence > options_.max_age) return "no pose of " + id + " for " + text(silence) + " s";
    if (age > options_.max_age) return "the pose of " + id + " is " + text(age) + " s old";
    if (age < -options_.max_age)
      return "the stamps of " + id + " are " + text(-age) + " s ahead of this machine's clock";
    return "";
  }

  static std::string text(double seconds) {
    char digits[32];
    snprintf(digits, sizeof digits, "%.2f", seconds);
    return digits;
  }

  void publish(const ros::Time& stamp) {
    published_ = ros::WallTime::now();
    HandDistance message = nearestOfAll();
    const double age =
        message.body_id.empty() ? 0.0 : (ros::Time::now() - message.header.stamp).toSec();
    message.header.stamp = stamp;
    message.header.frame_id = options_.robot_frame;
    message.protective_distance = protectiveDistance(message.closing_speed, std::max(0.0, age));
    const double certain = message.distance - message.margin;
    message.time_to_contact = timeToContact(certain, message.closing_speed);
    // NaN, of an unknown distance or error, stops.
    message.stop = message.state == HandDistance::LOST || message.state == HandDistance::STALE ||
                   !(certain >= message.protective_distance);
    distance_.publish(message);
    if (marker_.getNumSubscribers() > 0) marker_.publish(markerOf(message));
  }

  /// S_h + S_r + S_s + C + Z_r of ISO/TS 15066; Z_d is the margin. What is measured is `age` s old.
  /// A hand that rests may be fast a moment later: its measured speed never makes the distance
  /// smaller.
  double protectiveDistance(double closing_speed, double age) const {
    const Options& o = options_;
    const double human = std::fmax(o.human_speed, closing_speed);  // the other one if it is NaN
    const double reaction = age + o.reaction_time;
    return human * (reaction + o.stopping_time) + o.robot_speed * reaction + o.stopping_distance +
           o.intrusion_distance + o.robot_error;
  }

  visualization_msgs::Marker markerOf(const HandDistance& message) const {
    visualization_msgs::Marker line;
    line.header = message.header;
    line.ns = "nearest_hand";
    line.type = visualization_msgs::Marker::LINE_LIST;
    line.pose.orientation.w = 1.0;
    line.action = std::isnan(message.distance) ? visualization_msgs::Marker::DELETE
                                               : visualization_msgs::Marker::ADD;
    line.scale.x = 0.02;
    line.color.a = 1.0f;
    (message.stop ? line.color.r : line.color.g) = 1.0f;
    line.points = {geometry_msgs::Point(), message.point};
    return line;
  }

  Options options_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_{buffer_};
  ros::Publisher distance_, marker_;
  std::vector<ros::Subscriber> subscribers_;
  std::deque<Waiting> waiting_;
  std::map<std::string, Body> bodies_;  // by id, all that were ever heard of
  ros::WallTime published_;
  ros::WallTimer timer_;
};

int main(int argc, char** argv) try {
  ros::init(argc, argv, "nearest_hand");
  ros::NodeHandle handle;
  NearestHand node(handle, readOptions(ros::NodeHandle("~")));
  ros::spin();
} catch (const std::exception& error) {
  ROS_FATAL("nearest_hand: %s", error.what());
  return 1;
}
