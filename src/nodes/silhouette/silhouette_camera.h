#pragma once

#include <ros/node_handle.h>

#include <cstdint>
#include <mutex>

#include "markerless_mocap/silhouette/silhouette_extractor.h"
#include "nodes/common/frozen_images.h"
#include "nodes/common/stage_inputs.h"
#include "nodes/common/stamp_order.h"
#include "nodes/common/sudden_change.h"
#include "nodes/silhouette/first_masks.h"
#include "nodes/silhouette/kept_background.h"
#include "nodes/silhouette/load_shedding.h"
#include "nodes/silhouette/timed_settings.h"
#include "ros/node_options.h"

namespace markerless_mocap {

/// Silhouette extraction of one camera: images in, masks out.
class SilhouetteCamera {
 public:
  using Settings = TimedSettings<SilhouetteOptions>;

  /// What the cameras of a stage share; it must outlive them.
  struct Shared {
    Settings settings;
    FirstMasks first_masks;
    LoadShedding load;

    Shared(size_t cameras, const SilhouetteOptions& options)
        : settings(cameras, options), first_masks(cameras), load(cameras) {}
  };

  /// \param camera number in node_options.cameras
  SilhouetteCamera(ros::NodeHandle& handle, const ros::NodeHandle& private_handle, size_t camera,
                   const SilhouetteOptions& options, const SilhouetteNodeOptions& node_options,
                   Shared* shared);

  /// Both throw std::invalid_argument with the reason if they fail.
  void learnBackground();
  void saveBackground();

 private:
  void receive(const CameraImage& image);
  /// Whether the image is in the order of time and not one of a frozen camera.
  bool isUsable(const CameraImage& image);
  bool isInOrder(const ros::Time& stamp);
  void reportDuplicate();
  bool isFrozen(const CameraImage& image);
  /// Whether there are too many images for each to be processed.
  bool isLeftOut(const CameraImage& image);
  /// Takes over settings that have changed.
  void followSettings(const ros::Time& stamp);
  void process(const CameraImage& image);
  void publishMask(const cv::Mat& mask, const CameraImage& image);
  void publishSilhouette(const CameraImage& image);
  CameraPhase phaseAfter(const SilhouetteResult& silhouette) const;
  /// As image, and as PNG while somebody subscribes to it.
  void publish(const cv::Mat& mask, const std_msgs::Header& header);
  void reportLearning();
  void reportSilhouette(const SilhouetteResult& silhouette);
  void checkInput() const;

  size_t number_;
  std::string camera_;
  Shared* shared_;
  int background_frames_;
  Settings::Pointer used_;  ///< null: those of the start
  SilhouetteNodeOptions node_options_;
  std::mutex mutex_;  ///< protects the extractor: services run in parallel with images
  SilhouetteExtractor extractor_;
  StageStatus status_;
  KeptBackground background_;  ///< of extractor_
  StampOrder order_;
  FrozenImages frozen_;
  SuddenChange change_;
  CameraImage last_image_;
  bool needs_each_image_ = false;   ///< of the few that the background is learned from
  bool has_been_ready_ = false;     ///< masks have been published
  bool has_seen_somebody_ = false;  ///< since the background was learned
  ros::Publisher publisher_, compressed_publisher_;
  StageInputs inputs_;
};

}  // namespace markerless_mocap
