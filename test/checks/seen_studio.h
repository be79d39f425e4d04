#pragma once

#include <opencv2/imgproc.hpp>

#include "capture/studio_fixture.h"
#include "checks/check_rig.h"

namespace markerless_mocap {

constexpr double kTestRate = 15;  // images per second

inline SeenCamera emptyCamera(const CameraCalibration& calibration) {
  SeenCamera camera;
  camera.name = calibration.name;
  camera.T_world_camera = calibration.T_world_camera;
  SeenInfo info;
  info.width = calibration.width;
  info.height = calibration.height;
  info.K = calibration.K;
  info.D = calibration.D;
  info.frame = calibration.name + "_optical";
  camera.infos = {info};
  return camera;
}

inline void addImage(const StudioFrameSet& frame, size_t index, bool picture, SeenCamera* camera) {
  SeenImage seen;
  seen.stamp_ns = seen.received_ns = 1000'000'000'000 + frame.time_ns;
  const cv::Mat& image = frame.images[index];
  seen.width = image.cols;
  seen.height = image.rows;
  seen.fingerprint = uint64_t(frame.time_ns) + 1;
  cv::resize(image, seen.colors, {kColorsWidth, kColorsWidth * image.rows / image.cols}, 0, 0,
             cv::INTER_AREA);
  seen.outline = outlineOf(frame.silhouettes[index], image.cols, image.rows);
  camera->images.push_back(seen);
  if (!picture) return;
  camera->pictures.push_back({seen.stamp_ns, {}});
  cv::cvtColor(image, camera->pictures.back().grey, cv::COLOR_BGR2GRAY);
}

/// Somebody who walks in a circle among four cameras, as cameras and silhouettes see it.
inline SeenRig filmedWalk(StudioOptions options) {
  options.width = 320;
  options.height = 240;
  options.rig = "ring4";
  options.motion = "walk_in_circle";
  options.fps = kTestRate;
  options.background_frames = 1;
  options.duration = 9;
  const VirtualStudio studio(options, packageFiles(), "person1");
  SeenRig rig;
  for (const Camera& camera : studio.rig())
    rig.cameras.push_back(emptyCamera(camera.calibration()));
  for (int i = 0; i < studio.frameSetCount(); ++i) {
    const StudioFrameSet frame = studio.render(i);
    for (size_t c = 0; c < rig.cameras.size(); ++c)
      if (!frame.images[c].empty()) addImage(frame, c, i % 6 == 0, &rig.cameras[c]);
  }
  return rig;
}

}  // namespace markerless_mocap
