#include "motion/gait/gait_path.h"

#include <algorithm>
#include <cmath>

#include "motion/clip/sampled_signal.h"

namespace markerless_mocap {
namespace {

constexpr double kLead = 1.0;  ///< seconds sampled before the beginning and after the end
/// Seconds, standard deviation: a start or a stop takes twice it.
constexpr double kSoftness = 0.2;

/// \param fraction 0 at the move's beginning, 1 at its end
GroundPose along(const Move& move, const GroundPose& from, double fraction) {
  GroundPose place = from;
  const double turn = fraction * move.turn;
  if (move.kind == Move::Kind::kGo && std::abs(move.turn) > 1e-6) {
    const double radius = move.forward / move.turn;
    place = from.shifted(radius * std::sin(turn), radius * (1.0 - std::cos(turn)));
  } else {
    place = from.shifted(fraction * move.forward, fraction * move.left);
  }
  place.heading = from.heading + turn;
  return place;
}

}  // namespace

Eigen::Vector2d GroundPose::forward() const {
  return {std::cos(heading), std::sin(heading)};
}

Eigen::Vector2d GroundPose::left() const {
  return {-std::sin(heading), std::cos(heading)};
}

GroundPose GroundPose::shifted(double forward_metres, double left_metres) const {
  return {position + forward_metres * forward() + left_metres * left(), heading};
}

GaitPath::GaitPath(const MotionScript& script, double fps) : fps_(fps) {
  GroundPose place{{script.start_x, script.start_y}, script.start_heading};
  std::vector<GroundPose> starts;
  move_times_.push_back(0.0);
  for (const Move& move : script.path) {
    starts.push_back(place);
    place = along(move, place, 1.0);
    move_times_.push_back(move_times_.back() + move.seconds);
  }
  const int samples = int(std::ceil((script.seconds + 2.0 * kLead) * fps)) + 1;
  for (int i = 0; i < samples; ++i) {
    const double time = i / fps - kLead;
    GroundPose here = starts.empty() || time >= move_times_.back() ? place : starts.front();
    for (size_t m = 0; m < starts.size(); ++m) {
      const Move& move = script.path[m];
      if (time >= move_times_[m] && time < move_times_[m + 1])
        here = along(move, starts[m], (time - move_times_[m]) / move.seconds);
    }
    x_.push_back(here.position.x());
    y_.push_back(here.position.y());
    heading_.push_back(here.heading);
  }
  for (std::vector<double>* signal : {&x_, &y_, &heading_})
    *signal = smoothed(*signal, kSoftness * fps);
}

GroundPose GaitPath::at(double seconds) const {
  const double place = std::clamp((seconds + kLead) * fps_, 0.0, double(x_.size() - 1));
  const size_t i = std::min(size_t(place), x_.size() - 2);
  const double fraction = place - double(i);
  const auto mix = [&](const std::vector<double>& signal) {
    return (1.0 - fraction) * signal[i] + fraction * signal[i + 1];
  };
  return {{mix(x_), mix(y_)}, mix(heading_)};
}

}  // namespace markerless_mocap
