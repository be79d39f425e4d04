#include "contour/self_calibration.h"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "contour/calibrate/self_calibration_equations.h"

namespace markerless_mocap {
namespace {

// As in the fit of a pose: 1/rad^2 and 1/m^2.
constexpr double kTurnDamping = 3.0, kMoveDamping = 100.0;
constexpr double kLongestTurn = 0.35;   // per step, rad or m
constexpr double kLongestShift = 10.0;  // per step, pixels

constexpr int kFewestInstants = 4;  // two for either half

// For the fits that judge: their starts fit the one rig or the other.
constexpr FitSchedule kJudging{12, 0.12, 0.03};

using Instants = std::vector<const PointingInstant*>;

/// What of one instant is left when its pose is eliminated, and how to find the pose again.
struct ReducedPointing {
  Eigen::MatrixXd H;
  Eigen::VectorXd g;
  Eigen::MatrixXd back;  ///< pose step = at_rest - back * shift
  Eigen::VectorXd at_rest;
  std::vector<size_t> explained;
};

/// The cameras' shifts that explain some instants.
class PointingEstimation {
 public:
  PointingEstimation(const CameraRig& rig, const ContourOptions& contour, const ContourBody& body,
                     const Instants& instants, const PointingOptions& options)
      : rig_(rig),
        contour_(contour),
        body_(body),
        instants_(instants),
        options_(options),
        pixels_(PointingPixels::Zero(Eigen::Index(2 * rig.size()))) {
    for (const PointingInstant* instant : instants) poses_.push_back(instant->start);
  }

  void run() {
    const FitSchedule schedule{options_.iterations, options_.outlier_first, options_.outlier_last};
    for (int i = 0; i < options_.iterations; ++i) step(outlierAt(schedule, i));
  }

  const PointingPixels& pixels() const { return pixels_; }
  /// \param disagreement of parts of the instants: of what is no scatter from one to the next
  std::vector<PointingCorrection> corrections(const PointingPixels& disagreement) const;

 private:
  std::vector<ReducedPointing> reducedInstants(double outlier) const;
  ReducedPointing reduced(const CameraRig& turned, size_t instant, double outlier) const;
  Eigen::MatrixXd prior() const {
    return Eigen::MatrixXd::Identity(pixels_.size(), pixels_.size()) /
           (options_.deviation_px * options_.deviation_px);
  }
  void step(double outlier);

