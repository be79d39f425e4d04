#include "skeleton/plausibility_checks.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace markerless_mocap {
namespace {

constexpr double kMinLitres = 8.0, kMaxLitres = 300.0;
constexpr size_t kMaxNodes = 4000;
constexpr int kMaxEnds = 300;
constexpr double kCell = 0.25;    // metres; no part of a body is two cells away from its skeleton
constexpr size_t kSample = 1000;  // approximate number of voxels that are tested
constexpr double kMaxOutOfReach = 0.1;  // fraction of the voxels

const char* const kTooManyBranches = "the skeleton has far more branches than a body";

std::string litresText(double litres, const char* what, double bound) {
  std::ostringstream text;
  text.precision(3);
  text << "the hull holds " << litres << " litres, " << what << " " << bound;
  return text.str();
}

/// The cells near a skeleton.
class Reach {
 public:
  explicit Reach(const TreeGraph& graph) {
    low_ = graph.positions.front();
    Eigen::Vector3d high = low_;
    for (const Eigen::Vector3d& p : graph.positions) {
      low_ = low_.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    low_.array() -= kCell;
    size_ =
        ((high - low_) / kCell).array().floor().matrix().cast<int>() + Eigen::Vector3i::Constant(2);
    cells_.assign(size_t(size_.prod()), false);
    Eigen::Vector3i last = Eigen::Vector3i::Constant(-1);
    for (const Eigen::Vector3d& p : graph.positions) {
      const Eigen::Vector3i cell = cellOf(p);
      if (cell != last) mark(cell);
      last = cell;
    }
  }

  bool contains(const Eigen::Vector3d& p) const {
    const Eigen::Vector3i c = cellOf(p);
    return (c.array() >= 0).all() && (c.array() < size_.array()).all() && cells_[placeOf(c)];
  }

 private:
  Eigen::Vector3i cellOf(const Eigen::Vector3d& p) const {
    return ((p - low_) / kCell).array().floor().matrix().cast<int>();
  }
  size_t placeOf(const Eigen::Vector3i& c) const {
    return (size_t(c.z()) * size_.y() + c.y()) * size_.x() + c.x();
  }
  void mark(const Eigen::Vector3i& c) {
    for (int code = 0; code < 27; ++code) {
      const Eigen::Vector3i at = c + Eigen::Vector3i(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
      if ((at.array() >= 0).all() && (at.array() < size_.array()).all()) cells_[placeOf(at)] = true;
    }
  }

  Eigen::Vector3d low_;
  Eigen::Vector3i size_;
  std::vector<bool> cells_;
};

}  // namespace

std::optional<Rejection> rejectHull(const VisualHull& hull) {
  if (hull.status == HullStatus::kSeveralBodies)
    return Rejection{TreeStatus::kNotAPerson, "the hull holds several bodies"};
  if (hull.voxels.empty())
    return Rejection{TreeStatus::kNoSkeleton, hull.reason.empty()
                                                  ? "the hull is empty"
                                                  : "there is no hull: " + hull.reason};
  const double litres = hull.litres();
  if (litres < kMinLitres)
    return Rejection{TreeStatus::kNoSkeleton,
                     litresText(litres, "a person has at least", kMinLitres)};
  if (litres > kMaxLitres)
    return Rejection{TreeStatus::kNotAPerson,
                     litresText(litres, "a person has at most", kMaxLitres)};
  return std::nullopt;
}

std::optional<Rejection> rejectSkeleton(const CurveSkeleton& skeleton) {
  if (skeleton.voxels.size() > kMaxNodes)
    return Rejection{TreeStatus::kNotAPerson, kTooManyBranches};
  return std::nullopt;
}

std::optional<Rejection> rejectSkeleton(const VisualHull& hull, const TreeGraph& graph) {
  if (graph.size() < 2)
    return Rejection{TreeStatus::kNoSkeleton, "the hull has no skeleton: it has no limbs"};
  std::vector<int> children(graph.size(), 0);
  for (size_t node = 1; node < graph.size(); ++node) ++children[size_t(graph.parents[node])];
  if (std::count(children.begin(), children.end(), 0) > kMaxEnds)
    return Rejection{TreeStatus::kNotAPerson, kTooManyBranches};
  const Reach reach(graph);
  size_t looked = 0, out = 0;
  for (size_t i = 0; i < hull.voxels.size(); i += hull.voxels.size() / kSample + 1) {
    ++looked;
    out += !reach.contains(hull.lattice.center(hull.voxels[i].index));
  }
  if (double(out) > kMaxOutOfReach * double(looked))
    return Rejection{TreeStatus::kNotAPerson,
                     "a part of the hull is not connected to the rest: there are several bodies"};
  return std::nullopt;
}

}  // namespace markerless_mocap
