#include "contour/shape_estimation.h"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <stdexcept>

#include "contour/measure/shape_equations.h"

namespace markerless_mocap {
namespace {

// As in the fit of a pose: 1/rad^2 and 1/m^2.
constexpr double kTurnDamping = 3.0, kMoveDamping = 100.0;
constexpr double kLongestTurn = 0.35, kLongestGrowth = 0.03;  // per step: rad or m, m

constexpr double kLeastSize = 0.004;  // of lengths and radii, metres

using Cholesky = Eigen::LLT<Eigen::MatrixXd>;

/// What of one instant is left when its pose is eliminated, and how to find the pose again.
struct ReducedShapeSystem {
  Eigen::MatrixXd H;  ///< of the estimated sizes
  Eigen::VectorXd g;
  Eigen::MatrixXd back;  ///< pose step = at_rest - back * size step
  Eigen::VectorXd at_rest;
};

class Estimation {
 public:
  Estimation(const CameraRig& rig, const ContourOptions& contour, const ShapePrior& prior,
             const ShapeParameters& start, const std::vector<ShapeSample>& instants,
             const ShapeEstimationOptions& options)
      : rig_(rig),
        contour_(contour),
        prior_(prior),
        options_(options),
        sizes_(start),
        stature_(prior.stature) {
    for (const ShapeSample& instant : instants) {
      poses_.push_back(instant.start);
      if (instant.seen.usableViews() >= 2)
        used_.push_back(&instant);
      else
        used_.push_back(nullptr);
    }
    for (int i = 0; i < kShapeParameterCount; ++i)
      if (prior.people.deviation[i] > 0) active_.push_back(i);
  }

  int usedCount() const {
    return int(std::count_if(used_.begin(), used_.end(), [](const auto* i) { return i; }));
  }

  ShapeEstimate run() {
    const RobustSchedule schedule{options_.iterations, options_.robust_scale_initial,
                                  options_.robust_scale_final};
    for (int i = 0; i < options_.iterations; ++i) step(robustScaleAt(schedule, i));
    return {sizes_, deviation_, stature_, poses_, usedCount()};
  }

 private:
  ReducedShapeSystem reduced(size_t instant, const ContourBody& body, double outlier) const;
  void addPrior(Eigen::MatrixXd& H, Eigen::VectorXd& g) const;
  void step(double outlier);

