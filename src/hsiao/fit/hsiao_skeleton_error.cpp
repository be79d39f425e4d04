#include "hsiao/fit/hsiao_skeleton_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

constexpr double kForbidden = std::numeric_limits<double>::infinity();

constexpr double kTorsoTrim = 0.15;
// Maximum shift of the torso's curve along its bone, metres: the boundaries to legs and neck vary.
constexpr double kTorsoSlide = 0.12;

std::vector<double> arcLengths(const std::vector<Vector3d>& line) {
  std::vector<double> along(line.size(), 0.0);
  for (size_t i = 1; i < line.size(); ++i) along[i] = along[i - 1] + (line[i] - line[i - 1]).norm();
  return along;
}

// Index of the section that contains `length` (the first or last one beyond the ends), and the
// fraction of it before `length`.
std::pair<int, double> locate(const std::vector<double>& along, double length) {
  int i = 0;
  while (i + 2 < int(along.size()) && along[i + 1] < length) ++i;
  const double stretch = along[i + 1] - along[i];
  return {i, stretch > 0 ? (length - along[i]) / stretch : 0.0};
}

// The section of a curve that is used, and its end along the bones; metres.
struct Span {
  double length, curve_end, bones_end;
};

// The ends of a torso's curve are cut off, since they bend towards adjacent limbs.
Span torsoSpan(double curve_length, double bones_length) {
  const double length = (1.0 - 2.0 * kTorsoTrim) * curve_length;
  return {length, (1.0 - kTorsoTrim) * curve_length, 0.5 * (bones_length + length)};
}

Span limbSpan(PartLabel part, double curve_length, double bones_length) {
  const bool arm = part == PartLabel::kArm1 || part == PartLabel::kArm2;
  const double bones_end = arm ? bones_length * (1.0 - kFingerShare) : bones_length;
  return {std::min(curve_length, bones_end), curve_length, bones_end};
}

// Parts that can be exchanged: arms with arms, legs with legs.
bool sameKind(size_t a, size_t b) {
  const auto kind = [](size_t part) { return part < 2 ? part : part / 2 + 1; };
  return kind(a) == kind(b);
}

// Node positions along the bones of a part in the zero pose, as arc lengths.
std::vector<double> boneLengths(const HsiaoBodyModel& body_model, PartLabel part) {
  const HsiaoVector zero = HsiaoVector::Zero();
  HsiaoFrames frames;
  body_model.frames(zero.data(), frames);
  std::vector<Vector3d> line;
  for (const HsiaoSegmentPoint& node : body_model.bones(part)) line.push_back(node.inWorld(frames));
  return arcLengths(line);
}

/// Merged legs are still divided between the two parts, while a merged arm ends early.
bool isUsable(PartLabel part, const PartCurve& curve) {
  const bool leg = part == PartLabel::kLeg1 || part == PartLabel::kLeg2;
  return curve.points.size() >= 2 && (curve.whole || (leg && curve.seen));
}

}  // namespace

double pairedDistance(const Vector3d* a, const Vector3d* b, int count) {
  double forward = 0.0, reversed = 0.0;
  for (int i = 0; i < count; ++i) {
    forward += (a[i] - b[i]).norm();
    reversed += (a[i] - b[count - 1 - i]).norm();
  }
  return std::min(forward, reversed) / count;
}

PartAssignment assignParts(const PartMatrix& error) {
  // best[set]: minimum sum for the data parts so far, assigned to the model parts in `set`.
  constexpr int kSets = 1 << kPartCount;
  std::array<double, kSets> best;
  std::array<std::array<int8_t, kSets>, kPartCount> chosen;
  best.fill(kForbidden);
  best[0] = 0.0;
  for (int i = 0; i < kPartCount; ++i) {
    const bool left_out = !(error.row(i).array() < kForbidden).any();
    std::array<double, kSets> next;
    next.fill(kForbidden);
    chosen[i].fill(-1);
    for (int set = 0; set < kSets; ++set) {
      if (best[set] == kForbidden) continue;
      if (left_out) next[set] = best[set];
      for (int j = 0; j < kPartCount && !left_out; ++j) {
        const double sum = best[set] + error(i, j);
        if ((set >> j & 1) || !(sum < next[set | 1 << j])) continue;
        next[set | 1 << j] = sum;
        chosen[i][set | 1 << j] = int8_t(j);
      }
    }
    best = next;
  }
  PartAssignment assignment;
  int set = int(std::min_element(best.begin(), best.end()) - best.begin());
  for (int i = kPartCount - 1; i >= 0; --i) {
    // NOLINTNEXTLINE(bugprone-signed-char-misuse): a number, no character
    assignment[i] = chosen[i][set];
    if (assignment[i] >= 0) set &= ~(1 << assignment[i]);
  }
  return assignment;
}

