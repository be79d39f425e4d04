#include "checks/motion/person_track.h"

#include <algorithm>
#include <cmath>

#include "checks/stamps/stream_times.h"

namespace markerless_mocap {
namespace {

constexpr double kBorder = 2.5;  // px
constexpr double kGap = 1.8;     // periods over which a pixel is interpolated
/// Cosine of the angle to the vertical above which a camera, looking down, does not see the highest
/// point of the body as the uppermost.
constexpr double kSteep = 0.6;

Eigen::Vector2d turned(const Eigen::Vector2d& pixel, const PersonTrack& track, ImageTurn turn) {
  Eigen::Vector2d out = pixel;
  if (turn != ImageTurn::kNone) out.x() = track.width - 1 - pixel.x();
  if (turn == ImageTurn::kUpsideDown) out.y() = track.height - 1 - pixel.y();
  return out;
}

Eigen::Vector2d upInFisheye(const Camera& camera, const Eigen::Vector2d& pixel) {
  constexpr double kStep = 0.01;  // m, at 1 m
  const Eigen::Vector3d seen = camera.position() + camera.rayDirection(pixel);
  const auto above = camera.project(seen + kStep * Eigen::Vector3d::UnitZ());
  return above ? Eigen::Vector2d((*above - pixel) / kStep) : Eigen::Vector2d::Zero();
}

/// The image direction in which the world's z rises at a pixel.
Eigen::Vector2d upAt(const CameraCalibration& camera, const Eigen::Vector2d& pixel) {
  if (camera.lens == LensType::kFisheye) return upInFisheye(Camera(camera), pixel);
  const Eigen::Vector3d up = camera.T_world_camera.linear().row(2).transpose();
  const Eigen::Vector2d plane((pixel.x() - camera.K(0, 2)) / camera.K(0, 0),
                              (pixel.y() - camera.K(1, 2)) / camera.K(1, 1));
  return {camera.K(0, 0) * (up.x() - plane.x() * up.z()),
          camera.K(1, 1) * (up.y() - plane.y() * up.z())};
}

bool isAtBorder(const Eigen::Vector2d& pixel, const PersonTrack& track) {
  return pixel.x() < kBorder || pixel.y() < kBorder || pixel.x() > track.width - 1 - kBorder ||
         pixel.y() > track.height - 1 - kBorder;
}

Eigen::Vector2d endOf(const Outline& outline, const PersonTrack& track,
                      const CameraCalibration& camera, ImageTurn turn, BodyEnd end) {
  const Eigen::Vector2d up = upAt(camera, turned(outline.centre, track, turn));
  const Eigen::Vector2d towards = end == BodyEnd::kUpper ? up : Eigen::Vector2d(-up);
  Eigen::Vector2d last(0, 0);
  double farthest = -HUGE_VAL;
  for (const Eigen::Vector2d& corner : outline.hull) {
    const Eigen::Vector2d pixel = turned(corner, track, turn);
    if (pixel.dot(towards) <= farthest) continue;
    farthest = pixel.dot(towards);
    last = pixel;
  }
  return last;
}

std::optional<Eigen::Vector2d> topOf(const Outline& outline, const PersonTrack& track,
                                     const CameraCalibration& camera, ImageTurn turn) {
  const Eigen::Vector2d top = endOf(outline, track, camera, turn, BodyEnd::kUpper);
  if (isAtBorder(top, track) || std::abs(camera.T_world_camera.linear()(2, 2)) > kSteep)
    return std::nullopt;
  return top;
}

}  // namespace

PersonTrack personTrackOf(const SeenCamera& camera, int64_t start_ns) {
  PersonTrack track;
  double newest = -HUGE_VAL;
  for (const SeenImage& image : camera.images) {
    const double seconds = 1e-9 * double(image.stamp_ns - start_ns);
    if (!image.outline || image.stamp_ns == 0 || seconds <= newest) continue;
    newest = seconds;
    track.seconds.push_back(seconds);
    track.outlines.push_back(&*image.outline);
    track.width = image.width;
    track.height = image.height;
  }
  track.period = timesOf(camera.images).period;
  return track;
}

Sight sightOf(const PersonTrack& track, const CameraCalibration& calibration, ImageTurn turn) {
  Sight sight;
  for (const Outline* outline : track.outlines) {
    const bool somebody = !outline->hull.empty();
    std::optional<Eigen::Vector2d> centre, top;
    if (somebody && !outline->cut) centre = turned(outline->centre, track, turn);
    if (somebody) top = topOf(*outline, track, calibration, turn);
    sight.pixels[int(BodyMark::kCentre)].push_back(centre);
    sight.pixels[int(BodyMark::kTop)].push_back(top);
  }
  return sight;
}

std::optional<bool> endsInside(const PersonTrack& track, const CameraCalibration& calibration,
                               ImageTurn turn, BodyEnd end, double seconds) {
  const auto next = std::lower_bound(track.seconds.begin(), track.seconds.end(), seconds);
  if (next == track.seconds.end() || *next - seconds > kGap * track.period) return std::nullopt;
  const Outline& outline = *track.outlines[size_t(next - track.seconds.begin())];
  if (outline.hull.empty()) return std::nullopt;
  return !isAtBorder(endOf(outline, track, calibration, turn, end), track);
}

std::optional<Eigen::Vector2d> pixelAt(const PersonTrack& track, const Sight& sight, BodyMark mark,
                                       double seconds) {
  const auto next = std::lower_bound(track.seconds.begin(), track.seconds.end(), seconds);
  if (next == track.seconds.begin() || next == track.seconds.end()) return std::nullopt;
  const size_t b = size_t(next - track.seconds.begin()), a = b - 1;
  const double step = track.seconds[b] - track.seconds[a];
  const auto& pixels = sight.pixels[int(mark)];
  if (step > kGap * track.period || !pixels[a] || !pixels[b]) return std::nullopt;
  return *pixels[a] + (seconds - track.seconds[a]) / step * (*pixels[b] - *pixels[a]);
}

}  // namespace markerless_mocap