  const CameraRig& rig_;
  const ContourOptions& contour_;
  const ShapePrior& prior_;
  const ShapeEstimationOptions& options_;
  std::vector<const ShapeSample*> used_;  ///< null: too few views
  std::vector<int> active_;               ///< sizes that are estimated
  ShapeParameters sizes_, deviation_ = ShapeParameters::Zero();
  double stature_;
  std::vector<ContourPose> poses_;
};

ReducedShapeSystem Estimation::reduced(size_t instant, const ContourBody& body,
                                       double outlier) const {
  ShapeNormalEquations all = shapeNormalEquations(
      rig_, contour_, body, *used_[instant], poses_[instant], outlier, options_.point_deviation);
  all.H.diagonal().head<3>().array() += kMoveDamping;
  all.H.diagonal().segment<kContourDof - 3>(3).array() += kTurnDamping;
  const Eigen::Index n = Eigen::Index(active_.size());
  Eigen::MatrixXd mixed(kContourDof, n);
  ReducedShapeSystem out{Eigen::MatrixXd(n, n), Eigen::VectorXd(n), {}, {}};
  for (Eigen::Index i = 0; i < n; ++i) {
    const int at = kContourDof + active_[size_t(i)];
    mixed.col(i) = all.H.col(at).head<kContourDof>();
    out.g[i] = all.g[at];
    for (Eigen::Index j = 0; j < n; ++j) out.H(j, i) = all.H(kContourDof + active_[size_t(j)], at);
  }
  const Cholesky pose(all.H.topLeftCorner<kContourDof, kContourDof>());
  out.back = pose.solve(mixed);
  out.at_rest = -pose.solve(all.g.head<kContourDof>());
  out.H.noalias() -= mixed.transpose() * out.back;
  out.g.noalias() += mixed.transpose() * out.at_rest;
  return out;
}

/// Sizes are the template's times the stature, which is the last unknown. As errors of one
/// instant's contours are alike in the next, the prior counts once per instant.
void Estimation::addPrior(Eigen::MatrixXd& H, Eigen::VectorXd& g) const {
  const Eigen::Index last = Eigen::Index(active_.size());
  const double instants = usedCount();
  for (Eigen::Index i = 0; i < last; ++i) {
    const int size = active_[size_t(i)];
    const double deviation = prior_.people.deviation[size] * prior_.stature;
    const double weight = instants / (deviation * deviation), share = prior_.people.mean[size];
    const double off = sizes_[size] - share * stature_;
    H(i, i) += weight;
    H(i, last) -= weight * share;
    H(last, i) -= weight * share;
    H(last, last) += weight * share * share;
    g[i] += weight * off;
    g[last] -= weight * share * off;
  }
  const double weight = instants / (prior_.deviation * prior_.deviation);
  H(last, last) += weight;
  g[last] += weight * (stature_ - prior_.stature);
}

void Estimation::step(double outlier) {
  const ContourBody body(sizes_);
  std::vector<ReducedShapeSystem> parts(used_.size());
  tbb::parallel_for(size_t(0), used_.size(), [&](size_t i) {
    if (used_[i]) parts[i] = reduced(i, body, outlier);
  });
  const Eigen::Index n = Eigen::Index(active_.size());
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(n + 1, n + 1);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(n + 1);
  for (size_t i = 0; i < used_.size(); ++i) {
    if (!used_[i]) continue;
    H.topLeftCorner(n, n) += parts[i].H;
    g.head(n) += parts[i].g;
  }
  addPrior(H, g);
  const Cholesky all(H);
  const Eigen::VectorXd growth =
      Eigen::VectorXd(-all.solve(g)).cwiseMax(-kLongestGrowth).cwiseMin(kLongestGrowth);
  const Eigen::MatrixXd covariance = all.solve(Eigen::MatrixXd::Identity(n + 1, n + 1));
  for (Eigen::Index i = 0; i < n; ++i) {
    const int size = active_[size_t(i)];
    sizes_[size] += growth[i];
    if (!isOffset(size)) sizes_[size] = std::max(sizes_[size], kLeastSize);
    deviation_[size] = std::sqrt(covariance(i, i));
  }
  stature_ += growth[n];
  for (size_t i = 0; i < used_.size(); ++i) {
    if (!used_[i]) continue;
    const Eigen::VectorXd turn = parts[i].at_rest - parts[i].back * growth.head(n);
    poses_[i] = boxPlus(poses_[i], turn.cwiseMax(-kLongestTurn).cwiseMin(kLongestTurn));
  }
}

void check(const CameraRig& rig, const std::vector<ShapeSample>& instants, const ShapePrior& prior,
           const ShapeEstimationOptions& options) {
  if (options.iterations < 1 || !(options.robust_scale_final > 0) ||
      !(options.robust_scale_initial >= options.robust_scale_final) ||
      !(options.point_deviation > 0) || !(prior.deviation > 0) || !(prior.stature > 0))
    throw std::invalid_argument(
        "contour: an estimate of sizes needs at least one iteration, positive deviations and an "
        "outlier distance that does not grow");
  const Eigen::Index points = Eigen::Index(contourPointNames().size());
  for (const ShapeSample& instant : instants) {
    if (instant.seen.views.size() != rig.size())
      throw std::invalid_argument(
          "contour: an instant for the estimate of sizes is of another rig");
    if (!instant.start.isFinite())
      throw std::invalid_argument("contour: a pose to estimate sizes from is not finite");
    if (instant.known_points.cols() != 0 && instant.known_points.cols() != points)
      throw std::invalid_argument("contour: known points must be those of contourPointNames()");
  }
}

}  // namespace

ShapeEstimate estimateShape(const CameraRig& rig, const ContourOptions& contour,
                            const ShapePrior& prior, const ShapeParameters& start,
                            const std::vector<ShapeSample>& instants,
                            const ShapeEstimationOptions& options) {
  contour.validate();
  check(rig, instants, prior, options);
  Estimation estimation(rig, contour, prior, start, instants, options);
  if (estimation.usedCount() == 0)
    throw std::invalid_argument("contour: no instant has two masks to estimate sizes from");
  return estimation.run();
}

}  // namespace markerless_mocap
