// What the thread of FittingStage does with the frame sets.
#include <ros/console.h>

#include <cstdlib>
#include <exception>
#include <stdexcept>

#include "markerless_mocap/tracking/shape_file.h"
#include "nodes/pose_fitting/fitting_stage.h"
#include "nodes/pose_fitting/tracker_update.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"
#include "ros/package_files.h"
#include "tracking/calibration_scale.h"

namespace markerless_mocap {

void FittingStage::work() {
  while (std::optional<FittingMessages> input = queue_.take()) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!runs_) {
      status_.ok("stopped by the service set_running");
      const std::lock_guard announcing(announcing_);
      answers_.take(input->header);
      continue;
    }
    backlog_.begin(queue_.waitingCount(), ros::SteadyTime::now().toSec());
    input->behind = [this] { return backlog_.isBehind(queue_.waitingCount()); };
    fit(*input);
    if (queue_.waitingCount() <= kNewest) searches_ = false;
  }
}

void FittingStage::fit(const FittingMessages& message) {
  const ros::WallTime start = ros::WallTime::now();
  const auto report = [&](const BodyPose& pose) {
    const double fitting = (ros::WallTime::now() - start).toSec();
    if (tracker_ && tracker_->body() != body_) takeOver(tracker_->body());
    if (answer(pose, message)) reportTimes(fitting);
  };
  try {
    if (!message.error.empty()) throw std::invalid_argument(message.error);
    const int64_t stamp_ns = steadyStamp(message);
    const FittingMessages input = believed(message);
    prepareTracker(input, stamp_ns);
    const BodyPose pose = updated(*tracker_, withoutChangedCameras(input, *rig_),
                                  inputs_->products(), stamp_ns, needs_.images, report);
    inputs_->wantColors(tracker_->wantedImages());
    follows_ = pose.status != PoseStatus::kLost;
    if (follows_) last_fitted_ = pose;
  } catch (const std::exception& error) {
    follows_ = false;
    BodyPose lost;
    lost.reason = error.what();
    report(lost);
  }
}

int64_t FittingStage::steadyStamp(const FittingMessages& input) {
  const SteadyTime::Moment now = time_.at(nanosecondsOf(input.header.stamp), input.arrival_ns);
  if (now.set_by_ns != 0)
    status_.remark("the clock was set " + std::string(now.set_by_ns < 0 ? "back" : "ahead") +
                   " by " + std::to_string(std::abs(now.set_by_ns) / 1'000'000) +
                   " ms, the person is followed on");
  if (now.after_pause) follows_ = false;  // the cameras may have moved meanwhile
  return now.time_ns;
}

FittingMessages FittingStage::believed(const FittingMessages& input) {
  RigTrust::Evidence evidence{[&input](size_t camera) { return maskOrNothing(input, camera); }, {}};
  if (follows_) evidence.joints = jointsOf(*body_->model, last_fitted_);
  const RigTrust::RigPointer rig = trust_.rigFor(input.rig, evidence);
  for (size_t i = 0; i < rig->size(); ++i)
    if (trust_.isRefused(i))
      status_.remark("the person is seen elsewhere by " + (*rig)[i].name() +
                     " than its new camera_info or pose says, it is left out until both agree");
  FittingMessages believed = withoutChangedCameras(input, *rig);
  believed.rig = rig;
  return believed;
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
  if (!next) next = makeBodyTracker(*input.rig, resources_, options_);
  useTracker(std::move(next), input.rig);
}

void FittingStage::useTracker(std::shared_ptr<BodyTracker> tracker,
                              std::shared_ptr<const CameraRig> rig) {
  tracker_ = std::move(tracker);
  rig_ = std::move(rig);
  const std::lock_guard lock(preparing_);
  prepares_ = tracker_;
}

// While frame sets wait, the next mask would come before this one is used.
cv::Mat FittingStage::readMask(size_t camera, const sensor_msgs::Image& message) {
  if (queue_.waitingCount() > 0) return cv::Mat();
  const cv::Mat mask = maskFromMessage(message);
  std::shared_ptr<const BodyTracker> tracker;
  {
    const std::lock_guard lock(preparing_);
    tracker = prepares_;
  }
  if (tracker) tracker->prepare(camera, mask);
  return mask;
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

void FittingStage::reportTimes(double fitting) {
  fitting_times_.add(ros::SteadyTime::now().toSec(), fitting);
  status_.set("fitting, median ms", fitting_times_.milliseconds(0.5));
  status_.set("fitting, 99 % within ms", fitting_times_.milliseconds(0.99));
  status_.set("frame sets dropped for newer ones", queue_.droppedCount());
}

}  // namespace markerless_mocap
