#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "markerless_mocap/hull/hull_carver.h"
#include "nodes/common/camera_transforms.h"
#include "nodes/common/live_options.h"
#include "nodes/common/mask_sets.h"
#include "nodes/common/stage_inputs.h"
#include "nodes/common/stage_services.h"
#include "nodes/common/stamp_cache.h"
#include "nodes/visual_hull/camera_display.h"
#include "nodes/visual_hull/live_carver.h"
#include "nodes/visual_hull/volume_handles.h"
#include "ros/node_options.h"
#include "ros/rig_collector.h"

namespace markerless_mocap {

/// Joins the masks of one time and carves the hull. Its callbacks run one at a time; settings and
/// services come from other threads.
class HullStage {
 public:
  /// \param private_handle of several threads
  HullStage(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
            const HullOptions& options, const HullNodeOptions& node_options);

 private:
  void subscribe();
  /// Whether somebody listens to the hull. Else it is carved to judge the cameras, no more.
  bool isWanted() const { return points_.getNumSubscribers() > 0; }
  /// Images are read while the hull is wanted, and a little longer.
  void followDemand();
  void receiveInfo(size_t camera, const sensor_msgs::CameraInfo& info);
  void receiveMask(size_t camera, const sensor_msgs::ImageConstPtr& mask);
  void receiveImage(size_t camera, const CameraImage& image);
  bool waitsForImages(const MaskSet& frame_set) const;
  void process(const MaskSet& frame_set);
  /// Reports the result for a frame set, and which cameras were left out.
  void reportHull(const VisualHull& hull, const std::string& timing);
  /// What is said of cameras that lag or are missing, each after "; "; empty: nothing.
  std::string timingRemarks(const MaskSet& frame_set) const;
  /// A sentence if the cameras are not in step; empty if they are.
  std::string stepOfCameras() const;
  void prepareBeforehand(const ros::Time& stamp);
  /// Takes over new settings, and makes the carver as soon as rig and transforms are known; throws
  /// the reason if they are not.
  void prepareCarver(const std_msgs::Header& header);
  /// Publishes grid and cameras of a new carver.
  void announceCarver(const std_msgs::Header& header);
  void advertiseServices();
  /// Thread-safe; returns what was done. Throws if the file cannot be written.
  std::string saveVolume() const;
  std::vector<CameraImage> takeImages(const MaskSet& frame_set);
  /// The result refers to the pixels of the images. A camera whose mask cannot be read is left out.
  std::vector<HullView> viewsOf(const MaskSet& frame_set, const std::vector<CameraImage>& images,
                                std::vector<LeftOutCamera>* left_out) const;
  /// Why the carver's rig does not hold for what a camera sends; empty: it does.
  std::string doubtOf(size_t camera) const;
  void requireCameras(size_t usable, const MaskSet& frame_set) const;
  void publishCameras(const MaskSet& frame_set, const VisualHull& hull,
                      const std_msgs::Header& header);
  /// Takes over what has changed about the cameras. The old carver is used until the new one is
  /// made, without the cameras that have changed noticeably.
  void followRig();
  void reportCounts();

  HullNodeOptions node_options_;
  CameraTransforms tf_;
  RigCollector rig_;
  MaskSets mask_sets_;
  StampCache<CameraImage> images_;
  LiveCarver carver_;
  StageStatus status_;
  std::vector<ros::Subscriber> image_subscribers_;
  double wanted_until_ = 0.0;  ///< s, when images are needed no more
  ros::Publisher points_, cameras_, grid_;
  CameraDisplay display_;
  std::atomic<bool> runs_{true};
  StageInputs inputs_;
  LiveOptions<HullOptions> live_;
  VolumeHandles handles_;
  StageServices services_;
};

}  // namespace markerless_mocap
