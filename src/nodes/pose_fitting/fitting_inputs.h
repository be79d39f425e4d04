#pragma once

#include <ros/node_handle.h>

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "markerless_mocap/pipeline/make_body_tracker.h"
#include "markerless_mocap/ros/messages.h"
#include "nodes/common/camera_transforms.h"
#include "nodes/common/mask_sets.h"
#include "nodes/common/stage_inputs.h"
#include "nodes/common/stamp_cache.h"
#include "nodes/pose_fitting/color_images.h"
#include "nodes/pose_fitting/live_products.h"
#include "ros/node_options.h"
#include "ros/rig_collector.h"

namespace markerless_mocap {

/// Messages of the cameras for one time. Missing messages are null.
struct FittingMessages {
  std_msgs::Header header;
  int64_t arrival_ns = 0;  ///< when it was complete, by a clock that is never set
  std::string error;       ///< why no pose can be fitted; empty if it can
  std::shared_ptr<const CameraRig> rig;
  std::vector<sensor_msgs::ImageConstPtr> masks;  ///< by camera; null: not to be used
  std::vector<cv::Mat> pixels;      ///< by camera, of the masks; empty: they have to be read, still
  std::vector<CameraImage> images;  ///< by camera, with the stamps of the masks; or none at all
  std::vector<double> later_s;      ///< by camera, as of TrackerInput
  std::function<bool()> behind;     ///< whether newer frame sets wait by now
  bool images_awaited = false;      ///< images that it lacks will come with later frame sets
};

/// Subscribes to all inputs of pose fitting. For a method that needs masks, silhouettes are joined
/// into frame sets, as visual_hull joins them; products of the other stages are subscribed while a
/// tracker asks for them. For the others, each hull is a frame set. For a method that needs
/// colours, images are subscribed only while the masks call for them.
class FittingInputs {
 public:
  using ReadMask = std::function<cv::Mat(size_t camera, const sensor_msgs::Image&)>;

  /// \param sink receives the frame sets, oldest first, one at a time; it must return quickly
  /// \param read_mask makes use of each mask as soon as it is there, and returns its pixels; empty:
  ///   it is read later. What it throws is as if it returned nothing
  /// \param search_begins as of LiveProducts
  FittingInputs(ros::NodeHandle& handle, const FittingNodeOptions& options, TrackerNeeds needs,
                StageStatus* status, std::function<void(FittingMessages)> sink, ReadMask read_mask,
                std::function<void()> search_begins);

  LiveProducts& products() { return products_; }
  /// \param cameras as BodyTracker::wantedImages(). Thread-safe
  void wantColors(std::vector<bool> cameras);
  /// Stamp of each camera's last silhouette, and what the last frame set used. Thread-safe.
  void describeCameras(MocapStatus* message) const;
  /// Which cameras the last frame set did not use, such as "without cam2 (its mask is full)";
  /// empty: it used all. Thread-safe.
  std::string lackingCameras() const;

 private:
  /// What is known of a camera.
  struct CameraState {
    ros::Time last_stamp;
    bool used = false;
    std::string reason;
  };

  void listenToInfo(size_t camera);
  void listenToCamera(size_t camera);
  void receiveMask(size_t camera, const sensor_msgs::ImageConstPtr& mask);
  /// Of a method that needs no masks.
  void receiveHull(const std_msgs::Header& header);
  void dispatch(const MaskSet& frame_set);
  bool waitsForImages(const MaskSet& frame_set) const;
  void addView(size_t camera, const MaskSet& frame_set, FittingMessages* input);
  struct Judgement {
    bool usable = true;
    std::string reason;  ///< why visual_hull did without the camera; empty: not known
  };
  Judgement judgementOf(size_t camera, int64_t stamp_ns) const;
  /// Why too few cameras are where the rig has them; empty: there are enough.
  std::string doubtOf(const MaskSet& frame_set) const;
  void noteUse(size_t camera, bool used, const std::string& reason);
  /// Takes over what has changed about the cameras.
  void followRig();
  bool areColorsWanted(size_t camera) const;
  void readBeforehand(size_t camera, const sensor_msgs::Image& mask);
  CameraImage takeImage(size_t camera, const sensor_msgs::Image& mask);
  /// Determines the rig. Returns a message about what is missing; empty once the rig is known.
  std::string prepareRig();
  void reportCounts();

  FittingNodeOptions options_;
  TrackerNeeds needs_;
  StageStatus* status_;
  std::function<void(FittingMessages)> sink_;
  ReadMask read_mask_;
  CameraTransforms tf_;
  RigCollector collector_;
  std::shared_ptr<const CameraRig> rig_;  ///< null until the rig is known
  MaskSets mask_sets_;
  StampCache<CameraImage> images_;
  StampCache<cv::Mat> pixels_;                                   ///< of masks
  std::deque<boost::shared_ptr<const HullCameras>> judgements_;  ///< the last ones
  mutable std::mutex states_mutex_;
  std::vector<CameraState> states_;    ///< by camera
  std::vector<bool> wanted_colors_;    ///< by camera, or empty; with states_mutex_
  std::optional<ColorImages> colors_;  ///< of a method that needs them
  StageInputs inputs_;
  LiveProducts products_;
};

}  // namespace markerless_mocap
