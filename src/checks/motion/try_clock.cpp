#include <algorithm>
#include <cmath>

#include "checks/motion/explanation.h"
#include "checks/stamps/stream_times.h"

namespace markerless_mocap {
namespace {

constexpr double kLargest = 1.0;  // s
constexpr size_t kParts = 5;      // of the recording
constexpr int kFewRays = 12;      // in a part
constexpr double kSharp = 0.03;   // gain of loss against other times that shows a time at all

/// The losses of all rays for a set of offsets.
class OffsetLosses {
 public:
  OffsetLosses(const RigSight& sight, const CameraModel& camera, const CameraState& state)
      : sight_(sight),
        camera_(camera),
        state_(state),
        pixels_(sightOf(sight.tracks[camera.source], camera.calibration, camera.turn)) {}

  void add(double offset) {
    CameraModel shifted = camera_;
    shifted.offset += offset;
    const Rays rays = raysOf(sight_, shifted, pixels_);
    std::vector<double> losses(rays.size(), NAN);
    for (size_t at = 0; at < rays.size(); ++at)
      if (rays[at] && state_.points[at] && state_.rays[at])
        losses[at] = lossOf(residualOf(*rays[at], *state_.points[at]));
    offsets_.push_back(offset);
    losses_.push_back(std::move(losses));
  }

  struct Best {
    double offset = 0, loss = 1, usual = 1;  ///< `usual`: median over all offsets
    int rays = 0;
  };
  /// The best offset for rays from..to-1, between the tried ones by a parabola.
  Best best(size_t from, size_t to) const {
    Best best;
    std::vector<double> means;
    for (const auto& losses : losses_) means.push_back(meanOf(losses, from, to, &best.rays));
    const size_t at = size_t(std::min_element(means.begin(), means.end()) - means.begin());
    best.offset = offsets_[at];
    best.loss = means[at];
    best.usual = quantile(means, 0.5);
    if (at == 0 || at + 1 == means.size()) return best;
    const double bend = means[at - 1] - 2 * means[at] + means[at + 1];
    if (bend > 0)
      best.offset +=
          0.5 * (means[at - 1] - means[at + 1]) / bend * (offsets_[at + 1] - offsets_[at]);
    return best;
  }

  void clear() {
    offsets_.clear();
    losses_.clear();
  }

 private:
  static double meanOf(const std::vector<double>& losses, size_t from, size_t to, int* rays) {
    double sum = 0;
    int count = 0;
    for (size_t at = from; at < to; ++at)
      if (std::isfinite(losses[at])) {
        sum += losses[at];
        ++count;
      }
    *rays = std::max(*rays, count);
    return count < kFewRays ? 1.0 : sum / count;
  }

  const RigSight& sight_;
  const CameraModel& camera_;
  const CameraState& state_;
  Sight pixels_;
  std::vector<double> offsets_;
  std::vector<std::vector<double>> losses_;
};

struct Part {
  double seconds, offset;
};

/// The offset of each part of the recording, where motion shows one.
std::vector<Part> offsetsOfParts(const OffsetLosses& losses, const RigSight& sight) {
  std::vector<Part> parts;
  const size_t moments = sight.moments.size();
  for (size_t part = 0; part < kParts; ++part) {
    const size_t from = part * moments / kParts, to = (part + 1) * moments / kParts;
    const OffsetLosses::Best best = losses.best(from * kBodyMarks, to * kBodyMarks);
    if (best.rays < kFewRays || best.usual - best.loss < kSharp) continue;
    parts.push_back({(sight.moments[from] + sight.moments[to - 1]) / 2, best.offset});
  }
  return parts;
}

double deviationOf(const std::vector<Part>& parts, double offset) {
  if (parts.size() < 3) return INFINITY;
  double sum = 0;
  for (const Part& part : parts) sum += std::pow(part.offset - offset, 2);
  return std::sqrt(sum / double(parts.size() - 1) / double(parts.size()));
}

struct Line {
  double slope = 0, deviation = INFINITY;
};
Line lineThrough(const std::vector<Part>& parts) {
  if (parts.size() < 4) return {};
  double time = 0, offset = 0, square = 0, product = 0, rest = 0;
  for (const Part& part : parts) {
    time += part.seconds / double(parts.size());
    offset += part.offset / double(parts.size());
  }
  for (const Part& part : parts) {
    square += std::pow(part.seconds - time, 2);
    product += (part.seconds - time) * (part.offset - offset);
  }
  Line line;
  line.slope = product / square;
  for (const Part& part : parts)
    rest += std::pow(part.offset - offset - line.slope * (part.seconds - time), 2);
  line.deviation = std::sqrt(rest / double(parts.size() - 2) / square);
  return line;
}

Explanation explanationOf(ExplanationKind kind, const RigModel& model, const CameraState& state) {
  Explanation tried;
  tried.kind = kind;
  tried.cameras = {state.camera};
  tried.model = model;
  tried.before = state.loss.residual;
  return tried;
}

void finish(const RigSight& sight, const CameraState& state, Explanation tried,
            std::vector<Explanation>* out) {
  const CameraLoss loss = lossOf(raysOf(sight, tried.model[state.camera]), state.points);
  tried.after = loss.residual;
  tried.gain = state.loss.rays * (state.loss.loss - loss.loss);
  out->push_back(std::move(tried));
}

void tryDrift(const RigSight& sight, const RigModel& model, const CameraState& state,
              const std::vector<Part>& parts, std::vector<Explanation>* out) {
  const Line line = lineThrough(parts);
  if (!(std::abs(line.slope) > 4 * line.deviation)) return;
  const double first = sight.tracks[model[state.camera].source].seconds.front();
  double at_first = 0;
  for (const Part& part : parts)
    at_first += (part.offset - line.slope * (part.seconds - first)) / double(parts.size());
  Explanation tried = explanationOf(ExplanationKind::kDrift, model, state);
  tried.model[state.camera].drift += line.slope;
  tried.model[state.camera].offset += at_first;
  tried.amount = line.slope;
  tried.deviation = line.deviation;
  finish(sight, state, std::move(tried), out);
}

}  // namespace

void tryClock(const RigSight& sight, const RigModel& model, const CameraState& state,
              std::vector<Explanation>* out) {
  const double period = sight.tracks[model[state.camera].source].period;
  if (period <= 0) return;
  const CameraModel& camera = model[state.camera];
  OffsetLosses losses(sight, camera, state);
  for (double offset = -kLargest; offset <= kLargest; offset += period) losses.add(offset);
  const size_t all = state.rays.size();
  const double coarse = losses.best(0, all).offset;
  if (losses.best(0, all).usual - losses.best(0, all).loss < kSharp) return;
  tryDrift(sight, model, state, offsetsOfParts(losses, sight), out);
  losses.clear();
  for (int i = -8; i <= 8; ++i) losses.add(coarse + i * period / 4);
  Explanation tried = explanationOf(ExplanationKind::kTimeOffset, model, state);
  tried.amount = losses.best(0, all).offset;
  tried.deviation = deviationOf(offsetsOfParts(losses, sight), tried.amount);
  tried.model[state.camera].offset += tried.amount;
  finish(sight, state, std::move(tried), out);
}

}  // namespace markerless_mocap
