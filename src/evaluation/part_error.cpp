#include "evaluation/part_error.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

namespace markerless_mocap {
namespace {

constexpr double kBorder = 0.06;  // metres
constexpr double kHalf = 0.5;
using Counts = std::array<std::array<size_t, kTruePartCount>, kTruePartCount>;

/// Voxels of one frame with their true parts, indexed by lattice cell.
class TrueVoxels {
 public:
  TrueVoxels(const Eigen::Matrix3Xd& true_points, const SegmentedHull& hull)
      : pitch_(hull.pitch), voxels_(hull.voxels) {
    const PartTruth truth(true_points);
    for (Eigen::Index v = 0; v < voxels_.cols(); ++v) {
      parts_.push_back(truth.partAt(voxels_.col(v)));
      distal_.push_back(truth.isDistal(voxels_.col(v)));
      at_.emplace(keyOf(placeOf(v)), size_t(v));
    }
  }

  const std::vector<uint8_t>& parts() const { return parts_; }

  bool isFree() const {
    for (Eigen::Index v = 0; v < voxels_.cols(); ++v)
      for (const Eigen::Vector3i& step :
           {Eigen::Vector3i(1, 0, 0), Eigen::Vector3i(0, 1, 0), Eigen::Vector3i(0, 0, 1)})
        if (touches(size_t(v), placeOf(v) + step)) return false;
    return true;
  }

  /// Whether all voxels within kBorder belong to the same true part.
  bool isInside(size_t v) const {
    const int reach = int(kBorder / pitch_);
    const Eigen::Vector3i place = placeOf(Eigen::Index(v));
    for (int x = -reach; x <= reach; ++x)
      for (int y = -reach; y <= reach; ++y)
        for (int z = -reach; z <= reach; ++z) {
          if (Eigen::Vector3i(x, y, z).cast<double>().norm() * pitch_ > kBorder) continue;
          const auto other = at_.find(keyOf(place + Eigen::Vector3i(x, y, z)));
          if (other != at_.end() && parts_[other->second] != parts_[v]) return false;
        }
    return true;
  }

 private:
  Eigen::Vector3i placeOf(Eigen::Index v) const {
    const Eigen::Vector3d steps = (voxels_.col(v) - voxels_.col(0)) / pitch_;
    return {int(std::lround(steps.x())), int(std::lround(steps.y())), int(std::lround(steps.z()))};
  }

  static int64_t keyOf(const Eigen::Vector3i& place) {
    return ((int64_t(place.x()) & 0xfffff) << 40) | ((int64_t(place.y()) & 0xfffff) << 20) |
           (int64_t(place.z()) & 0xfffff);
  }

  bool touches(size_t v, const Eigen::Vector3i& place) const {
    const auto other = at_.find(keyOf(place));
    return other != at_.end() && parts_[other->second] != parts_[v] &&
           (distal_[v] || distal_[other->second]);
  }

  double pitch_;
  const Eigen::Matrix3Xd& voxels_;
  std::vector<uint8_t> parts_;
  std::vector<bool> distal_;
  std::unordered_map<int64_t, size_t> at_;
};

/// The label of each true part, with arms and legs in the order that fits better.
std::array<int, kTruePartCount> sidesThatFit(const Counts& counts) {
  std::array<int, kTruePartCount> label{0, 1, 2, 3, 4, 5};
  for (const size_t left : {size_t(2), size_t(4)})
    if (counts[left][left + 1] + counts[left + 1][left] >
        counts[left][left] + counts[left + 1][left + 1])
      std::swap(label[left], label[left + 1]);
  return label;
}

double overlapOf(const Counts& counts, size_t part, size_t label) {
  size_t both = counts[part][label], either = 0;
  for (size_t i = 0; i < kTruePartCount; ++i) either += counts[part][i] + counts[i][label];
  either -= both;
  return either == 0 ? 0.0 : double(both) / double(either);
}

double curveDistance(const PartTruth& truth, const Eigen::Matrix3Xd& curve, int part) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < curve.cols(); ++i) sum += truth.toAxis(curve.col(i), part);
  return curve.cols() ? 1000.0 * sum / double(curve.cols()) : NAN;
}

void checkHull(const SegmentedHull& hull) {
  const bool labelled = hull.labels.size() == size_t(hull.voxels.cols());
  if (!labelled || std::any_of(hull.labels.begin(), hull.labels.end(),
                               [](uint8_t label) { return label >= kTruePartCount; }))
    throw std::invalid_argument("a segmented hull needs one label below 6 for each voxel");
  if (hull.voxels.cols() > 0 && hull.pitch <= 0.0)
    throw std::invalid_argument("a segmented hull needs a pitch above 0");
}

