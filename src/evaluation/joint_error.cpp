#include "evaluation/joint_error.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

constexpr double kMillimetres = 1e3;  // per metre
constexpr double kSwapGain =
    0.7;  // a frame counts as swapped if exchanging sides lowers D below this fraction

double meanOfFinite(const std::vector<double>& values) {
  double sum = 0.0;
  size_t count = 0;
  for (const double value : values)
    if (std::isfinite(value)) sum += value, ++count;
  return count == 0 ? NAN : sum / double(count);
}

/// Mean distance over the columns that both have, mm.
double meanDistance(const Eigen::Matrix3Xd& difference) {
  double sum = 0.0;
  int count = 0;
  for (Eigen::Index i = 0; i < difference.cols(); ++i) {
    const double distance = difference.col(i).norm();
    if (std::isfinite(distance)) sum += distance, ++count;
  }
  return count == 0 ? NAN : kMillimetres * sum / count;
}

void checkPair(const JointTrack& truth, const JointTrack& estimate) {
  if (truth.names != estimate.names || truth.stamps_ns != estimate.stamps_ns)
    throw std::invalid_argument(
        "truth and estimate to compare must have the same frames and names");
}

/// Fraction of frames in which an exchange of the sides lowers D clearly.
double swapRate(const JointTrack& truth, const JointTrack& estimate) {
  std::vector<std::string> exchanged;
  for (const std::string& name : truth.names) exchanged.push_back(otherSide(name));
  const JointTrack swapped = estimate.select(exchanged);
  size_t estimated = 0, better = 0;
  for (size_t f = 0; f < truth.frames(); ++f) {
    const double D = meanDistance(estimate.positions[f] - truth.positions[f]);
    const double D_swapped = meanDistance(swapped.positions[f] - truth.positions[f]);
    if (!std::isfinite(D) || !std::isfinite(D_swapped)) continue;
    ++estimated;
    better += D_swapped < kSwapGain * D;
  }
  return estimated == 0 ? NAN : double(better) / double(estimated);
}

double limbSwapRate(const JointTrack& truth, const JointTrack& estimate,
                    const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const std::string& name : truth.names)
    for (const std::string& word : words)
      if (name.find(word) != std::string::npos) names.push_back(name);
  return swapRate(truth.select(names), estimate.select(names));
}

/// Axes of the truth's pelvis: y to the left hip, x forward, z up the spine; NaN if they are not
/// defined.
std::vector<Eigen::Matrix3d> pelvisFrames(const JointTrack& truth) {
  const JointTrack base = truth.select({"l_hip", "r_hip", "thorax", "pelvis"});
  std::vector<Eigen::Matrix3d> frames;
  for (const Eigen::Matrix3Xd& points : base.positions) {
    const Eigen::Vector3d y = (points.col(0) - points.col(1)).normalized();
    const Eigen::Vector3d up = points.col(2) - points.col(3);
    const Eigen::Vector3d x = y.cross(up).normalized();
    frames.emplace_back();
    frames.back() << x, y, x.cross(y);
  }
  return frames;
}

/// Mean of each column over the frames in which it is finite.
Eigen::Matrix3Xd meanColumns(const std::vector<Eigen::Matrix3Xd>& frames, Eigen::Index columns) {
  Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, columns);
  Eigen::VectorXd count = Eigen::VectorXd::Zero(columns);
  for (const Eigen::Matrix3Xd& frame : frames)
    for (Eigen::Index i = 0; i < columns; ++i)
      if (frame.col(i).allFinite()) sum.col(i) += frame.col(i), count[i] += 1.0;
  for (Eigen::Index i = 0; i < columns; ++i) sum.col(i) /= count[i];  // NaN without frames
  return sum;
}

/// Removes the constant offsets and fills the fields on them.
void separateOffsets(const JointTrack& truth, const JointTrack& estimate, JointErrors* errors) {
  const std::vector<Eigen::Matrix3d> pelvis = pelvisFrames(truth);
  const auto columns = Eigen::Index(truth.names.size());
  std::vector<Eigen::Matrix3Xd> local;
  for (size_t f = 0; f < truth.frames(); ++f)
    local.emplace_back(pelvis[f].transpose() * (estimate.positions[f] - truth.positions[f]));
  const Eigen::Matrix3Xd offset = meanColumns(local, columns);
  for (Eigen::Matrix3Xd& frame : local) {
    frame -= offset;
    errors->D_unbiased.push_back(meanDistance(frame));
  }
  const SummaryStatistics unbiased = summaryStatistics(errors->D_unbiased);
  errors->D_mean_unbiased = unbiased.mean;
  errors->D_max_unbiased = unbiased.max;
  for (Eigen::Index i = 0; i < columns; ++i) {
    std::vector<double> rest;
    for (const Eigen::Matrix3Xd& frame : local) rest.push_back(kMillimetres * frame.col(i).norm());
    errors->markers[i].offset_mm = kMillimetres * offset.col(i);
    errors->markers[i].mean_unbiased_mm = meanOfFinite(rest);
  }
}

