#include "contour/shape_estimation.h"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "contour/measure/shape_equations.h"
#include "contour/model/pose_step.h"
#include "numerics/schur_complement.h"

namespace markerless_mocap {
namespace {

constexpr double kMaxGrowth = 0.03;  // metres per step

constexpr RobustSchedule kSchedule{15, 0.06, 0.03};  // outliers in metres
constexpr double kPointDeviation = 0.004;            // standard deviation of known points, metres
constexpr double kMinSize = 0.004;                   // minimum length and radius, metres

using Cholesky = Eigen::LLT<Eigen::MatrixXd>;

class Estimation {
 public:
  Estimation(const CameraRig& rig, const ContourOptions& contour, const ShapePrior& prior,
             const ShapeParameters& start, const std::vector<ShapeSample>& samples)
      : rig_(rig), contour_(contour), prior_(prior), shape_(start), stature_(prior.stature) {
    for (const ShapeSample& sample : samples) {
      poses_.push_back(sample.start);
      if (sample.seen.usableViews() >= 2)
        used_.push_back(&sample);
      else
        used_.push_back(nullptr);
    }
    for (int i = 0; i < kShapeParameterCount; ++i)
      if (prior.shape_statistics.deviation[i] > 0) active_.push_back(i);
  }

  int usedCount() const {
    return int(std::count_if(used_.begin(), used_.end(), [](const auto* i) { return i; }));
  }

  ShapeEstimate run() {
    for (int i = 0; i < kSchedule.iterations; ++i) step(robustScaleAt(kSchedule, i));
    return {shape_, deviation_, stature_, poses_, usedCount()};
  }

 private:
  /// The equations of one sample for the estimated parameters, after its pose is eliminated.
  ReducedNormalEquations reduced(size_t sample, const ContourBody& body, double outlier) const;
  void addPrior(Eigen::MatrixXd& H, Eigen::VectorXd& g) const;
  void step(double outlier);

  const CameraRig& rig_;
  const ContourOptions& contour_;
  const ShapePrior& prior_;
  std::vector<const ShapeSample*> used_;  ///< null if a sample has too few views
  std::vector<int> active_;               ///< parameters that are estimated
  ShapeParameters shape_, deviation_ = ShapeParameters::Zero();
  double stature_;
  std::vector<ContourPose> poses_;
};

ReducedNormalEquations Estimation::reduced(size_t sample, const ContourBody& body,
                                           double outlier) const {
  ShapeNormalEquations all = shapeNormalEquations(rig_, contour_, body, *used_[sample],
                                                  poses_[sample], outlier, kPointDeviation);
  dampPose(all.H);
  const Eigen::Index n = Eigen::Index(active_.size());
  PartedNormalEquations parts{all.H.topLeftCorner<kContourDof, kContourDof>(),
                              all.g.head<kContourDof>(), Eigen::MatrixXd(kContourDof, n),
                              Eigen::MatrixXd(n, n), Eigen::VectorXd(n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const int at = kContourDof + active_[size_t(i)];
    parts.mixed.col(i) = all.H.col(at).head<kContourDof>();
    parts.g[i] = all.g[at];
    for (Eigen::Index j = 0; j < n; ++j)
      parts.H(j, i) = all.H(kContourDof + active_[size_t(j)], at);
  }
  return ReducedNormalEquations(std::move(parts));
}

/// The prior mean of the parameters is the mean shape times the stature, which is the last unknown.
/// Errors of the contours are correlated between samples, so the prior counts once per sample.
void Estimation::addPrior(Eigen::MatrixXd& H, Eigen::VectorXd& g) const {
  const Eigen::Index last = Eigen::Index(active_.size());
  const double samples = usedCount();
  for (Eigen::Index i = 0; i < last; ++i) {
    const int size = active_[size_t(i)];
    const double deviation = prior_.shape_statistics.deviation[size] * prior_.stature;
    const double weight = samples / (deviation * deviation),
                 mean = prior_.shape_statistics.mean[size];
    const double off = shape_[size] - mean * stature_;
    H(i, i) += weight;
    H(i, last) -= weight * mean;
    H(last, i) -= weight * mean;
    H(last, last) += weight * mean * mean;
    g[i] += weight * off;
    g[last] -= weight * mean * off;
  }
  const double weight = samples / (prior_.deviation * prior_.deviation);
  H(last, last) += weight;
  g[last] += weight * (stature_ - prior_.stature);
}

void Estimation::step(double outlier) {
  const ContourBody body(shape_);
  std::vector<ReducedNormalEquations> parts(used_.size());
  tbb::parallel_for(size_t(0), used_.size(), [&](size_t i) {
    if (used_[i]) parts[i] = reduced(i, body, outlier);
  });
  const Eigen::Index n = Eigen::Index(active_.size());
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(n + 1, n + 1);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(n + 1);
  for (size_t i = 0; i < used_.size(); ++i) {
    if (!used_[i]) continue;
    H.topLeftCorner(n, n) += parts[i].H();
    g.head(n) += parts[i].g();
  }
  addPrior(H, g);
  const Cholesky all(H);
  const Eigen::VectorXd growth =
      Eigen::VectorXd(-all.solve(g)).cwiseMax(-kMaxGrowth).cwiseMin(kMaxGrowth);
  const Eigen::MatrixXd covariance = all.solve(Eigen::MatrixXd::Identity(n + 1, n + 1));
  for (Eigen::Index i = 0; i < n; ++i) {
    const int size = active_[size_t(i)];
    shape_[size] += growth[i];
    if (!isOffset(size)) shape_[size] = std::max(shape_[size], kMinSize);
    deviation_[size] = std::sqrt(covariance(i, i));
  }
  stature_ += growth[n];
  for (size_t i = 0; i < used_.size(); ++i)
    if (used_[i]) poses_[i] = stepped(poses_[i], parts[i].innerStep(growth.head(n)));
}

void check(const CameraRig& rig, const std::vector<ShapeSample>& samples, const ShapePrior& prior) {
  if (!(prior.deviation > 0) || !(prior.stature > 0))
    throw std::invalid_argument(
        "contour: the prior of the shape estimate needs a positive stature and deviation");
  const Eigen::Index points = Eigen::Index(contourPointNames().size());
  for (const ShapeSample& sample : samples) {
    if (sample.seen.views.size() != rig.size())
      throw std::invalid_argument("contour: a sample for the shape estimate is of another rig");
    if (!sample.start.isFinite())
      throw std::invalid_argument("contour: a start pose of the shape estimate is not finite");
    if (sample.known_points.cols() != 0 && sample.known_points.cols() != points)
      throw std::invalid_argument("contour: known points must be those of contourPointNames()");
  }
}

}  // namespace

ShapeEstimate estimateShape(const CameraRig& rig, const ContourOptions& contour,
                            const ShapePrior& prior, const ShapeParameters& start,
                            const std::vector<ShapeSample>& samples) {
  contour.validate();
  check(rig, samples, prior);
  Estimation estimation(rig, contour, prior, start, samples);
  if (estimation.usedCount() == 0)
    throw std::invalid_argument("contour: no sample for the shape estimate has two usable masks");
  return estimation.run();
}

}  // namespace markerless_mocap
