#include "segmentation/spline_propagation.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "segmentation/curves/least_squares_spline.h"

namespace markerless_mocap {
namespace {

// Lengths are relative to the start's distance from the origin.
constexpr double kMaxJump = 0.5;  // if no nodes are this near the end, the branch has ended
constexpr int kMinNodes = 8;      // for P and N
constexpr int kPieces = 5;
constexpr int kCurveSamples = 48;
constexpr int kMaxSteps = 400;

enum State : char { kFree, kWalked, kTaken };

class Walk {
 public:
  /// \param stop_distance from the origin
  Walk(const Eigen::MatrixXd& positions, SplineTermination stop, const SplineWalkOptions& options,
       double stop_distance, std::vector<char>* state, uint32_t start)
      : positions_(positions),
        stop_(stop),
        options_(options),
        stop_distance_(stop_distance),
        state_(*state),
        start_(start),
        reach_(positions.row(start).norm()) {}

  Branch run() {
    begin();
    for (int step = 0; step < kMaxSteps && !isOver(); ++step) {
      if (!propagate()) break;
    }
    return take();
  }

 private:
  bool isOver() const {
    if (stop_ == SplineTermination::kOrigin) return end_.norm() <= stop_distance_;
    return double(outliers()) > options_.max_outliers * double(positions_.rows());
  }

  size_t outliers() const {
    const LeastSquaresSpline fitted = curve();
    size_t count = 0;
    for (size_t i = 0; i < members_.size(); ++i) {
      const Eigen::VectorXd at = fitted.at((sites_[i] - low_) / range());
      if ((positions_.row(members_[i]).transpose() - at).norm() >
          options_.outlier_distance * reach_)
        ++count;
    }
    return count;
  }

  int nodeCount(double fraction) const {
    return std::max(kMinNodes, int(fraction * double(positions_.rows())));
  }

  std::vector<uint32_t> nearestFree(const Eigen::RowVectorXd& to, int count) const {
    const Eigen::VectorXd distance = (positions_.rowwise() - to).rowwise().squaredNorm();
    std::vector<uint32_t> nodes;
    for (uint32_t node = 0; node < state_.size(); ++node) {
      if (state_[node] == kFree) nodes.push_back(node);
    }
    const size_t kept = std::min(nodes.size(), size_t(count));
    std::partial_sort(nodes.begin(), nodes.begin() + kept, nodes.end(),
                      [&](uint32_t a, uint32_t b) {
                        return distance[a] != distance[b] ? distance[a] < distance[b] : a < b;
                      });
    nodes.resize(kept);
    return nodes;
  }

  Eigen::RowVectorXd meanOf(const std::vector<uint32_t>& nodes) const {
    Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(positions_.cols());
    for (const uint32_t node : nodes) mean += positions_.row(node);
    return mean / double(nodes.size());
  }