MarkerError markerError(const std::string& name, const std::vector<double>& distances) {
  const SummaryStatistics spread = summaryStatistics(distances);
  MarkerError error;
  error.name = name;
  error.frames = spread.count;
  error.mean_mm = spread.mean;
  error.max_mm = spread.max;
  return error;
}

}  // namespace

SummaryStatistics summaryStatistics(const std::vector<double>& values) {
  std::vector<double> sorted;
  for (const double value : values)
    if (std::isfinite(value)) sorted.push_back(value);
  if (sorted.empty()) return {0, NAN, NAN, NAN, NAN, NAN};
  std::sort(sorted.begin(), sorted.end());
  const double mean = meanOfFinite(sorted);
  double squares = 0.0;
  for (const double value : sorted) squares += (value - mean) * (value - mean);
  return {sorted.size(),
          mean,
          std::sqrt(squares / double(sorted.size())),
          interpolatedQuantile(sorted, 0.5),
          interpolatedQuantile(sorted, 0.95),
          sorted.back()};
}

std::vector<std::vector<double>> markerDistances(const JointTrack& truth,
                                                 const JointTrack& estimate) {
  checkPair(truth, estimate);
  std::vector<std::vector<double>> distances(truth.names.size());
  for (size_t i = 0; i < distances.size(); ++i)
    for (size_t f = 0; f < truth.frames(); ++f)
      distances[i].push_back(kMillimetres *
                             (estimate.positions[f].col(i) - truth.positions[f].col(i)).norm());
  return distances;
}

JointErrors jointErrors(const JointTrack& truth, const JointTrack& estimate) {
  const auto distances = markerDistances(truth, estimate);
  JointErrors errors;
  errors.frames = truth.frames();
  for (size_t f = 0; f < truth.frames(); ++f)
    errors.D.push_back(meanDistance(estimate.positions[f] - truth.positions[f]));
  errors.D_spread = summaryStatistics(errors.D);
  errors.frames_estimated = errors.D_spread.count;
  size_t pairs = 0;
  for (size_t i = 0; i < distances.size(); ++i) {
    errors.markers.push_back(markerError(truth.names[i], distances[i]));
    pairs += errors.markers.back().frames;
  }
  errors.fraction_without_estimate = 1.0 - double(errors.frames_estimated) / double(errors.frames);
  errors.fraction_markers_missing =
      1.0 - double(pairs) / double(errors.frames_estimated * distances.size());
  separateOffsets(truth, estimate, &errors);
  errors.swaps = {swapRate(truth, estimate),
                  limbSwapRate(truth, estimate, {"shoulder", "elbow", "wrist"}),
                  limbSwapRate(truth, estimate, {"hip", "knee", "ankle"})};
  return errors;
}

ExtremityError extremityError(const JointTrack& truth, const JointTrack& estimate,
                              const std::string& name) {
  const std::vector<std::string> sides{"l_" + name, "r_" + name};
  const JointTrack real = truth.select(sides), found = estimate.select(sides);
  checkPair(real, found);
  std::vector<double> distances;
  size_t known = 0, right = 0;
  for (size_t f = 0; f < real.frames(); ++f)
    for (int side = 0; side < 2; ++side) {
      if (!real.positions[f].col(side).allFinite()) continue;
      ++known;
      const Eigen::Vector3d point = found.positions[f].col(side);
      const double own = kMillimetres * (point - real.positions[f].col(side)).norm();
      const double other = kMillimetres * (point - real.positions[f].col(1 - side)).norm();
      distances.push_back(own);
      right += own <= kExtremityLimit_mm && !(other < own);
    }
  return {name, summaryStatistics(distances), known == 0 ? NAN : double(right) / double(known)};
}

}  // namespace markerless_mocap
