#include "checks/motion/check_motion.h"

#include <algorithm>
#include <cmath>

#include "checks/motion/check_framing.h"
#include "checks/motion/explanation.h"
#include "checks/motion/explanation_text.h"
#include "checks/motion/walked.h"
#include "checks/stamps/stream_times.h"
#include "checks/text/sentence.h"
#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

constexpr size_t kMoments = 160;
constexpr double kDisagree = 0.65;  // mean loss
constexpr size_t kFewOutlines = 30;
constexpr double kBody = 0.3;          // m from the middle of the body to where limbs are cut
constexpr double kMostOutside = 0.05;  // of the moments

/// Cameras that can take part, as numbers of the rig.
std::vector<size_t> usable(const SeenRig& rig) {
  std::vector<size_t> out;
  for (size_t i = 0; i < rig.cameras.size(); ++i) {
    const SeenCamera& camera = rig.cameras[i];
    const auto seen =
        std::count_if(camera.images.begin(), camera.images.end(), [](const auto& image) {
          return image.outline && !image.outline->hull.empty() && image.stamp_ns != 0;
        });
    const auto calibration = calibrationOf(camera);
    if (!calibration || size_t(seen) < kFewOutlines) continue;
    const SeenImage& image = camera.images.back();
    if (image.width == calibration->width && image.height == calibration->height) out.push_back(i);
  }
  return out;
}

RigSight sightOf(const SeenRig& rig, const std::vector<size_t>& cameras) {
  RigSight sight;
  int64_t start = 0;
  for (const size_t i : cameras) {
    const int64_t first = timesOf(rig.cameras[i].images).first_ns;
    start = start == 0 ? first : std::min(start, first);
  }
  std::vector<double> firsts, lasts;
  for (const size_t i : cameras) {
    sight.tracks.push_back(personTrackOf(rig.cameras[i], start));
    const PersonTrack& track = sight.tracks.back();
    for (size_t m = 0; m < track.seconds.size(); ++m)
      if (!track.outlines[m]->hull.empty()) {
        firsts.push_back(track.seconds[m]);
        break;
      }
    lasts.push_back(track.seconds.back());
  }
  const double from = nearestQuantile(firsts, 0.5), to = nearestQuantile(lasts, 0.5);
  for (size_t m = 0; m < kMoments && to > from; ++m)
    sight.moments.push_back(from + (to - from) * (double(m) + 0.5) / kMoments);
  return sight;
}

RigModel modelOf(const SeenRig& rig, const std::vector<size_t>& cameras) {
  RigModel model;
  for (const size_t i : cameras) {
    model.push_back({});
    model.back().calibration = *calibrationOf(rig.cameras[i]);
    model.back().offset = model.back().calibration.time_offset;
    model.back().source = model.size() - 1;
  }
  return model;
}

/// Where the person was, by all cameras; metres.
std::vector<std::optional<Eigen::Vector3d>> placesOf(const RigSight& sight, const RigModel& model) {
  std::vector<Rays> rays;
  for (const CameraModel& camera : model) rays.push_back(raysOf(sight, camera));
  return pointsOf(rays, {});
}

