#include "capture/cameras/studio_cameras.h"

#include <algorithm>
#include <cmath>

#include "capture/cameras/camera_rigs.h"
#include "capture/degradations/auto_camera.h"
#include "capture/degradations/mask_damage.h"
#include "capture/degradations/sensor.h"
#include "markerless_mocap/camera/rig_file.h"
#include "numerics/split_mix.h"

namespace markerless_mocap {
namespace {

/// Purposes of random numbers; each has its own stream.
enum Purpose : uint64_t { kNoise = 1, kFlicker, kMask, kDrop, kOffset, kCalibration };

uint64_t combinedHash(uint64_t seed, uint64_t purpose) {
  return splitMix64(splitMix64(seed) ^ (purpose << 32));
}

CameraRig plannedRig(const StudioOptions& options) {
  const auto& kinds = rigKinds();
  if (std::find(kinds.begin(), kinds.end(), options.rig) != kinds.end())
    return makeRig({options.rig, options.width, options.height, options.distortion_k1,
                    uint64_t(options.seed)});
  if (options.rig.find('.') == std::string::npos)
    return makeRig({options.rig});  // throws an error with the allowed kinds
  CameraRig rig;
  for (const CameraCalibration& camera : readRig(options.rig)) rig.emplace_back(camera);
  return rig;
}

/// Rotates each camera so that its image shifts by `pixels` in a random direction.
CameraRig perturbedRig(const CameraRig& rig, double pixels, uint64_t seed) {
  CameraRig reported;
  for (size_t i = 0; i < rig.size(); ++i) {
    CameraCalibration camera = rig[i].calibration();
    const double direction = 2.0 * M_PI * splitMixUniform(combinedHash(seed, kCalibration) + i);
    const double angle = pixels / std::sqrt(camera.K(0, 0) * camera.K(1, 1));
    const Eigen::Vector3d axis(std::cos(direction), std::sin(direction), 0.0);
    if (pixels > 0.0) camera.T_world_camera.rotate(Eigen::AngleAxisd(angle, axis));
    reported.emplace_back(camera);
  }
  return reported;
}

}  // namespace

StudioCameras::StudioCameras(const StudioOptions& options)
    : degradations_(options.degradations),
      seed_(uint64_t(options.seed)),
      rig_(plannedRig(options)),
      calibrated_rig_(perturbedRig(rig_, degradations_.calibration_error_px, seed_)),
      room_(TexturedRoom::around(seed_, rig_)),
      renderers_(makeRenderers(rig_, room_, degradations_.floor_reflection)) {
  for (const MeshRenderer& renderer : renderers_)
    metered_.push_back(meteredColor(renderer.background()));
  for (size_t i = 0; i < rig_.size(); ++i)
    offsets_.push_back(1e-3 * degradations_.time_offset_ms *
                       (splitMixUniform(combinedHash(seed_, kOffset) + i) - 0.5));
}

uint64_t StudioCameras::streamOf(int index, size_t camera, uint64_t purpose) const {
  return splitMix64(combinedHash(seed_, purpose) + uint64_t(index)) + camera;
}

bool StudioCameras::isDropped(int index, size_t camera) const {
  return splitMixUniform(streamOf(index, camera, kDrop)) < degradations_.drop_rate;
}

void StudioCameras::expose(int index, size_t camera, double seconds, cv::Mat& image) const {
  const double gain = flickerGain(degradations_.flicker, seconds, combinedHash(seed_, kFlicker));
  followLight(degradations_.auto_exposure, degradations_.auto_white_balance, metered_[camera],
              image);
  applySensor(degradations_.noise_stddev, gain, streamOf(index, camera, kNoise), image);
}

cv::Mat StudioCameras::silhouette(int index, size_t camera, const cv::Mat& mask) const {
  if (degradations_.mask_damage == 0.0) return mask;
  return damagedMask(mask, degradations_.mask_damage, streamOf(index, camera, kMask));
}

}  // namespace markerless_mocap
