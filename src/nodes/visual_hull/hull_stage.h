#pragma once

#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "markerless_mocap/camera/frame_set_assembler.h"
#include "markerless_mocap/hull/hull_carver.h"
#include "nodes/common/holding_queue.h"
#include "nodes/common/stage_inputs.h"
#include "nodes/common/stamp_cache.h"
#include "ros/node_options.h"
#include "ros/rig_collector.h"

namespace markerless_mocap {

/// Joins the masks of one time and carves the hull. Its callbacks run one at a time.
class HullStage {
 public:
  HullStage(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
            const HullOptions& options, const HullNodeOptions& node_options);

 private:
  using Assembler = FrameSetAssembler<sensor_msgs::ImageConstPtr>;

  void subscribe();
  void receiveInfo(size_t camera, const sensor_msgs::CameraInfo& info);
  void receiveMask(size_t camera, const sensor_msgs::ImageConstPtr& mask);
  void receiveImage(size_t camera, const CameraImage& image);
  /// Processes the waiting frame sets, oldest first, up to one whose images may still arrive.
  void drain();
  bool waitsForImages(const Assembler::FrameSet& frame_set) const;
  void process(const Assembler::FrameSet& frame_set);
  /// Reports the result for a frame set, and which cameras were left out.
  void reportHull(const VisualHull& hull, const std::string& timing);
  /// What is said of cameras that lag or are missing, each after "; "; empty: nothing.
  std::string timingRemarks(const Assembler::FrameSet& frame_set) const;
  void prepareBeforehand(const ros::Time& stamp);
  /// Makes the carver as soon as rig and transforms are known; throws the reason if they are not.
  void prepareCarver(const std_msgs::Header& header);
  std::vector<CameraImage> takeImages(const Assembler::FrameSet& frame_set);
  /// The result refers to the pixels of the images. A camera whose mask cannot be read is left out.
  std::vector<HullView> viewsOf(const Assembler::FrameSet& frame_set,
                                const std::vector<CameraImage>& images,
                                std::vector<LeftOutCamera>* left_out) const;
  void requireCameras(size_t usable, const Assembler::FrameSet& frame_set) const;
  /// Whether this is a lone mask between frame sets that have enough of them.
  bool isStray(const Assembler::FrameSet& frame_set) const;
  void publishCameras(const Assembler::FrameSet& frame_set, const VisualHull& hull,
                      const std_msgs::Header& header);
  /// Takes over what has changed about the cameras. The old carver is used until the new one is
  /// made.
  void followRig();
  void takeNextCarver(const std_msgs::Header& header);
  void publishRig(const std_msgs::Header& header);
  void reportCounts();

  HullOptions options_;
  HullNodeOptions node_options_;
  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener tf_listener_;
  RigCollector rig_;
  Assembler assembler_;
  StampCache<CameraImage> images_;
  HoldingQueue<Assembler::FrameSet> waiting_;
  std::optional<HullCarver> carver_;
  std::future<HullCarver> next_carver_;  ///< of a rig that has changed
  std::string carver_error_;  ///< why the rig cannot be used; valid until the rig changes
  StageStatus status_;
  std::optional<int64_t> last_carved_ns_;  ///< stamp of the last frame set with enough cameras
  double next_look_ = 0.0;                 ///< s, when to look for changes of the rig
  ros::Publisher points_, cameras_, grid_, markers_;
  StageInputs inputs_;
};

}  // namespace markerless_mocap