void checkVolume(const SeenRig& rig, const RigSight& sight, const RigModel& model,
                 Findings* findings) {
  if (rig.volume.isEmpty()) return;
  int seen = 0, outside = 0;
  Eigen::AlignedBox3d walked;
  const auto places = placesOf(sight, model);
  for (size_t at = 0; at + 1 < places.size(); at += kBodyMarks) {
    const auto& centre = places[at];
    const auto& top = places[at + 1];
    if (!centre || !top) continue;
    ++seen;
    walked.extend(Eigen::Vector3d(centre->x(), centre->y(), top->z()));
    const Eigen::Vector3d reach(kBody, kBody, 0);
    outside += !rig.volume.contains(Eigen::Vector3d(*centre + reach)) ||
               !rig.volume.contains(Eigen::Vector3d(*centre - reach)) ||
               top->z() > rig.volume.max().z();
  }
  if (seen < 20 || outside < kMostOutside * seen) return;
  const Eigen::Vector3d low = rig.volume.min(), high = rig.volume.max();
  findings->push_back(
      {"volume_cuts_person", "", Severity::kWarning,
       sentence(
           "in %.0f %% of the time a part of the person is outside of the volume: the middle of "
           "the body is at x %.1f to %.1f, y %.1f to %.1f m, the head up to %.1f m; the volume "
           "is x %.1f to %.1f, y %.1f to %.1f, z %.1f to %.1f m",
           100.0 * outside / seen, walked.min().x(), walked.max().x(), walked.min().y(),
           walked.max().y(), walked.max().z(), low.x(), high.x(), low.y(), high.y(), low.z(),
           high.z()),
       "set visual_hull/volume: auto, or volume_min and volume_max to hold this and an arm's "
       "length"});
}

/// Whether the silhouettes agree in most cameras, after all that explains why they might not.
bool checkAgreement(const std::vector<CameraState>& left, Findings* findings) {
  std::vector<double> losses, residuals;
  for (const CameraState& camera : left) {
    losses.push_back(camera.loss.loss);
    residuals.push_back(camera.loss.residual);
  }
  if (nearestQuantile(losses, 0.5) < kDisagree) return true;
  findings->push_back(
      {"silhouettes_disagree", "", Severity::kWarning,
       sentence("the cameras see the person %.0f px (of 640) from where the others see him, and no "
                "single mistake explains it",
                nearestQuantile(residuals, 0.5)),
       "look at the silhouettes first (mocap_offline --report): the empty room, furniture and "
       "other people spoil them. Whether the calibration holds, mocap_offline --self-calibrate "
       "tells also then, in degrees for each camera"});
  return false;
}

/// What cannot be judged where nobody walks.
void noteOneSpot(const std::vector<CameraState>& left, const std::vector<std::string>& names,
                 Findings* findings) {
  const double walked = walkedIn(left);
  if (walked >= kOneSpot) return;
  std::string seen;
  for (const CameraState& state : left)
    seen += sentence("%s%s %.0f", seen.empty() ? "" : ", ", names[state.camera].c_str(),
                     state.loss.residual);
  findings->push_back(
      {"person_stays", "", Severity::kNote,
       sentence("the person stays within %.2f m; px (of 640) between the person and where the "
                "other cameras see him: %s; small turns and lenses cannot be told there from what "
                "else the silhouettes hold",
                walked, seen.c_str()),
       "let one person walk through the room"});
}

}  // namespace

std::string motionNotChecked(const SeenRig& rig) {
  size_t calibrated = 0;
  for (const SeenCamera& camera : rig.cameras) calibrated += calibrationOf(camera).has_value();
  if (calibrated < 2)
    return "calibration and stamps were not compared with the images: fewer than two cameras have "
           "a calibration that can be used";
  if (usable(rig).size() < 2)
    return "calibration and stamps were not compared with the images: fewer than two cameras see "
           "somebody move";
  return "";
}

void checkMotion(const SeenRig& rig, Findings* findings) {
  if (!motionNotChecked(rig).empty()) return;
  const std::vector<size_t> cameras = usable(rig);
  const RigSight sight = sightOf(rig, cameras);
  if (sight.moments.empty()) return;
  std::vector<std::string> names;
  for (const size_t i : cameras) names.push_back(rig.cameras[i].name);
  RigModel model;
  std::vector<CameraState> left;
  const std::vector<Explanation> all = explain(sight, modelOf(rig, cameras), &model, &left);
  for (const Explanation& found : all) findings->push_back(findingOf(found, names));
  noteOneSpot(left, names, findings);
  checkFraming(sight, model, findings);
  if (checkAgreement(left, findings)) checkVolume(rig, sight, model, findings);
}

}  // namespace markerless_mocap