  const CameraRig& rig_;
  const ContourOptions& contour_;
  const ContourBody& body_;
  const Instants& instants_;
  const PointingOptions& options_;
  PointingPixels pixels_;
  std::vector<ContourPose> poses_;
};

ReducedPointing PointingEstimation::reduced(const CameraRig& turned, size_t instant,
                                            double outlier) const {
  const ContourObservation seen = turnedObservation(instants_[instant]->seen, rig_, turned);
  PointingEquations all =
      pointingEquations(turned, contour_, body_, seen, poses_[instant], outlier);
  all.pose.H.diagonal().head<3>().array() += kMoveDamping;
  all.pose.H.diagonal().tail<kContourDof - 3>().array() += kTurnDamping;
  const Eigen::LLT<Eigen::MatrixXd> pose(all.pose.H);
  ReducedPointing out{all.H, all.g, pose.solve(all.mixed), -pose.solve(all.pose.g), all.explained};
  out.H.noalias() -= all.mixed.transpose() * out.back;
  out.g.noalias() += all.mixed.transpose() * out.at_rest;
  return out;
}

std::vector<ReducedPointing> PointingEstimation::reducedInstants(double outlier) const {
  const CameraRig turned = turnedRig(rig_, pixels_);
  std::vector<ReducedPointing> parts(instants_.size());
  tbb::parallel_for(size_t(0), parts.size(),
                    [&](size_t i) { parts[i] = reduced(turned, i, outlier); });
  return parts;
}

void PointingEstimation::step(double outlier) {
  const std::vector<ReducedPointing> parts = reducedInstants(outlier);
  Eigen::MatrixXd H = prior();
  Eigen::VectorXd g = prior() * pixels_;
  for (const ReducedPointing& part : parts) {
    H += part.H;
    g += part.g;
  }
  const Eigen::VectorXd shift = Eigen::VectorXd(-Eigen::LLT<Eigen::MatrixXd>(H).solve(g))
                                    .cwiseMax(-kLongestShift)
                                    .cwiseMin(kLongestShift);
  pixels_ += shift;
  for (size_t i = 0; i < parts.size(); ++i) {
    const Eigen::VectorXd turn = parts[i].at_rest - parts[i].back * shift;
    poses_[i] = moved(poses_[i], turn.cwiseMax(-kLongestTurn).cwiseMin(kLongestTurn));
  }
}

/// Deviations by the scatter of the instants' own wishes, which holds however the rays of one
/// instant hang together, by the prior, which is all there is where they wish nothing, and by the
/// disagreement.
std::vector<PointingCorrection> PointingEstimation::corrections(
    const PointingPixels& disagreement) const {
  Eigen::MatrixXd H = prior(), scatter = prior();
  std::vector<PointingCorrection> out(rig_.size());
  for (const ReducedPointing& part : reducedInstants(options_.outlier_last)) {
    H += part.H;
    scatter += part.g * part.g.transpose();
    for (size_t c = 0; c < rig_.size(); ++c) out[c].rays += part.explained[c];
  }
  const Eigen::LLT<Eigen::MatrixXd> inverse(H);
  const Eigen::MatrixXd covariance = inverse.solve(inverse.solve(scatter).transpose());
  for (size_t c = 0; c < rig_.size(); ++c) {
    const auto at = Eigen::Index(2 * c);
    out[c].camera = rig_[c].name();
    out[c].pixels = pixels_.segment<2>(at);
    const Eigen::Matrix3d& K = rig_[c].calibration().K;
    out[c].turn = std::hypot(out[c].pixels.x() / K(0, 0), out[c].pixels.y() / K(1, 1));
    out[c].deviation =
        (covariance.diagonal().segment<2>(at) + disagreement.segment<2>(at).cwiseAbs2())
            .cwiseSqrt();
  }
  return out;
}

/// An instant fitted with one rig.
struct Judged {
  ContourPose pose;
  PointingFit fit;
};

double limitedDistance(const PoseProblem& problem, double limit) {
  double sum = 0.0;
  for (const RayMatch& match : problem.matches()) {
    const double square = double(match.residual) * match.residual;
    sum += square / (1.0 + square / (limit * limit));
  }
  return std::sqrt(sum / std::max(1.0, double(problem.matches().size())));
}

/// Fits of instants with the rig turned so far; empty where there is none.
std::vector<std::optional<Judged>> judged(const CameraRig& rig, const ContourOptions& contour,
                                          const ContourBody& body, const Instants& instants,
                                          const PointingPixels& pixels) {
  const CameraRig turned = turnedRig(rig, pixels);
  const ContourFitter fitter(turned, contour);
  std::vector<std::optional<Judged>> fits(instants.size());
  tbb::parallel_for(size_t(0), instants.size(), [&](size_t i) {
    const ContourObservation seen = turnedObservation(instants[i]->seen, rig, turned);
    const ContourFit fit = fitter.fit(seen, body, instants[i]->start, std::nullopt, kJudging);
    if (fit.status != ContourFitStatus::kFitted) return;
    PoseProblem problem(seen, turned, contour);
    problem.evaluate(body, fit.pose, kJudging.outlier_last);
    fits[i] = Judged{fit.pose, {fit.overlap, limitedDistance(problem, kJudging.outlier_last)}};
  });
  return fits;
}

/// Means over pairs of fits, and whether the second ones are surely better.
void compare(const std::vector<std::optional<Judged>>& before,
             const std::vector<std::optional<Judged>>& after, PointingEstimate* out) {
  double gain = 0.0, squares = 0.0;
  for (size_t i = 0; i < before.size(); ++i) {
    if (!before[i] || !after[i]) continue;
    ++out->instants_used;
    out->before.overlap += before[i]->fit.overlap;
    out->before.distance += before[i]->fit.distance;
    out->after.overlap += after[i]->fit.overlap;
    out->after.distance += after[i]->fit.distance;
    const double one = before[i]->fit.distance - after[i]->fit.distance;
    gain += one;
    squares += one * one;
  }
  const double n = out->instants_used;
  if (n < kFewestInstants) return;
  for (PointingFit* fit : {&out->before, &out->after}) {
    fit->overlap /= n;
    fit->distance /= n;
  }
  const double variance = std::max(0.0, squares / n - gain * gain / (n * n)) / (n - 1);
  out->significance = gain / n / std::max(std::sqrt(variance), 1e-9);
}

void check(const CameraRig& rig, const std::vector<PointingInstant>& instants,
           const PointingOptions& options) {
  if (options.iterations < 1 || !(options.outlier_last > 0) ||
      !(options.outlier_first >= options.outlier_last) || !(options.deviation_px > 0) ||
      !(options.least_significance > 0) || !(options.least_gain >= 0))
    throw std::invalid_argument(
        "contour: an estimate of the cameras' pointing needs at least one iteration, positive "
        "deviations and an outlier distance that does not grow");
  for (const PointingInstant& instant : instants) {
    if (instant.seen.views.size() != rig.size())
      throw std::invalid_argument(
          "contour: an instant for the estimate of pointing is of another rig");
    if (!instant.start.isFinite())
      throw std::invalid_argument("contour: a pose to estimate pointing from is not finite");
  }
}

/// Each half of the instants, fitted with what the other half says of the cameras.
/// \param disagreement half of what both halves differ by
std::vector<std::optional<Judged>> judgedByOtherHalf(
    const CameraRig& rig, const ContourOptions& contour, const ContourBody& body,
    const Instants& instants, const PointingOptions& options, PointingPixels& disagreement) {
  const auto middle = instants.begin() + std::ptrdiff_t(instants.size() / 2);
  const Instants halves[2] = {{instants.begin(), middle}, {middle, instants.end()}};
  PointingPixels said[2];
  for (int half = 0; half < 2; ++half) {
    PointingEstimation estimation(rig, contour, body, halves[half], options);
    estimation.run();
    said[half] = estimation.pixels();
  }
  disagreement = 0.5 * (said[0] - said[1]);
  std::vector<std::optional<Judged>> fits;
  for (int half = 0; half < 2; ++half)
    for (auto& fit : judged(rig, contour, body, halves[half], said[1 - half]))
      fits.push_back(std::move(fit));
  return fits;
}

}  // namespace

PointingEstimate estimatePointing(const CameraRig& rig, const ContourOptions& contour,
                                  const ContourBody& body,
                                  const std::vector<PointingInstant>& instants,
                                  const PointingOptions& options) {
  contour.validate();
  check(rig, instants, options);
  PointingEstimate out;
  out.rig = rig;
  Instants usable;
  std::vector<size_t> places;
  for (size_t i = 0; i < instants.size(); ++i) {
    out.poses.push_back(instants[i].start);
    if (instants[i].seen.usableViews() < 2) continue;
    usable.push_back(&instants[i]);
    places.push_back(i);
  }
  out.instants_used = int(usable.size());
  if (out.instants_used < kFewestInstants) return out;

  const PointingPixels none = PointingPixels::Zero(Eigen::Index(2 * rig.size()));
  const auto before = judged(rig, contour, body, usable, none);
  out.instants_used = 0;
  PointingPixels disagreement;
  compare(before, judgedByOtherHalf(rig, contour, body, usable, options, disagreement), &out);
  if (out.instants_used < kFewestInstants) return out;

  PointingEstimation all(rig, contour, body, usable, options);
  all.run();
  out.corrections = all.corrections(disagreement);
  const bool gains = out.significance >= options.least_significance &&
                     out.after.distance <= (1.0 - options.least_gain) * out.before.distance &&
                     out.after.overlap >= out.before.overlap;
  out.status = gains ? PointingStatus::kCorrected : PointingStatus::kNoGain;
  if (gains) out.rig = turnedRig(rig, all.pixels());
  const auto fits = gains ? judged(rig, contour, body, usable, all.pixels()) : before;
  for (size_t i = 0; i < fits.size(); ++i)
    if (fits[i]) out.poses[places[i]] = fits[i]->pose;
  return out;
}

}  // namespace markerless_mocap