HsiaoSkeletonError::HsiaoSkeletonError(const HsiaoBodyModel& body_model, const BodyParts& parts,
                                       int samples, bool as_published)
    : body_model_(&body_model), as_published_(as_published) {
  for (int i = 0; i < kPartCount; ++i) {
    const PartCurve& part = parts.parts[i];
    if (as_published) sampleWholeBones(PartLabel(i), samples);
    if (as_published && part.seen && part.points.size() >= 2)
      setWholeCurve(PartLabel(i), part.points, samples);
    else if (!as_published && isUsable(PartLabel(i), part))
      setCurve(PartLabel(i), part.points, samples);
  }
}

void HsiaoSkeletonError::sampleWholeBones(PartLabel part, int samples) {
  const std::vector<double> along = boneLengths(*body_model_, part);
  const double length = limbSpan(part, 0.0, along.back()).bones_end;
  for (int k = 0; k < samples; ++k) {
    const auto [bone, fraction] = locate(along, length * k / (samples - 1));
    on_bones_[size_t(part)].push_back({bone, fraction});
  }
}

void HsiaoSkeletonError::setWholeCurve(PartLabel part, const std::vector<Vector3d>& curve,
                                       int samples) {
  const std::vector<double> along = arcLengths(curve);
  for (int k = 0; k < samples; ++k) {
    const auto [i, fraction] = locate(along, along.back() * k / (samples - 1));
    data_[size_t(part)].push_back(curve[i] + fraction * (curve[i + 1] - curve[i]));
  }
}

bool HsiaoSkeletonError::canPair(int data, int model,
                                 const std::array<bool, kPartCount>& active) const {
  return as_published_ ? active[size_t(model)] : sameKind(size_t(data), size_t(model));
}

void HsiaoSkeletonError::setCurve(PartLabel part, const std::vector<Vector3d>& curve, int samples) {
  const std::vector<double> curve_along = arcLengths(curve);
  const std::vector<double> bones_along = boneLengths(*body_model_, part);
  const double curve_length = curve_along.back(), bones_length = bones_along.back();
  const Span span = part == PartLabel::kTorso ? torsoSpan(curve_length, bones_length)
                                              : limbSpan(part, curve_length, bones_length);
  for (int k = 0; k < samples; ++k) {
    const double back = span.length * (1.0 - double(k) / (samples - 1));
    const auto [i, fraction] = locate(curve_along, span.curve_end - back);
    data_[size_t(part)].push_back(curve[i] + fraction * (curve[i + 1] - curve[i]));
    const auto [bone, bone_fraction] = locate(bones_along, span.bones_end - back);
    on_bones_[size_t(part)].push_back({bone, bone_fraction});
  }
}

const Vector3d& HsiaoSkeletonError::atNode(PartLabel part, int n) const {
  const BoneSamples& samples = on_bones_[size_t(part)];
  size_t k = 0;
  const auto before = [n](const BoneSample& s) { return s.bone + s.fraction < n; };
  while (k + 1 < samples.size() && before(samples[k])) ++k;
  return data_[size_t(part)][k];
}

void HsiaoSkeletonError::modelSamples(const HsiaoFrames& frames, PartLabel data, PartLabel model,
                                      std::vector<Vector3d>& out) const {
  std::array<Vector3d, 4> nodes;
  const std::vector<HsiaoSegmentPoint>& bones = body_model_->bones(model);
  for (size_t n = 0; n < bones.size(); ++n) nodes[n] = bones[n].inWorld(frames);
  out.clear();
  for (const BoneSample& s : on_bones_[size_t(as_published_ ? model : data)])
    out.push_back(nodes[s.bone] + s.fraction * (nodes[s.bone + 1] - nodes[s.bone]));
  if (as_published_ || data != PartLabel::kTorso) return;
  const Vector3d axis = (nodes[1] - nodes[0]).normalized();
  double slide = 0.0;
  for (size_t k = 0; k < out.size(); ++k) slide += axis.dot(data_[0][k] - out[k]) / out.size();
  for (Vector3d& point : out) point += std::clamp(slide, -kTorsoSlide, kTorsoSlide) * axis;
}

PartMatrix HsiaoSkeletonError::matrix(const HsiaoFrames& frames,
                                      const std::array<bool, kPartCount>& active) const {
  PartMatrix error = PartMatrix::Constant(kForbidden);
  thread_local std::vector<Vector3d> on_model;
  for (int i = 0; i < kPartCount; ++i) {
    if (!active[i] || data_[i].empty()) continue;
    for (int j = 0; j < kPartCount; ++j) {
      if (!canPair(i, j, active)) continue;
      modelSamples(frames, PartLabel(i), PartLabel(j), on_model);
      error(i, j) = pairedDistance(data_[i].data(), on_model.data(), int(on_model.size()));
    }
  }
  return error;
}

double HsiaoSkeletonError::operator()(const HsiaoFrames& frames,
                                      const std::array<bool, kPartCount>& active) const {
  const PartMatrix error = matrix(frames, active);
  const PartAssignment assignment = assignParts(error);
  double sum = 0.0;
  int count = 0;
  for (int i = 0; i < kPartCount; ++i) {
    if (assignment[i] < 0) continue;
    sum += error(i, assignment[i]);
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

}  // namespace markerless_mocap
