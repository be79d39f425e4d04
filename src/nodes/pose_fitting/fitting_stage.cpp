#include "nodes/pose_fitting/fitting_stage.h"

#include <ros/console.h>
#include <sensor_msgs/JointState.h>

#include <exception>
#include <stdexcept>

#include "markerless_mocap/tracking/shape_file.h"
#include "nodes/common/low_latency_transport.h"
#include "nodes/common/publish_shared.h"
#include "nodes/pose_fitting/tracker_update.h"
#include "ros/body_markers.h"
#include "ros/camera_conversions.h"
#include "ros/package_files.h"
#include "ros/pose_conversions.h"
#include "tracking/calibration_scale.h"

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
constexpr double kLargestLeap = 1e-9 * double(kLongGap_ns);  // s, over it no pose is doubted
constexpr double kSmallLeap = 0.1;                           // s, a tracker hardly notices it
constexpr size_t kNewest = 3;                                // of which none is left out
constexpr int64_t kLargestStep = 2'000'000'000;              // ns
constexpr int64_t kLargestPeriod = 500'000'000;              // ns
constexpr double kLongestSilence = 2.0;  // s of the wall clock, then nobody is announced

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
      node_options_(node_options),
      resources_(resourcesOf(node_options)),
      status_(handle, private_handle, "pose fitting"),
      description_(node_options.body_id),
      announcer_(handle, node_options.body_id),
      queue_(needsOf(options.method).images ? kMaxWaitingWithImages : kMaxWaiting) {
  if (needsOf(options_.method).masks) node_options_.requireCameras();
  if (node_options_.privacy) forgoImages(options_.method);
  takeOver(initialBody(resources_, options_.person.stature));
  joint_states_ = handle.advertise<sensor_msgs::JointState>(
      "/humans/bodies/" + node_options_.body_id + "/joint_states", kPublisherQueue);
  pose_ = handle.advertise<BodyPoseMsg>("pose", kPublisherQueue);
  markers_ = handle.advertise<visualization_msgs::MarkerArray>("pose/body", 4);
  text_ = handle.advertise<visualization_msgs::Marker>("pose/text", 4);
  if (needsOf(options_.method).masks && !node_options_.privacy)
    overlays_.emplace(handle, node_options_.cameras, node_options_.image_transport, &status_);
  inputs_ = std::make_unique<FittingInputs>(
      handle, node_options_, needsOf(options_.method), &status_,
      [this](FittingMessages input) { enqueue(std::move(input)); }, [this] { searches_ = true; });
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
  if (!needsOf(options_.method).images && queue_.waitingCount() >= kMaxWaitingWithImages)
    input.images.clear();
  answerLate(input.header);
  queue_.push(std::move(input));
  if (!needsOf(options_.method).starts_by_search) return;
  const double leap = searches_ ? kLargestLeap : kSmallLeap;
  queue_.thinOut(kNewest, [leap](const FittingMessages& one, const FittingMessages& other) {
    return (other.header.stamp - one.header.stamp).toSec() < leap;
  });
}

// Following takes less than a period, a search as long as many. While frame sets wait behind one,
// those that come are lost, and are told so at once.
void FittingStage::answerLate(const std_msgs::Header& newest) {
  const std::lock_guard lock(announcing_);
  answers_.await(newest);
  if (!searches_ || !needsOf(options_.method).starts_by_search) return;
  BodyPose lost;
  lost.reason = "the person is being searched for";
  while (const std::optional<std_msgs::Header> late = answers_.takeLate(kMaxLate))
    publish(lost, *late);
}

void FittingStage::work() {
  while (std::optional<FittingMessages> input = queue_.take()) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!runs_) {
      status_.ok("stopped by the service set_running");
      const std::lock_guard announcing(announcing_);
      answers_.take(input->header);
      continue;
    }
    input->behind = queue_.waitingCount() > kNewest;
    const ros::WallTime start = ros::WallTime::now();
    const BodyPose pose = fit(*input);
    const double fitting = (ros::WallTime::now() - start).toSec();
    if (tracker_ && tracker_->body() != body_) takeOver(tracker_->body());
    if (answer(pose, *input)) reportTimes(fitting);
    if (queue_.waitingCount() <= kNewest) searches_ = false;
  }
}

BodyPose FittingStage::fit(const FittingMessages& input) {
  try {
    if (!input.error.empty()) throw std::invalid_argument(input.error);
    const int64_t stamp_ns = steadyStamp(input.header.stamp);
    prepareTracker(input, stamp_ns);
    const BodyPose pose = updated(*tracker_, withoutChangedCameras(input, *rig_),
                                  inputs_->products(), stamp_ns, needsOf(options_.method).images);
    follows_ = pose.status != PoseStatus::kLost;
    return pose;
  } catch (const std::exception& error) {
    follows_ = false;
    BodyPose lost;
    lost.reason = error.what();
    return lost;
  }
}

