#include "capture/virtual_studio.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "capture/cameras/studio_cameras.h"
#include "capture/scene/studio_scene.h"

namespace markerless_mocap {
namespace {

StudioOptions validated(const StudioOptions& options) {
  options.validate();
  return options;
}

/// Times while the shutter is open, evenly spaced around its middle.
std::vector<FilmTime> shutterTimes(const FilmTime& middle, double exposure_ms) {
  constexpr double kStepMs = 4.0;  // a hand at 5 m/s moves 2 cm in this time
  if (exposure_ms == 0.0) return {middle};
  const int half = std::max(1, int(std::ceil(0.5 * exposure_ms / kStepMs)));
  std::vector<FilmTime> times;
  for (int i = -half; i <= half; ++i)
    times.push_back(middle.later(0.5e-3 * exposure_ms * i / half));
  return times;
}

/// The scenes of one exposure.
class Exposure {
 public:
  Exposure(const StudioScene& cast, const StudioCameras& cameras, const StudioOptions& options,
           const FilmTime& middle) {
    const auto times = shutterTimes(middle, middle.people ? options.degradations.exposure_ms : 0.0);
    std::vector<std::optional<LitScene>> made(times.size());
    tbb::parallel_for(size_t(0), times.size(), [&](size_t i) {
      made[i].emplace(cameras.room(), cast.objectsAt(times[i]),
                      options.degradations.shadow_strength, cast.lightAt(times[i]));
    });
    for (auto& scene : made) scenes_.push_back(std::move(*scene));
  }

  RenderedView seenBy(const MeshRenderer& renderer) const {
    std::vector<RenderedView> shots;
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
      scene_(std::make_unique<StudioScene>(options, files, cameras_->room(), body_id)) {}

VirtualStudio::~VirtualStudio() = default;

const CameraRig& VirtualStudio::rig() const {
  return cameras_->calibratedRig();
}

const CameraRig& VirtualStudio::trueRig() const {
  return cameras_->rig();
}

const BodyModel& VirtualStudio::body() const {
  return scene_->body();
}

const std::string& VirtualStudio::urdf() const {
  return scene_->urdf();
}

double VirtualStudio::stature() const {
  return scene_->stature();
}

int VirtualStudio::frameSetCount() const {
  const double seconds = options_.duration > 0.0 ? options_.duration : scene_->duration();
  return options_.background_frames + std::max(1, int(std::lround(seconds * options_.fps)));
}

StudioFrameSet VirtualStudio::render(int index) const {
  if (index < 0)
    throw std::invalid_argument("the index of a frame set is " + std::to_string(index) +
                                ", allowed is 0 and above");
  StudioFrameSet frame_set;
  frame_set.time_ns = std::llround(index * 1e9 / options_.fps);
  frame_set.person = index >= options_.background_frames;
  const int frame = std::max(0, index - options_.background_frames) % scene_->framesPerRound();
  const double seconds = frame / options_.fps;
  if (frame_set.person) {
    frame_set.body = scene_->bodyAt(frame);
    frame_set.points = scene_->pointsAt(seconds);
  }
  const double since = (index - options_.background_frames) / options_.fps;
  film(index, {seconds, since, frame_set.person}, &frame_set);
  return frame_set;
}

void VirtualStudio::film(int index, const FilmTime& time, StudioFrameSet* frame_set) const {
  const auto exposureAt = [&](const FilmTime& when) {
    return Exposure(*scene_, *cameras_, options_, when);
  };
  // Cameras with different time offsets see different scenes.
  const bool in_step = options_.degradations.time_offset_ms == 0.0 || !frame_set->person;
  std::optional<Exposure> shared;
  if (in_step) shared.emplace(exposureAt(time));
  const size_t count = cameras_->rig().size();
  frame_set->images.resize(count);
  frame_set->masks.resize(count);
  frame_set->silhouettes.resize(count);
  tbb::parallel_for(size_t(0), count, [&](size_t i) {
    const MeshRenderer& renderer = cameras_->renderer(i);
    RenderedView view = in_step ? shared->seenBy(renderer)
                                : exposureAt(time.later(cameras_->offset(i))).seenBy(renderer);
    frame_set->masks[i] = view.mask;
    if (cameras_->isDropped(index, i)) return;
    frame_set->silhouettes[i] = cameras_->silhouette(index, i, view.mask);
    cameras_->expose(index, i, 1e-9 * double(frame_set->time_ns), view.image);
    frame_set->images[i] = view.image;
  });
}

}  // namespace markerless_mocap
