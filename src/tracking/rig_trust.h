#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Decides which new calibrations are believed while a person is followed. A camera whose
/// silhouettes show the person elsewhere than its new calibration says keeps the one of before, and
/// is left out until they agree. One thread may call all but isRefused().
class RigTrust {
 public:
  using RigPointer = std::shared_ptr<const CameraRig>;
  /// What a frame set shows.
  struct Evidence {
    /// By camera; empty where there is none that can be used.
    std::function<cv::Mat(size_t)> mask;
    /// Of the person who is followed, m in world. Without them every calibration is believed.
    std::vector<Eigen::Vector3d> joints;
  };

  /// \param told by camera_info and tf; all have the same cameras
  /// \return the rig to use; the same as the last time unless a calibration in it has changed
  RigPointer rigFor(const RigPointer& told, const Evidence& evidence);
  /// Whether this camera is to be left out. Thread-safe.
  bool isRefused(size_t camera) const { return refused_ >> camera & 1; }

 private:
  enum class Verdict { kAgrees, kContradicts, kNotSeen };

  Verdict judge(const Camera& camera, size_t index, const Evidence& evidence) const;
  void judgeChanges(const CameraRig& told, const Evidence& evidence);
  void takeBack(const Evidence& evidence);
  void refuse(size_t camera, bool refused);
  RigPointer composed() const;

  static constexpr int kConvincing = 5;  // frame sets in a row

  RigPointer told_, used_;
  std::vector<int> agreements_;       ///< in a row, by camera
  std::atomic<uint32_t> refused_{0};  ///< a bit for each camera
};

}  // namespace markerless_mocap
