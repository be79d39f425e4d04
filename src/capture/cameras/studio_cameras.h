#pragma once

#include <cstdint>
#include <vector>

#include "capture/render/mesh_renderer.h"
#include "capture/scene/textured_room.h"
#include "capture/studio_options.h"

namespace markerless_mocap {

/// The room and its cameras, with their degradations.
class StudioCameras {
 public:
  /// Throws as makeRig() and readRig().
  explicit StudioCameras(const StudioOptions& options);

  const CameraRig& rig() const { return rig_; }
  const CameraRig& calibratedRig() const { return calibrated_rig_; }
  const TexturedRoom& room() const { return room_; }
  const MeshRenderer& renderer(size_t camera) const { return renderers_[camera]; }
  /// Seconds by which a camera's images are later than their stamps.
  double offset(size_t camera) const { return offsets_[camera]; }
  bool isDropped(int index, size_t camera) const;
  /// Applies light and sensor to an image.
  /// \param seconds time since the first frame set
  void expose(int index, size_t camera, double seconds, cv::Mat& image) const;
  /// The mask with the errors of a background subtraction.
  cv::Mat silhouette(int index, size_t camera, const cv::Mat& mask) const;

 private:
  uint64_t streamOf(int index, size_t camera, uint64_t purpose) const;

  DegradationOptions degradations_;
  uint64_t seed_;
  CameraRig rig_, calibrated_rig_;
  TexturedRoom room_;
  std::vector<MeshRenderer> renderers_;
  std::vector<cv::Scalar> metered_;  ///< colour of the empty room, by camera
  std::vector<double> offsets_;
};

}  // namespace markerless_mocap