// A small step back is a clock that was set, while the person goes on; after a large one, as of a
// bag that begins again, the tracker starts anew.
int64_t FittingStage::steadyStamp(const ros::Time& stamp) {
  const int64_t stamp_ns = nanosecondsOf(stamp);
  const int64_t back_ns = last_stamp_ns_ - stamp_ns;
  if (back_ns > kLargestStep) shift_ns_ = 0;
  if (back_ns > 0 && back_ns <= kLargestStep) {
    shift_ns_ += back_ns + period_ns_;
    status_.remark("the clock was set back by " + std::to_string(back_ns / 1'000'000) +
                   " ms, the person is followed on");
  }
  if (back_ns < 0 && back_ns > -kLargestPeriod) period_ns_ = -back_ns;
  if (back_ns <= -kLargestPeriod) follows_ = false;  // the cameras may have moved meanwhile
  last_stamp_ns_ = stamp_ns;
  return stamp_ns + shift_ns_;
}

void FittingStage::prepareTracker(const FittingMessages& input, int64_t stamp_ns) {
  if (tracker_ && input.rig == rig_) return successor_.forget();
  if (body_->shape_estimated) resources_.known_shape = body_->shape;
  std::unique_ptr<BodyTracker> next;
  if (tracker_ && follows_) {
    next = successor_.look(
        input.rig,
        [rig = input.rig, resources = resources_, options = options_] {
          return makeBodyTracker(*rig, resources, options);
        },
        [this, input, stamp_ns, images = needsOf(options_.method).images](BodyTracker& tracker) {
          return updated(tracker, input, inputs_->products(), stamp_ns, images);
        });
    if (!next) return;
  } else {
    next = successor_.takeOf(input.rig);
  }
  searches_ = true;  // making a tracker takes long, too
  tracker_ = next ? std::move(next) : makeBodyTracker(*input.rig, resources_, options_);
  rig_ = input.rig;
}

void FittingStage::takeOver(const std::shared_ptr<const TrackedBody>& body) {
  const bool newly_measured = body->shape_estimated && !resources_.known_shape;
  {
    const std::lock_guard lock(announcing_);
    body_ = body;
    filter_ = makePoseFilter(body_->model, options_.filter);
    announcer_.announce(false, ros::Time::now());
    description_.set(*body_);
  }
  if (!newly_measured) return;
  ROS_INFO("pose fitting: the body has been measured, its stature is %.2f m",
           statureOf(body_->shape));
  const std::string scale = scaleFinding(statureOf(body_->shape));
  if (!scale.empty()) ROS_WARN("pose fitting: %s", scale.c_str());
  resources_.known_shape = body_->shape;
  saveBody();
}

void FittingStage::saveBody() {
  if (node_options_.body_file.empty()) return;
  try {
    writeBodyFile(node_options_.body_file, body_->shape);
  } catch (const std::exception& error) {
    ROS_ERROR_STREAM("pose fitting: " << error.what());
  }
}

void FittingStage::display(const BodyPose& pose, const FittingMessages& input) {
  const BodyModel& model = *body_->model;
  if (markers_.getNumSubscribers() > 0) markers_.publish(bodyMarkers(model, pose, input.header));
  if (text_.getNumSubscribers() > 0)
    text_.publish(poseTextMarker(model, pose, input.header, &last_head_));
  if (overlays_ && overlays_->isWanted()) overlays_->show({body_, pose, input.rig, input.masks});
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
      filter_ ? filter_->filtered(nanosecondsOf(header.stamp) + shift_ns_, raw) : raw;
  const bool tracked = pose.status != PoseStatus::kLost;
  answered_lost_ = !tracked;
  last_published_ = ros::WallTime::now();
  status_.count(toString(pose.status));
  last_pose_ns_ = nanosecondsOf(header.stamp);
  if (tracked) {
    last_tracked_ns_ = nanosecondsOf(header.stamp);
    description_.restore();
    joint_states_.publish(jointStateFromPose(model, pose, header));
    broadcaster_.sendTransform(linkTransforms(model, pose, header));
    status_.ok(pose.reason.empty() ? "the person is tracked" : pose.reason);
  } else {
    status_.problem(pose.reason);
  }
  announce(tracked, header.stamp);
  publishShared(pose_, messageFromPose(model, raw, header));
  status_.sent(header.stamp);
  return pose;
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
  if ((ros::WallTime::now() - last_published_).toSec() > kLongestSilence)
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
  heartbeat_.publish(message);
}

void FittingStage::reportTimes(double fitting) {
  fitting_times_.add(ros::SteadyTime::now().toSec(), fitting);
  status_.set("fitting, median ms", fitting_times_.milliseconds(0.5));
  status_.set("fitting, 99 % within ms", fitting_times_.milliseconds(0.99));
  status_.set("frame sets dropped for newer ones", queue_.droppedCount());
}

}  // namespace markerless_mocap