double meanOf(const std::vector<double>& values) {
  return summaryStatistics(values).mean;
}

template <class Wanted>
PartStatistics figuresOf(const std::vector<PartEvaluation>& verdicts, const Wanted& wanted) {
  PartStatistics figures;
  std::vector<double> right, inside, six;
  for (const PartEvaluation& verdict : verdicts) {
    if (!verdict.evaluated || !wanted(verdict)) continue;
    ++figures.frames;
    right.push_back(verdict.fraction_correct);
    inside.push_back(verdict.fraction_correct_inside);
    six.push_back(verdict.all_six_correct);
  }
  figures.fraction_correct = meanOf(right);
  figures.worst_correct = right.empty() ? NAN : *std::min_element(right.begin(), right.end());
  figures.fraction_correct_inside = meanOf(inside);
  figures.fraction_all_six = meanOf(six);
  return figures;
}

SummaryStatistics curveSpread(const std::vector<PartEvaluation>& verdicts, size_t first,
                              size_t last) {
  std::vector<double> distances;
  for (const PartEvaluation& verdict : verdicts)
    for (size_t part = first; verdict.evaluated && part <= last; ++part)
      if (verdict.overlap[part] > kHalf) distances.push_back(verdict.curve_mm[part]);
  return summaryStatistics(distances);
}

}  // namespace

PartEvaluation evaluateParts(const Eigen::Matrix3Xd& true_points, const SegmentedHull& hull) {
  PartEvaluation verdict;
  verdict.curve_mm.fill(NAN);
  if (hull.voxels.cols() == 0 || !true_points.allFinite()) return verdict;
  verdict.evaluated = true;
  verdict.valid = hull.valid;
  const TrueVoxels voxels(true_points, hull);
  verdict.free = voxels.isFree();
  Counts counts{};
  for (size_t v = 0; v < hull.labels.size(); ++v) ++counts[voxels.parts()[v]][hull.labels[v]];
  const std::array<int, kTruePartCount> label = sidesThatFit(counts);
  size_t right = 0, inside = 0, right_inside = 0;
  for (size_t v = 0; v < hull.labels.size(); ++v) {
    const bool is_right = hull.labels[v] == label[voxels.parts()[v]];
    right += is_right;
    if (!voxels.isInside(v)) continue;
    ++inside;
    right_inside += is_right;
  }
  verdict.fraction_correct = double(right) / double(hull.labels.size());
  verdict.fraction_correct_inside = inside ? double(right_inside) / double(inside) : NAN;
  const PartTruth truth(true_points);
  verdict.all_six_correct = true;
  for (size_t part = 0; part < kTruePartCount; ++part) {
    const size_t named = size_t(label[part]);
    verdict.overlap[part] = overlapOf(counts, part, named);
    verdict.all_six_correct = verdict.all_six_correct && verdict.overlap[part] > kHalf;
    verdict.curve_mm[part] = curveDistance(truth, hull.curves[named], int(part));
  }
  return verdict;
}

PartErrors partErrors(const JointTrack& truth, const std::vector<SegmentedHull>& hulls) {
  if (truth.names != partTruthNames() || hulls.size() != truth.frames())
    throw std::invalid_argument("each segmented hull needs one frame of the truth with all points");
  PartErrors errors;
  for (size_t f = 0; f < hulls.size(); ++f) {
    checkHull(hulls[f]);
    errors.verdicts.push_back(evaluateParts(truth.positions[f], hulls[f]));
  }
  const std::vector<PartEvaluation>& verdicts = errors.verdicts;
  errors.all = figuresOf(verdicts, [](const PartEvaluation&) { return true; });
  errors.free = figuresOf(verdicts, [](const PartEvaluation& v) { return v.free; });
  errors.touching = figuresOf(verdicts, [](const PartEvaluation& v) { return !v.free; });
  errors.valid = figuresOf(verdicts, [](const PartEvaluation& v) { return v.valid; });
  errors.fraction_valid =
      errors.all.frames ? double(errors.valid.frames) / double(errors.all.frames) : NAN;
  errors.torso_mm = curveSpread(verdicts, 0, 0);
  errors.head_mm = curveSpread(verdicts, 1, 1);
  errors.arms_mm = curveSpread(verdicts, 2, 3);
  errors.legs_mm = curveSpread(verdicts, 4, 5);
  return errors;
}

}  // namespace markerless_mocap
