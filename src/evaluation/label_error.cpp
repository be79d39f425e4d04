#include "markerless_mocap/evaluation/label_error.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr double kMillimetres = 1e3;  // in a metre
constexpr double kHeadLimit_mm = 250.0;
constexpr int kThresholds = 100;  // steps of the curve

/// An end's true points and how far from one of them it may be named.
struct TrueEnd {
  const char *point, *tip;
  double limit_mm;
};

constexpr TrueEnd kTrueEnds[kEndCount] = {{"head", "head_top", kHeadLimit_mm},
                                          {"l_hand", "l_hand_tip", kExtremityLimit_mm},
                                          {"r_hand", "r_hand_tip", kExtremityLimit_mm},
                                          {"l_foot", "l_foot_tip", kExtremityLimit_mm},
                                          {"r_foot", "r_foot_tip", kExtremityLimit_mm}};
enum EndIndex { kHead, kLeftHand, kRightHand, kLeftFoot, kRightFoot };

/// Distances in mm from a labelled end to the true ones, at their points and at the nearer of point
/// and tip.
struct Distances {
  std::array<double, kEndCount> to_point, to_either;
};

Distances distancesFrom(const Eigen::Vector3d& position, const Eigen::Matrix3Xd& truth) {
  Distances out;
  for (int end = 0; end < kEndCount; ++end) {
    out.to_point[size_t(end)] = kMillimetres * (position - truth.col(2 * end)).norm();
    const double to_tip = kMillimetres * (position - truth.col(2 * end + 1)).norm();
    out.to_either[size_t(end)] = std::min(out.to_point[size_t(end)], to_tip);
  }
  return out;
}

bool isRight(const Distances& distances, size_t end) {
  const auto& all = distances.to_either;
  const size_t nearest = size_t(std::min_element(all.begin(), all.end()) - all.begin());
  return nearest == end && all[end] <= kTrueEnds[end].limit_mm;
}

LabelVerdict judge(const LabelledEnds& labels, const Eigen::Matrix3Xd& truth) {
  LabelVerdict verdict;
  verdict.judged = truth.allFinite();
  verdict.error_mm.fill(NAN);
  if (!verdict.judged) return verdict;
  verdict.valid = labels.valid;
  verdict.complete = verdict.right = labels.positions.allFinite();
  std::array<Distances, kEndCount> distances;
  for (size_t end = 0; end < kEndCount; ++end) {
    const Eigen::Vector3d position = labels.positions.col(Eigen::Index(end));
    distances[end] = distancesFrom(position, truth);
    verdict.error_mm[end] = distances[end].to_point[end];
    verdict.end_right[end] = position.allFinite() && isRight(distances[end], end);
    verdict.right = verdict.right && verdict.end_right[end];
  }
  const auto rightSides = [&](size_t left, size_t right) {
    return distances[left].to_point[left] + distances[right].to_point[right] <=
           distances[left].to_point[right] + distances[right].to_point[left];
  };
  verdict.sides_right = rightSides(kLeftHand, kRightHand) && rightSides(kLeftFoot, kRightFoot);
  return verdict;
}

double ratio(size_t part, size_t whole) {
  return whole == 0 ? NAN : double(part) / double(whole);
}

/// A frame that is judged, with the labeller's estimate of it.
struct JudgedFrame {
  const LabelVerdict* verdict;
  double validity;
};
using JudgedFrames = std::vector<JudgedFrame>;
using FrameTest = std::function<bool(const JudgedFrame&)>;

size_t count(const JudgedFrames& frames, const FrameTest& test) {
  return size_t(std::count_if(frames.begin(), frames.end(), test));
}

bool isValid(const JudgedFrame& frame) {
  return frame.verdict->valid;
}

bool isValidAndRight(const JudgedFrame& frame) {
  return frame.verdict->valid && frame.verdict->right;
}

Spread errorsOf(const JudgedFrames& frames, const std::vector<size_t>& ends,
                const FrameTest& test) {
  std::vector<double> errors;
  for (const JudgedFrame& frame : frames)
    if (test(frame))
      for (const size_t end : ends) errors.push_back(frame.verdict->error_mm[end]);
  return spreadOf(errors);
}

