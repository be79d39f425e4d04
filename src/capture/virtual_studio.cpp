#include "capture/virtual_studio.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "capture/cameras/studio_cameras.h"
#include "capture/scene/studio_cast.h"

namespace markerless_mocap {
namespace {

StudioOptions validated(const StudioOptions& options) {
  options.validate();
  return options;
}

/// Moments while the shutter is open, evenly spaced about `seconds`.
std::vector<double> shutterTimes(double seconds, double exposure_ms) {
  constexpr double kStepMs = 4.0;  // in which a hand at 5 m/s goes 2 cm
  if (exposure_ms == 0.0) return {seconds};
  const int half = std::max(1, int(std::ceil(0.5 * exposure_ms / kStepMs)));
  std::vector<double> times;
  for (int i = -half; i <= half; ++i) times.push_back(seconds + 0.5e-3 * exposure_ms * i / half);
  return times;
}

/// The scenes of one exposure.
class Exposure {
 public:
  Exposure(const StudioCast& cast, const StudioCameras& cameras, const StudioOptions& options,
           double seconds, bool people) {
    const auto times = shutterTimes(seconds, people ? options.troubles.exposure_ms : 0.0);
    std::vector<std::optional<LitScene>> made(times.size());
    tbb::parallel_for(size_t(0), times.size(), [&](size_t i) {
      made[i].emplace(cameras.room(), cast.objectsAt(times[i], people),
                      options.troubles.shadow_strength);
    });
    for (auto& scene : made) scenes_.push_back(std::move(*scene));
  }

  MeshView seenBy(const MeshRenderer& renderer) const {
    std::vector<MeshView> shots;
    for (const LitScene& scene : scenes_) shots.push_back(renderer.render(scene));
    return shots.size() == 1 ? shots.front() : motionBlurred(shots);
  }

 private:
  std::vector<LitScene> scenes_;
};

}  // namespace

VirtualStudio::VirtualStudio(const StudioOptions& options, const StudioFiles& files,
                             const std::string& body_id)
    : options_(validated(options)),
      cameras_(std::make_unique<StudioCameras>(options)),
      cast_(std::make_unique<StudioCast>(options, files, cameras_->room().wallColor(), body_id)) {}

VirtualStudio::~VirtualStudio() = default;

const CameraRig& VirtualStudio::rig() const {
  return cameras_->toldRig();
}

const CameraRig& VirtualStudio::trueRig() const {
  return cameras_->rig();
}

const BodyModel& VirtualStudio::body() const {
  return cast_->body();
}

const std::string& VirtualStudio::urdf() const {
  return cast_->urdf();
}

double VirtualStudio::stature() const {
  return cast_->stature();
}

int VirtualStudio::instantCount() const {
  const double seconds = options_.duration > 0.0 ? options_.duration : cast_->duration();
  return options_.background_frames + std::max(1, int(std::lround(seconds * options_.fps)));
}

StudioInstant VirtualStudio::render(int index) const {
  if (index < 0)
    throw std::invalid_argument("the index of a studio instant is " + std::to_string(index) +
                                ", allowed is 0 and above");
  StudioInstant instant;
  instant.time_ns = std::llround(index * 1e9 / options_.fps);
  instant.person = index >= options_.background_frames;
  const int frame = std::max(0, index - options_.background_frames) % cast_->framesPerRound();
  const double seconds = frame / options_.fps;
  if (instant.person) {
    instant.body = cast_->bodyAt(frame);
    instant.points = cast_->pointsAt(seconds);
  }
  film(index, seconds, &instant);
  return instant;
}

void VirtualStudio::film(int index, double seconds, StudioInstant* instant) const {
  const auto exposureAt = [&](double when) {
    return Exposure(*cast_, *cameras_, options_, when, instant->person);
  };
  // Cameras that are not in step see scenes of their own.
  const bool in_step = options_.troubles.time_offset_ms == 0.0 || !instant->person;
  std::optional<Exposure> shared;
  if (in_step) shared.emplace(exposureAt(seconds));
  const size_t count = cameras_->rig().size();
  instant->images.resize(count);
  instant->masks.resize(count);
  instant->silhouettes.resize(count);
  tbb::parallel_for(size_t(0), count, [&](size_t i) {
    const MeshRenderer& renderer = cameras_->renderer(i);
    MeshView view = in_step ? shared->seenBy(renderer)
                            : exposureAt(seconds + cameras_->offset(i)).seenBy(renderer);
    instant->masks[i] = view.mask;
    if (cameras_->isDropped(index, i)) return;
    instant->silhouettes[i] = cameras_->silhouette(index, i, view.mask);
    cameras_->expose(index, i, 1e-9 * double(instant->time_ns), view.image);
    instant->images[i] = view.image;
  });
}

}  // namespace markerless_mocap
