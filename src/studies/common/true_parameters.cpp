#include "studies/common/true_parameters.h"

#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr double kRate = 60.0;  // frames per second of the statistics
constexpr int kImageSize = 16;  // pixels; the images are not used

}  // namespace

TrueParameters::TrueParameters(const BodyModel& model) : model_(model), body_model_(model) {}

const FleischmannVector& TrueParameters::follow(const BodyState& body) {
  LinkPoses links;
  model_.forwardKinematics(body.T_world_body, body.angles, links);
  last_ = body_model_.parametersOf(links, last_);
  return last_;
}

FleischmannMotionStatistics statisticsOf(const std::vector<std::string>& motions,
                                         StudioOptions studio, const StudioFiles& files) {
  if (motions.empty()) throw std::invalid_argument("statistics need at least one motion");
  studio.fps = kRate;
  studio.background_frames = 0;
  studio.width = studio.height = kImageSize;
  studio.rig = "ring4";
  FleischmannMotionStatistics statistics;
  for (const std::string& motion : motions) {
    studio.motion = motion;
    const VirtualStudio stage(studio, files, "person1");
    TrueParameters truth(stage.body());
    FleischmannVector before = truth.follow(stage.render(0).body);
    for (int i = 1; i < stage.frameSetCount(); ++i) {
      const FleischmannVector now = truth.follow(stage.render(i).body);
      statistics.add(before, now, 1.0 / kRate);
      before = now;
    }
  }
  return statistics;
}

}  // namespace markerless_mocap