  Eigen::RowVectorXd principalDirection(const std::vector<uint32_t>& nodes) const {
    const Eigen::RowVectorXd mean = meanOf(nodes);
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(positions_.cols(), positions_.cols());
    for (const uint32_t node : nodes) {
      const Eigen::RowVectorXd offset = positions_.row(node) - mean;
      covariance += offset.transpose() * offset;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
    return solver.eigenvectors().col(positions_.cols() - 1).transpose();
  }

  /// Adds nodes with the site values of their projections on the direction; `from` has the site
  /// value `site`.
  void add(const std::vector<uint32_t>& nodes, const Eigen::RowVectorXd& from, double site) {
    for (const uint32_t node : nodes) {
      members_.push_back(node);
      sites_.push_back(site + (positions_.row(node) - from).dot(direction_));
      state_[node] = kWalked;
    }
    const auto [low, high] = std::minmax_element(sites_.begin(), sites_.end());
    low_ = *low;
    high_ = *high;
    end_ = curve().at(1.0).transpose();
  }

  double range() const { return std::max(high_ - low_, 1e-12); }

  LeastSquaresSpline curve() const {
    Eigen::VectorXd unit(Eigen::Index(members_.size()));
    Eigen::MatrixXd values(unit.size(), positions_.cols());
    for (size_t i = 0; i < members_.size(); ++i) {
      unit[Eigen::Index(i)] = (sites_[i] - low_) / range();
      values.row(Eigen::Index(i)) = positions_.row(members_[i]);
    }
    return {unit, values, kPieces};
  }

  void begin() {
    const Eigen::RowVectorXd from = positions_.row(start_);
    const std::vector<uint32_t> nodes = nearestFree(from, nodeCount(options_.initial_nodes) + 1);
    direction_ = principalDirection(nodes);
    if ((meanOf(nodes) - from).dot(direction_) < 0.0) direction_ *= -1.0;
    add(nodes, from, 0.0);
  }

  bool propagate() {
    const std::vector<uint32_t> nodes = nearestFree(end_, nodeCount(options_.step_nodes));
    if (nodes.empty() || (meanOf(nodes) - end_).norm() > kMaxJump * reach_) return false;
    Eigen::RowVectorXd turned = principalDirection(nodes);
    if (turned.dot(direction_) < 0.0) turned *= -1.0;
    if (turned.dot(direction_) < std::cos(options_.turn_angle)) direction_ = turned;
    add(nodes, end_, high_);
    return true;
  }

  /// Takes the free nodes near the curve, except those of the torso: near the origin, or beyond the
  /// curve's end.
  Branch take() {
    const LeastSquaresSpline fitted = curve();
    Branch branch{start_, {}};
    Eigen::VectorXd nearest = Eigen::VectorXd::Constant(positions_.rows(), 1e300);
    Eigen::VectorXd to_end;
    for (int i = 0; i < kCurveSamples; ++i) {
      const Eigen::RowVectorXd at = fitted.at(i / double(kCurveSamples - 1)).transpose();
      to_end = (positions_.rowwise() - at).rowwise().norm();
      if (i + 1 < kCurveSamples) nearest = nearest.cwiseMin(to_end);
    }
    for (uint32_t node = 0; node < state_.size(); ++node) {
      if (state_[node] == kTaken) continue;
      const bool beside = nearest[node] < options_.tube_radius * reach_;
      const bool outside = stop_ == SplineTermination::kOrigin
                               ? positions_.row(node).norm() > stop_distance_
                               : nearest[node] < to_end[node];
      state_[node] = node == start_ || (beside && outside) ? kTaken : kFree;
      if (state_[node] == kTaken) branch.nodes.push_back(node);
    }
    return branch;
  }

  const Eigen::MatrixXd& positions_;
  SplineTermination stop_;
  const SplineWalkOptions& options_;
  double stop_distance_;
  std::vector<char>& state_;
  uint32_t start_;
  double reach_;
  Eigen::RowVectorXd direction_;
  std::vector<uint32_t> members_;
  std::vector<double> sites_;
  double low_ = 0.0;
  double high_ = 0.0;
  Eigen::RowVectorXd end_;  ///< position of the spline's inner end
};

}  // namespace

std::vector<Branch> splinePropagationBranches(const Eigenmap& map, SplineTermination stop,
                                              int count, const SplineWalkOptions& options) {
  std::vector<char> state(size_t(map.vectors.rows()), kFree);
  const Eigen::VectorXd distance = map.vectors.rowwise().norm();
  const double stop_distance =
      options.stop_radius * (distance.size() > 0 ? distance.maxCoeff() : 0.0);
  std::vector<Branch> branches;
  while (int(branches.size()) < count && map.vectors.cols() > 0) {
    int start = -1;
    for (Eigen::Index node = 0; node < distance.size(); ++node) {
      if (state[node] == kFree && (start < 0 || distance[node] > distance[start]))
        start = int(node);
    }
    if (start < 0) break;
    branches.push_back(
        Walk(map.vectors, stop, options, stop_distance, &state, uint32_t(start)).run());
  }
  return branches;
}

}  // namespace markerless_mocap
