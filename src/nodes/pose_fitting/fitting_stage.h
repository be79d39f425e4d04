#pragma once

#include <ros/node_handle.h>
#include <tf2_ros/transform_broadcaster.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "markerless_mocap/pipeline/make_body_tracker.h"
#include "markerless_mocap/tracking/pose_filter.h"
#include "nodes/common/callback_gate.h"
#include "nodes/common/catch_up_queue.h"
#include "nodes/common/latency_meter.h"
#include "nodes/common/live_options.h"
#include "nodes/common/stage_services.h"
#include "nodes/common/stage_status.h"
#include "nodes/pose_fitting/answers.h"
#include "nodes/pose_fitting/backlog.h"
#include "nodes/pose_fitting/body_announcer.h"
#include "nodes/pose_fitting/body_description.h"
#include "nodes/pose_fitting/camera_pictures.h"
#include "nodes/pose_fitting/fitting_inputs.h"
#include "nodes/pose_fitting/steady_time.h"
#include "nodes/pose_fitting/tracker_successor.h"
#include "ros/node_options.h"
#include "tracking/rig_trust.h"

namespace markerless_mocap {

/// Tracks the person and publishes the body and its pose: raw on `pose`, filtered as tf,
/// joint_states and markers. It works in a thread of its own, so that callbacks do not wait.
/// Settings and services act between two frame sets.
class FittingStage {
 public:
  /// Throws std::invalid_argument or std::runtime_error as readPersonResources(), makeBodyTracker()
  /// and FittingNodeOptions::requireCameras(). \param private_handle of several threads
  FittingStage(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
               const TrackerOptions& options, const FittingNodeOptions& node_options);
  ~FittingStage();
  FittingStage(const FittingStage&) = delete;
  FittingStage& operator=(const FittingStage&) = delete;

 private:
  void enqueue(FittingMessages input);
  /// While the person is searched for, answers the frame sets that have waited too long.
  void answerLate(const std_msgs::Header& newest);
  void work();
  /// Fits the body to a frame set and answers it.
  void fit(const FittingMessages& message);
  /// The messages with the rig that is believed, without those of cameras that are not.
  FittingMessages believed(const FittingMessages& input);
  /// The tracker's time of a frame set.
  int64_t steadyStamp(const FittingMessages& input);
  /// Makes a tracker if there is none of the rig. While the old one follows the person, it goes on
  /// until the new one has found the person, too.
  void prepareTracker(const FittingMessages& input, int64_t stamp_ns);
  void useTracker(std::shared_ptr<BodyTracker> tracker, std::shared_ptr<const CameraRig> rig);
  /// Reads a mask, and lets the tracker begin with it while the others are on their way. Nothing is
  /// done, and nothing returned, while frame sets wait.
  cv::Mat readMask(size_t camera, const sensor_msgs::Image& message);
  /// Withdraws the announcement of the old body and publishes the description of the new one.
  void takeOver(const std::shared_ptr<const TrackedBody>& body);
  void saveBody();
  /// Starts again with this body.
  void restartWith(const std::shared_ptr<const TrackedBody>& body);
  void advertiseServices();
  void advertisePictures(ros::NodeHandle& handle);
  void apply(const TrackerOptions& options);
  /// What the services do; they return what was done, or throw why it cannot be done.
  std::string resetTracking();
  std::string measurePerson();
  std::string loadBody();
  std::string saveMeasuredBody();
  std::string setRunning(bool runs);
  /// Publishes and displays a pose, unless its frame set has been answered; then it returns false.
  bool answer(const BodyPose& raw, const FittingMessages& input);
  /// Needs announcing_. \return the filtered pose
  BodyPose publish(const BodyPose& raw, const std_msgs::Header& header);
  /// A person who is tracked without some camera is a warning.
  void reportTracked(const std::string& reason);
  /// Shows a pose to whoever looks on.
  void display(const BodyPose& pose, const FittingMessages& input);
  void announce(bool tracked, const ros::Time& stamp);
  /// Nobody is announced when no poses come, and nobody without a description.
  void checkAnnouncement();
  /// Publishes the state, also when no images come.
  void beat();
  void reportTimes(double fitting);

  static constexpr size_t kNewest = 3;  // frame sets that wait, of which none is left out

  std::mutex mutex_;  ///< held for a frame set, a service, a change of settings
  TrackerOptions options_;
  const TrackerNeeds needs_;  ///< of the method, which does not change
  FittingNodeOptions node_options_;
  PersonResources resources_;
  StageStatus status_;
  ros::Publisher joint_states_, pose_, markers_, text_, heartbeat_;
  tf2_ros::TransformBroadcaster broadcaster_;
  std::mutex announcing_;  ///< for the next seven
  Answers answers_;
  bool answered_lost_ = true;  ///< the last frame set
  BodyDescription description_;
  BodyAnnouncer announcer_;
  ros::SteadyTime last_published_;
  std::shared_ptr<const TrackedBody> body_;      ///< only the worker changes it
  std::optional<PoseFilter> filter_;             ///< for body_
  std::shared_ptr<const CameraRig> rig_;         ///< of tracker_
  std::shared_ptr<BodyTracker> tracker_;         ///< null until the rig is known
  std::mutex preparing_;                         ///< for the next one
  std::shared_ptr<const BodyTracker> prepares_;  ///< masks for tracker_
  bool follows_ = false;                         ///< the person, in the last frame set
  BodyPose last_fitted_;                         ///< valid if follows_
  RigTrust trust_;
  SteadyTime time_;  ///< of the tracker
  std::atomic<int64_t> last_pose_ns_{0}, last_tracked_ns_{0};
  std::optional<Eigen::Vector3d> last_head_;  ///< m in world, where the text is shown
  std::atomic<bool> runs_{true};
  std::atomic<bool> searches_{false};  ///< frame sets may wait behind a search
  LatencyMeter fitting_times_;
  CatchUpQueue<FittingMessages> queue_;
  Backlog backlog_{kNewest};
  std::vector<std::unique_ptr<CameraPictures>> pictures_;
  std::unique_ptr<FittingInputs> inputs_;
  TrackerSuccessor successor_;
  std::thread worker_;
  ros::WallTimer timer_;
  std::optional<LiveOptions<TrackerOptions>> live_;
  std::optional<StageServices> services_;
  CallbackGate gate_;
};

}  // namespace markerless_mocap
