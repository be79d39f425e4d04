#include "nodes/pose_fitting/fitting_stage.h"

#include <ros/console.h>
#include <sensor_msgs/JointState.h>

#include <exception>
#include <stdexcept>

#include "nodes/common/low_latency_transport.h"
#include "nodes/common/publish_shared.h"
#include "nodes/pose_fitting/body_pictures.h"
#include "ros/body_markers.h"
#include "ros/camera_conversions.h"
#include "ros/package_files.h"
#include "ros/pose_conversions.h"

namespace markerless_mocap {
namespace {

// Frame sets that wait, 3 s at 30 per second. All of them are processed, but for those behind a
// search, because each pose depends on the last one; a gap would need another search. Fewer if a
// frame set contains images (10 MB). Where images are used for their colours only, those behind
// that many frame sets go without.
constexpr size_t kMaxWaiting = 90, kMaxWaitingWithImages = 40;

constexpr size_t kMaxLate = 2;  // frame sets behind a search that may still be answered in time
// Of the frame sets that wait, those are kept that lead from the last pose to the newest ones: few
// of those behind a search, more where fitting is slower than the cameras.
constexpr int64_t kLargestLeap_ns = kLongGap_ns;  // over it no pose is doubted
constexpr int64_t kSmallLeap_ns = 100'000'000;    // a tracker hardly notices it
constexpr double kLongestSilence = 2.0;           // s of the wall clock, then nobody is announced

PersonResources resourcesOf(const FittingNodeOptions& options) {
  PersonResources resources = readPersonResources(
      options.body_id, options.urdf_template, isThere(options.body_file) ? options.body_file : "");
  resources.in_background = true;
  return resources;
}

/// Tells what goes without images. Throws std::invalid_argument if the method cannot.
void forgoImages(const std::string& method) {
  if (needsOf(method).images)
    throw std::invalid_argument("pose_fitting/method is \"" + method +
                                "\", which reads images, but privacy is true, allowed are methods "
                                "that need none, such as contour");
  ROS_INFO(
      "pose fitting: with privacy no image is read, so there are no overlays, and backgrounds have "
      "to be known");
}

}  // namespace

FittingStage::FittingStage(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                           const TrackerOptions& options, const FittingNodeOptions& node_options)
    : options_(options),
      needs_(needsOf(options.method)),
      node_options_(node_options),
      resources_(resourcesOf(node_options)),
      status_(handle, private_handle, "pose fitting"),
      description_(node_options.body_id),
      announcer_(handle, node_options.body_id),
      queue_(needsOf(options.method).images ? kMaxWaitingWithImages : kMaxWaiting) {
  if (needs_.masks) node_options_.requireCameras();
  if (node_options_.privacy) forgoImages(options_.method);
  takeOver(initialBody(resources_, options_.person.stature));
  joint_states_ = handle.advertise<sensor_msgs::JointState>(
      "/humans/bodies/" + node_options_.body_id + "/joint_states", kPublisherQueue);
  pose_ = handle.advertise<BodyPoseMsg>("pose", kPublisherQueue);
  markers_ = handle.advertise<visualization_msgs::MarkerArray>("pose/body", 4);
  text_ = handle.advertise<visualization_msgs::Marker>("pose/text", 4);
  if (needs_.masks) advertisePictures(handle);
  inputs_ = std::make_unique<FittingInputs>(
      handle, node_options_, needs_, &status_,
      [this](FittingMessages input) { enqueue(std::move(input)); },
      [this](size_t camera, const sensor_msgs::Image& mask) { return readMask(camera, mask); },
      [this] { searches_ = true; });
  heartbeat_ = handle.advertise<MocapStatus>("pose/status", 4);
  worker_ = std::thread([this] { runOrEndProcess("pose fitting", [this] { work(); }); });
  timer_ = handle.createWallTimer(ros::WallDuration(1.0),
                                  gate_.guarded([this](const ros::WallTimerEvent&) { beat(); }));
  live_.emplace(private_handle, options_, TrackerOptions::fixedKeys(),
                [this](const TrackerOptions& changed) { apply(changed); });
  services_.emplace(private_handle);
  advertiseServices();
}

FittingStage::~FittingStage() {
  timer_.stop();
  gate_.close();
  services_.reset();
  live_.reset();
  queue_.close();
  inputs_->products().close();
  worker_.join();
  successor_.forget();
  inputs_.reset();
}

void FittingStage::enqueue(FittingMessages input) {
  if (!needs_.images && queue_.waitingCount() >= kMaxWaitingWithImages) input.images.clear();
  answerLate(input.header);
  queue_.push(std::move(input));
  if (!needs_.starts_by_search) return;
  const int64_t leap_ns = searches_ ? kLargestLeap_ns : kSmallLeap_ns;
  queue_.thinOut(kNewest, [leap_ns](const FittingMessages& one, const FittingMessages& other) {
    return isWithin(leap_ns, nanosecondsOf(one.header.stamp), nanosecondsOf(other.header.stamp));
  });
}

// Following takes less than a period, a search as long as many. While frame sets wait behind one,
// those that come are lost, and are told so at once.
void FittingStage::answerLate(const std_msgs::Header& newest) {
  const std::lock_guard lock(announcing_);
  answers_.await(newest);
  if (!searches_ || !needs_.starts_by_search) return;
  BodyPose lost;
  lost.reason = "the person is being searched for";
  while (const std::optional<std_msgs::Header> late = answers_.takeLate(kMaxLate))
    publish(lost, *late);
}

void FittingStage::advertisePictures(ros::NodeHandle& handle) {
  const CameraPictures::Source source{node_options_.cameras, node_options_.image_transport,
                                      !node_options_.privacy};
  if (source.reads_images)
    pictures_.push_back(
        std::make_unique<CameraPictures>(handle, "overlay", source, &status_, overlayOf));
  pictures_.push_back(
      std::make_unique<CameraPictures>(handle, "person", source, &status_, personMaskOf));
}

void FittingStage::display(const BodyPose& pose, const FittingMessages& input) {
  const BodyModel& model = *body_->model;
  if (markers_.getNumSubscribers() > 0) markers_.publish(bodyMarkers(model, pose, input.header));
  if (text_.getNumSubscribers() > 0)
    text_.publish(poseTextMarker(model, pose, input.header, &last_head_));
  for (const auto& pictures : pictures_)
    if (pictures->isWanted()) pictures->show({body_, pose, input.rig, input.masks});
}

bool FittingStage::answer(const BodyPose& raw, const FittingMessages& input) {
  const std::lock_guard lock(announcing_);
  if (!answers_.take(input.header)) return false;
  BodyPose pose = raw;
  // The pose of the start may have come too late.
  if (answered_lost_ && raw.status == PoseStatus::kTracked)
    pose.status = PoseStatus::kReinitialized;
  display(publish(pose, input.header), input);
  return true;
}

BodyPose FittingStage::publish(const BodyPose& raw, const std_msgs::Header& header) {
  const BodyModel& model = *body_->model;
  const BodyPose pose =
      filter_ ? filter_->filtered(time_.timeOf(nanosecondsOf(header.stamp)), raw) : raw;
  const bool tracked = pose.status != PoseStatus::kLost;
  answered_lost_ = !tracked;
  last_published_ = ros::SteadyTime::now();
  status_.count(toString(pose.status));
  last_pose_ns_ = nanosecondsOf(header.stamp);
  if (tracked) {
    last_tracked_ns_ = nanosecondsOf(header.stamp);
    description_.restore();
    joint_states_.publish(jointStateFromPose(model, pose, header));
    broadcaster_.sendTransform(linkTransforms(model, pose, header));
    reportTracked(pose.reason.empty() ? "the person is tracked" : pose.reason);
  } else {
    status_.problem(pose.reason);
  }
  announce(tracked, header.stamp);
  publishShared(pose_, messageFromPose(model, raw, header));
  status_.sent(header.stamp);
  return pose;
}

void FittingStage::reportTracked(const std::string& reason) {
  const std::string lacking = inputs_->lackingCameras();
  if (lacking.empty())
    status_.ok(reason);
  else
    status_.waiting(reason + ", " + lacking);
}

// Who is told of a body finds its description and tf; these go after the body (REP-155). Before the
// first pose the description is there for RobotModel displays.
void FittingStage::announce(bool tracked, const ros::Time& stamp) {
  const bool lost = announcer_.isTracked() && !tracked;
  announcer_.announce(tracked, stamp);
  if (lost) description_.remove();
}

void FittingStage::checkAnnouncement() {
  const bool described = description_.isThere();
  const std::lock_guard lock(announcing_);
  if (!described) description_.forget();
  if (announcer_.isTracked()) description_.restore();
  if ((ros::SteadyTime::now() - last_published_).toSec() > kLongestSilence)
    announce(false, ros::Time::now());
}

void FittingStage::beat() {
  inputs_->products().rest();
  checkAnnouncement();
  MocapStatus message;
  message.header.stamp = ros::Time::now();
  message.header.frame_id = node_options_.world_frame;
  message.body_id = node_options_.body_id;
  const StageStatus::Summary summary = status_.summary();
  message.level = summary.level;
  message.message = summary.message;
  message.last_pose = rosTime(last_pose_ns_);
  message.last_tracked = rosTime(last_tracked_ns_);
  inputs_->describeCameras(&message);
  for (size_t i = 0; i < message.used.size(); ++i)
    if (trust_.isRefused(i)) {
      message.used[i] = false;
      message.reasons[i] = "its images do not agree with its new camera_info or pose";
    }
  heartbeat_.publish(message);
}

}  // namespace markerless_mocap
