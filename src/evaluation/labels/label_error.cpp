#include "evaluation/label_error.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

#include "evaluation/labels/label_evaluation.h"

namespace markerless_mocap {
namespace {

constexpr int kThresholds = 100;  // steps of the curve
constexpr size_t kBins = 10;      // of validity

double ratio(size_t part, size_t whole) {
  return whole == 0 ? NAN : double(part) / double(whole);
}

/// An evaluated frame and its validity.
struct EvaluatedFrame {
  const LabelEvaluation* verdict;
  double validity;
};
using JudgedFrames = std::vector<EvaluatedFrame>;
using FrameTest = std::function<bool(const EvaluatedFrame&)>;

size_t count(const JudgedFrames& frames, const FrameTest& test) {
  return size_t(std::count_if(frames.begin(), frames.end(), test));
}

bool isValid(const EvaluatedFrame& frame) {
  return frame.verdict->valid;
}

bool isValidAndRight(const EvaluatedFrame& frame) {
  return frame.verdict->valid && frame.verdict->right;
}

SummaryStatistics errorsOf(const JudgedFrames& frames, const std::vector<size_t>& ends,
                           const FrameTest& test) {
  std::vector<double> errors;
  for (const EvaluatedFrame& frame : frames)
    if (test(frame))
      for (const size_t end : ends) errors.push_back(frame.verdict->error_mm[end]);
  return summaryStatistics(errors);
}

void fillShares(const JudgedFrames& frames, LabelErrors* out) {
  const size_t right = count(frames, [](const EvaluatedFrame& f) { return f.verdict->right; });
  const size_t valid_right = count(frames, isValidAndRight);
  const size_t sides_correct = count(
      frames, [](const EvaluatedFrame& f) { return f.verdict->valid && f.verdict->sides_correct; });
  out->frames = frames.size();
  out->valid = count(frames, isValid);
  out->fraction_valid = ratio(out->valid, out->frames);
  out->fraction_correct = ratio(right, out->frames);
  out->fraction_correct_and_valid = ratio(valid_right, out->frames);
  out->fraction_wrong_but_valid = ratio(out->valid - valid_right, out->frames);
  out->fraction_kinds_correct = ratio(
      count(frames, [](const EvaluatedFrame& f) { return f.verdict->kinds_correct; }), out->frames);
  out->fraction_sides_correct = ratio(sides_correct, out->valid);
}

void fillEnds(const JudgedFrames& frames, LabelErrors* out) {
  for (size_t end = 0; end < kLabelledExtremityCount; ++end) {
    const size_t right = count(frames, [end](const EvaluatedFrame& f) {
      return f.verdict->valid && f.verdict->extremity_correct[end];
    });
    out->ends.push_back(
        {extremityNames()[end], ratio(right, out->valid), errorsOf(frames, {end}, isValid)});
  }
  out->hands_mm = errorsOf(frames, {kLeftHand, kRightHand}, isValid);
  out->feet_mm = errorsOf(frames, {kLeftFoot, kRightFoot}, isValid);
  out->hands_if_correct_mm = errorsOf(frames, {kLeftHand, kRightHand}, isValidAndRight);
  out->feet_if_correct_mm = errorsOf(frames, {kLeftFoot, kRightFoot}, isValidAndRight);
}

/// Counts of complete frames of one validity.
struct Level {
  size_t right = 0, all = 0;
};

void fillCurve(const JudgedFrames& frames, LabelErrors* out) {
  std::map<double, Level, std::greater<double>> levels;  // by validity, highest first
  size_t right = 0;
  for (const EvaluatedFrame& frame : frames) {
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

void fillReliability(const JudgedFrames& frames, LabelErrors* out) {
  struct Bin {
    double validities = 0.0;
    size_t frames = 0, right = 0;
  };
  std::array<Bin, kBins> bins;
  for (const EvaluatedFrame& frame : frames) {
    if (!frame.verdict->complete) continue;
    const double place = std::clamp(frame.validity, 0.0, 1.0) * double(kBins);
    Bin& bin = bins[std::min(size_t(place), kBins - 1)];
    bin.validities += frame.validity;
    ++bin.frames;
    bin.right += frame.verdict->right;
  }
  for (const Bin& bin : bins)
    if (bin.frames > 0)
      out->reliability.push_back(
          {bin.frames, bin.validities / double(bin.frames), ratio(bin.right, bin.frames)});
}

}  // namespace

LabelErrors labelErrors(const JointTrack& truth, const std::vector<LabelledExtremities>& labels) {
  if (labels.size() != truth.frames())
    throw std::invalid_argument("there are labels for " + std::to_string(labels.size()) +
                                " frames, the truth has " + std::to_string(truth.frames()));
  const JointTrack points = truth.select(labelTruthNames());
  LabelErrors out;
  for (size_t f = 0; f < labels.size(); ++f)
    out.verdicts.push_back(evaluateLabels(labels[f], points.positions[f]));
  JudgedFrames frames;
  for (size_t f = 0; f < labels.size(); ++f)
    if (out.verdicts[f].evaluated) frames.push_back({&out.verdicts[f], labels[f].validity});
  fillShares(frames, &out);
  fillEnds(frames, &out);
  fillCurve(frames, &out);
  fillReliability(frames, &out);
  return out;
}

}  // namespace markerless_mocap
