#pragma once

#include <optional>
#include <random>

#include "calibration/board_scene.h"
#include "calibration/calibrate.h"

namespace markerless_mocap {

/// The rig as a board gives it that is waved through the volume and then laid on the floor at the
/// origin: corners with 0.3 px of noise, nothing else known.
inline CameraRig calibratedByBoard(const CameraRig& rig) {
  constexpr double kWaved = 40.0, kLaid = 60.0;  // s
  BoardScene scene;
  for (const Camera& camera : rig) {
    scene.cameras.push_back(camera.calibration());
    scene.offsets.push_back(0.0);
  }
  CalibrationInput input = scene.input(kWaved);
  std::mt19937 random(7);
  for (size_t i = 0; i < rig.size(); ++i)
    if (auto view = scene.viewAt(i, kLaid, Eigen::Isometry3d::Identity(), &random)) {
      if (!input.floor) input.floor = FloorView{i, kLaid, 0.0};
      input.views.push_back(*view);
    }
  CameraRig found;
  for (const CalibratedCamera& camera : calibrateRig(input).cameras)
    found.emplace_back(camera.calibration);
  return found;
}

}  // namespace markerless_mocap