void fillShares(const JudgedFrames& frames, LabelErrors* out) {
  const size_t right = count(frames, [](const JudgedFrame& f) { return f.verdict->right; });
  const size_t valid_right = count(frames, isValidAndRight);
  const size_t sides_right = count(
      frames, [](const JudgedFrame& f) { return f.verdict->valid && f.verdict->sides_right; });
  out->frames = frames.size();
  out->valid = count(frames, isValid);
  out->share_valid = ratio(out->valid, out->frames);
  out->share_right = ratio(right, out->frames);
  out->share_right_and_valid = ratio(valid_right, out->frames);
  out->share_wrong_but_valid = ratio(out->valid - valid_right, out->frames);
  out->share_sides_right = ratio(sides_right, out->valid);
}

void fillEnds(const JudgedFrames& frames, LabelErrors* out) {
  for (size_t end = 0; end < kEndCount; ++end) {
    const size_t right = count(frames, [end](const JudgedFrame& f) {
      return f.verdict->valid && f.verdict->end_right[end];
    });
    out->ends.push_back(
        {endNames()[end], ratio(right, out->valid), errorsOf(frames, {end}, isValid)});
  }
  out->hands_mm = errorsOf(frames, {kLeftHand, kRightHand}, isValid);
  out->feet_mm = errorsOf(frames, {kLeftFoot, kRightFoot}, isValid);
  out->hands_if_right_mm = errorsOf(frames, {kLeftHand, kRightHand}, isValidAndRight);
  out->feet_if_right_mm = errorsOf(frames, {kLeftFoot, kRightFoot}, isValidAndRight);
}

/// Complete frames of one validity.
struct Level {
  size_t right = 0, all = 0;
};

void fillCurve(const JudgedFrames& frames, LabelErrors* out) {
  std::map<double, Level, std::greater<double>> levels;  // by validity, highest first
  size_t right = 0;
  for (const JudgedFrame& frame : frames) {
    if (!frame.verdict->complete) continue;
    Level& level = levels[frame.validity];
    ++level.all;
    level.right += frame.verdict->right;
    right += frame.verdict->right;
  }
  Level reached;
  auto next = levels.begin();
  out->precision_recall_area = right == 0 ? NAN : 0.0;
  for (int i = kThresholds; i >= 0; --i) {
    const double threshold = double(i) / kThresholds;
    for (; next != levels.end() && (next->first >= threshold || i == 0); ++next) {
      reached.right += next->second.right;
      reached.all += next->second.all;
      out->precision_recall_area +=
          ratio(next->second.right, right) * ratio(reached.right, reached.all);
    }
    out->by_threshold.push_back(
        {threshold, ratio(reached.right, reached.all), ratio(reached.right, right)});
  }
  std::reverse(out->by_threshold.begin(), out->by_threshold.end());
}

}  // namespace

const std::array<const char*, kEndCount>& endNames() {
  static const std::array<const char*, kEndCount> names{"head", "left_hand", "right_hand",
                                                        "left_foot", "right_foot"};
  return names;
}

std::vector<std::string> labelTruthNames() {
  std::vector<std::string> names;
  for (const TrueEnd& end : kTrueEnds) {
    names.emplace_back(end.point);
    names.emplace_back(end.tip);
  }
  return names;
}

LabelErrors labelErrors(const JointTrack& truth, const std::vector<LabelledEnds>& labels) {
  if (labels.size() != truth.frames())
    throw std::invalid_argument("there are labels for " + std::to_string(labels.size()) +
                                " frames, the truth has " + std::to_string(truth.frames()));
  const JointTrack points = truth.select(labelTruthNames());
  LabelErrors out;
  for (size_t f = 0; f < labels.size(); ++f)
    out.verdicts.push_back(judge(labels[f], points.positions[f]));
  JudgedFrames frames;
  for (size_t f = 0; f < labels.size(); ++f)
    if (out.verdicts[f].judged) frames.push_back({&out.verdicts[f], labels[f].validity});
  fillShares(frames, &out);
  fillEnds(frames, &out);
  fillCurve(frames, &out);
  return out;
}

}  // namespace markerless_mocap
