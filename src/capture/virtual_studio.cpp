#include "markerless_mocap/capture/virtual_studio.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "capture/hash.h"
#include "capture/sensor_noise.h"
#include "markerless_mocap/body/body_urdf.h"
#include "markerless_mocap/capture/camera_ring.h"

namespace markerless_mocap {
namespace {

std::string filledUrdf(const std::string& urdf_template, const std::string& body_id,
                       const StudioOptions& options) {
  options.validate();
  return fillUrdfTemplate(urdf_template, body_id, BodyProportions::fromStature(options.stature));
}

std::vector<ViewRenderer> makeRenderers(const CameraRig& rig) {
  std::vector<std::optional<ViewRenderer>> made(rig.size());
  tbb::parallel_for(size_t(0), rig.size(), [&](size_t i) { made[i].emplace(rig[i]); });
  std::vector<ViewRenderer> renderers;
  for (auto& renderer : made) renderers.push_back(std::move(*renderer));
  return renderers;
}

}  // namespace

VirtualStudio::VirtualStudio(const std::string& urdf_template, const std::string& body_id,
                             const StudioOptions& options)
    : options_(options),
      urdf_(filledUrdf(urdf_template, body_id, options)),
      model_(std::make_shared<BodyModel>(BodyModel::fromUrdf(urdf_, body_id))),
      motion_(model_, options.walk_radius, options.walk_speed),
      rig_(cameraRing(options)),
      renderers_(makeRenderers(rig_)) {}

int VirtualStudio::instantCount() const {
  return options_.background_frames + int(std::lround(options_.duration * options_.fps));
}

StudioInstant VirtualStudio::render(int index) const {
  if (index < 0)
    throw std::invalid_argument("the index of a studio instant is " + std::to_string(index) +
                                ", allowed is 0 and above");
  StudioInstant instant;
  instant.time_ns = std::llround(index * 1e9 / options_.fps);
  instant.person = index >= options_.background_frames;
  std::vector<SolidCone> cones;
  if (instant.person) {
    instant.body = motion_.at((index - options_.background_frames) / options_.fps);
    LinkPoses poses;
    model_->forwardKinematics(instant.body.T_world_body, instant.body.angles, poses);
    instant.markers = markerPositions(*model_, poses);
    cones = posedShape(*model_, poses);
  }
  instant.images.resize(rig_.size());
  instant.masks.resize(rig_.size());
  tbb::parallel_for(size_t(0), rig_.size(), [&](size_t i) {
    RenderedView view = renderers_[i].render(cones);
    const uint64_t stream = hashBits(hashBits(uint64_t(options_.seed)) + uint64_t(index)) + i;
    addSensorNoise(options_.noise_levels, stream, view.image);
    instant.images[i] = view.image;
    instant.masks[i] = view.mask;
  });
  return instant;
}

}  // namespace markerless_mocap
