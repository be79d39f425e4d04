// An arm of a robot does what a person's arm does, as far as the robot's limits and rates allow. It
// stops when the arm is not seen, the person is lost, or poses do not come or are old. See
// README.md.
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Bool.h>
#include <tf2_eigen/tf2_eigen.h>
#include <tf2_ros/transform_listener.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "arm_chain.h"
#include "markerless_mocap/ros/messages.h"

using markerless_mocap::BodyPoseMsg;

namespace {

struct Options {
  std::string body_id = "person1";
  std::string side = "right";  // arm of the person
  bool mirror = true;          // left and right, as for somebody who faces the robot
  double max_age = 0.3;        // of a pose, s
  double rate = 100.0;         // of commands, 1/s
  double acceleration = 10.0;  // of every joint, rad/s^2
  std::string shoulder_link = "upper_arm", elbow_link = "forearm", tip_link = "tip";
};

Options readOptions(const ros::NodeHandle& handle) {
  Options o;
  handle.getParam("body_id", o.body_id);
  handle.getParam("side", o.side);
  handle.getParam("mirror", o.mirror);
  handle.getParam("max_age", o.max_age);
  handle.getParam("rate", o.rate);
  handle.getParam("acceleration", o.acceleration);
  handle.getParam("shoulder_link", o.shoulder_link);
  handle.getParam("elbow_link", o.elbow_link);
  handle.getParam("tip_link", o.tip_link);
  if (o.side != "left" && o.side != "right") throw std::invalid_argument("side: left or right");
  for (const double value : {o.max_age, o.rate, o.acceleration})
    if (!(value > 0.0 && std::isfinite(value)))
      throw std::invalid_argument("max_age, rate and acceleration must be above 0");
  return o;
}

std::string robotDescription() {
  std::string urdf;
  if (!ros::param::get("robot_description", urdf))
    throw std::invalid_argument("there is no parameter robot_description");
  return urdf;
}

}  // namespace

class MirrorArm {
 public:
  MirrorArm(ros::NodeHandle& handle, const Options& options)
      : options_(options),
        arm_(robotDescription(), options.shoulder_link, options.elbow_link, options.tip_link),
        angles_(arm_.clamped(Eigen::VectorXd::Zero(long(arm_.joints().size())))),
        velocities_(Eigen::VectorXd::Zero(angles_.size())),
        target_(angles_),
        commands_(handle.advertise<sensor_msgs::JointState>("joint_states", 10)),
        following_(handle.advertise<std_msgs::Bool>("following", 1, true)),
        poses_(handle.subscribe("pose", 30, &MirrorArm::takePose, this)),
        timer_(handle.createTimer(ros::Duration(1.0 / options.rate), &MirrorArm::step, this)) {
    tell(false);
  }

 private:
  void takePose(const BodyPoseMsg::ConstPtr& pose) {
    if (pose->body_id != options_.body_id) return;
    const auto& parts = pose->parts_not_seen;
    const std::string arm = options_.side.substr(0, 1) + "_arm";
    usable_ = pose->status != BodyPoseMsg::LOST &&
              std::find(parts.begin(), parts.end(), arm) == parts.end();
    newest_ = pose->header.stamp;
  }

  Eigen::Vector3d inTorso(const std::string& link) {
    const std::string side = options_.side.substr(0, 1) + "_";
    const Eigen::Vector3d place =
        tf2::transformToEigen(buffer_.lookupTransform("torso_" + options_.body_id,
                                                      side + link + "_" + options_.body_id,
                                                      newest_))
            .translation();
    return options_.mirror ? Eigen::Vector3d(place.x(), -place.y(), place.z()) : place;
  }

  /// tf comes on its own way, later or earlier than the pose of the same stamp.
  void takeTarget() {
    if (newest_ == target_stamp_) return;
    try {
      const Eigen::Vector3d elbow = inTorso("elbow");
      Eigen::Matrix<double, 6, 1> wanted;
      wanted << (elbow - inTorso("shoulder")).normalized(), (inTorso("wrist") - elbow).normalized();
      target_ = arm_.follow(wanted, target_);
      target_stamp_ = newest_;
    } catch (
        const tf2::TransformException&) {  // not yet: the last target counts until it is too old
    }
  }

  /// Of the target's stamp, which is the images': no new one, an old one and one of a clock that
  /// goes wrong are alike.
  bool isFresh(const ros::Time& now) const {
    return std::abs((now - target_stamp_).toSec()) <= options_.max_age;
  }

  void step(const ros::TimerEvent& event) {
    const double period = 1.0 / options_.rate;
    const double dt = std::clamp((event.current_real - event.last_real).toSec(), 0.0, 2.0 * period);
    if (usable_) takeTarget();
    const bool follow = usable_ && isFresh(event.current_real);
    for (long i = 0; i < angles_.size(); ++i) move(i, follow ? target_[i] - angles_[i] : 0.0, dt);
    if (follow != told_) tell(follow);
    publish(event.current_real);
  }

  /// \param way rad, still to go; 0 brakes
  void move(long i, double way, double dt) {
    const ArmChain::Joint& joint = arm_.joints()[size_t(i)];
    const double braking = std::sqrt(2.0 * options_.acceleration * std::abs(way));
    const double wanted = std::copysign(std::min(joint.velocity, braking), way);
    const double change = options_.acceleration * dt;
    velocities_[i] += std::clamp(wanted - velocities_[i], -change, change);
    const double next = angles_[i] + velocities_[i] * dt;
    angles_[i] = std::clamp(next, joint.lower, joint.upper);
    if (angles_[i] != next) velocities_[i] = 0.0;
  }

  void tell(bool follow) {
    told_ = follow;
    std_msgs::Bool message;
    message.data = follow;
    following_.publish(message);
    ROS_INFO("mirror_arm: %s", follow ? "follows" : "stopped, there is no fresh pose of the arm");
  }

  void publish(const ros::Time& stamp) {
    sensor_msgs::JointState state;
    state.header.stamp = stamp;
    for (const ArmChain::Joint& joint : arm_.joints()) state.name.push_back(joint.name);
    state.position.assign(angles_.data(), angles_.data() + angles_.size());
    state.velocity.assign(velocities_.data(), velocities_.data() + velocities_.size());
    commands_.publish(state);
  }

  Options options_;
  ArmChain arm_;
  Eigen::VectorXd angles_, velocities_, target_;
  ros::Time newest_, target_stamp_;  // of the last pose, and of target_
  bool usable_ = false, told_ = false;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_{buffer_};
  ros::Publisher commands_, following_;
  ros::Subscriber poses_;
  ros::Timer timer_;
};

int main(int argc, char** argv) try {
  ros::init(argc, argv, "mirror_arm");
  ros::NodeHandle handle;
  MirrorArm node(handle, readOptions(ros::NodeHandle("~")));
  ros::spin();
} catch (const std::exception& error) {
  ROS_FATAL("mirror_arm: %s", error.what());
  return 1;
}
