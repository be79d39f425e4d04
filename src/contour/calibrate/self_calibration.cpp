#include "contour/self_calibration.h"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "contour/calibrate/self_calibration_equations.h"
#include "contour/fit/geman_mcclure.h"
#include "contour/model/pose_step.h"
#include "numerics/schur_complement.h"

namespace markerless_mocap {
namespace {

constexpr double kMaxShift = 10.0;  // per step, pixels

/// Of the refinement: outliers in metres.
constexpr RobustSchedule kRefinement{12, 0.08, 0.03};
/// Prior standard deviation of the camera orientations, pixels: an orientation that the contours do
/// not determine stays unchanged.
constexpr double kSigmaPx = 2.0;
/// The correction is applied if the gain is this many times its standard error over the frames, and
/// if the distance of the rays from the body decreases by this fraction at least.
constexpr double kMinSignificance = 4.0, kMinGain = 0.03;

constexpr int kMinSamples = 4;  // two for each half

// For validation: the start pose fits either the given or the corrected rig.
constexpr RobustSchedule kValidation{12, 0.12, 0.03};

using Samples = std::vector<const OrientationSample*>;

/// What one sample says about the shifts, after its pose is eliminated.
struct ReducedSample {
  ReducedNormalEquations equations;
  std::vector<size_t> explained;  ///< see OrientationNormalEquations
};

/// Estimates the image shifts of the cameras from a set of samples.
class OrientationRefiner {
 public:
  OrientationRefiner(const CameraRig& rig, const ContourOptions& contour, const ContourBody& body,
                     const Samples& samples)
      : rig_(rig),
        contour_(contour),
        body_(body),
        samples_(samples),
        pixels_(ImageShifts::Zero(Eigen::Index(2 * rig.size()))) {
    for (const OrientationSample* sample : samples) poses_.push_back(sample->start);
  }

  void run() {
    for (int i = 0; i < kRefinement.iterations; ++i) step(robustScaleAt(kRefinement, i));
  }

  const ImageShifts& pixels() const { return pixels_; }
  /// \param disagreement half the difference between the estimates of the two halves
  std::vector<OrientationCorrection> corrections(const ImageShifts& disagreement) const;

 private:
  std::vector<ReducedSample> reducedSamples(double outlier) const;
  ReducedSample reduced(const CameraRig& turned, size_t sample, double outlier) const;
  Eigen::MatrixXd prior() const {
    return Eigen::MatrixXd::Identity(pixels_.size(), pixels_.size()) / (kSigmaPx * kSigmaPx);
  }
  void step(double outlier);

  const CameraRig& rig_;
  const ContourOptions& contour_;
  const ContourBody& body_;
  const Samples& samples_;
  ImageShifts pixels_;
  std::vector<ContourPose> poses_;
};

ReducedSample OrientationRefiner::reduced(const CameraRig& turned, size_t sample,
                                          double outlier) const {
  const ContourObservation seen = rotatedObservation(samples_[sample]->seen, rig_, turned);
  OrientationNormalEquations all =
      orientationNormalEquations(turned, contour_, body_, seen, poses_[sample], outlier);
  dampPose(all.pose.H);
  return {ReducedNormalEquations({all.pose.H, all.pose.g, all.mixed, all.H, all.g}), all.explained};
}

std::vector<ReducedSample> OrientationRefiner::reducedSamples(double outlier) const {
  const CameraRig turned = rotatedRig(rig_, pixels_);
  std::vector<ReducedSample> parts(samples_.size());
  tbb::parallel_for(size_t(0), parts.size(),
                    [&](size_t i) { parts[i] = reduced(turned, i, outlier); });
  return parts;
}

void OrientationRefiner::step(double outlier) {
  const std::vector<ReducedSample> parts = reducedSamples(outlier);
  Eigen::MatrixXd H = prior();
  Eigen::VectorXd g = prior() * pixels_;
  for (const ReducedSample& part : parts) {
    H += part.equations.H();
    g += part.equations.g();
  }
  const Eigen::VectorXd shift = Eigen::VectorXd(-Eigen::LLT<Eigen::MatrixXd>(H).solve(g))
                                    .cwiseMax(-kMaxShift)
                                    .cwiseMin(kMaxShift);
  pixels_ += shift;
  for (size_t i = 0; i < parts.size(); ++i)
    poses_[i] = stepped(poses_[i], parts[i].equations.innerStep(shift));
}

/// The covariance has three parts: the scatter of the samples' gradients, which holds even if the
/// rays of one sample are correlated; the prior, for cameras without evidence; and the
/// disagreement.
std::vector<OrientationCorrection> OrientationRefiner::corrections(
    const ImageShifts& disagreement) const {
  Eigen::MatrixXd H = prior(), scatter = prior();
  std::vector<OrientationCorrection> out(rig_.size());
  for (const ReducedSample& part : reducedSamples(kRefinement.robust_scale_final)) {
    const Eigen::VectorXd& g = part.equations.g();
    H += part.equations.H();
    scatter += g * g.transpose();
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

/// Fit of one sample for validation.
struct ValidationFit {
  ContourPose pose;
  OrientationFit fit;
};

double limitedDistance(const PoseProblem& problem, double limit) {
  double sum = 0.0;
  for (const RayMatch& match : problem.matches()) sum += gemanMcClureLoss(match.residual, limit);
  return std::sqrt(sum / std::max(1.0, double(problem.matches().size())));
}

/// Fits all samples with the rig rotated so far; empty where a fit fails.
std::vector<std::optional<ValidationFit>> validationFits(const CameraRig& rig,
                                                         const ContourOptions& contour,
                                                         const ContourBody& body,
                                                         const Samples& samples,
                                                         const ImageShifts& pixels) {
  const CameraRig turned = rotatedRig(rig, pixels);
  const ContourFitter fitter(turned, contour);
  std::vector<std::optional<ValidationFit>> fits(samples.size());
  tbb::parallel_for(size_t(0), samples.size(), [&](size_t i) {
    const ContourObservation seen = rotatedObservation(samples[i]->seen, rig, turned);
    const ContourFit fit = fitter.fit(seen, body, samples[i]->start, std::nullopt, kValidation);
    if (fit.status != ContourFitStatus::kFitted) return;
    PoseProblem problem(seen, turned, contour);
    problem.evaluate(body, fit.pose, kValidation.robust_scale_final);
    fits[i] = ValidationFit{
        fit.pose, {fit.overlap, limitedDistance(problem, kValidation.robust_scale_final)}};
  });
  return fits;
}

/// Means over the pairs of fits, and the significance of the gain.
void compare(const std::vector<std::optional<ValidationFit>>& before,
             const std::vector<std::optional<ValidationFit>>& after, OrientationRefinement* out) {
  double gain = 0.0, squares = 0.0;
  for (size_t i = 0; i < before.size(); ++i) {
    if (!before[i] || !after[i]) continue;
    ++out->samples_used;
    out->before.overlap += before[i]->fit.overlap;
    out->before.distance += before[i]->fit.distance;
    out->after.overlap += after[i]->fit.overlap;
    out->after.distance += after[i]->fit.distance;
    const double one = before[i]->fit.distance - after[i]->fit.distance;
    gain += one;
    squares += one * one;
  }
  const double n = out->samples_used;
  if (n < kMinSamples) return;
  for (OrientationFit* fit : {&out->before, &out->after}) {
    fit->overlap /= n;
    fit->distance /= n;
  }
  const double variance = std::max(0.0, squares / n - gain * gain / (n * n)) / (n - 1);
  out->significance = gain / n / std::max(std::sqrt(variance), 1e-9);
}

void check(const CameraRig& rig, const std::vector<OrientationSample>& samples) {
  for (const OrientationSample& sample : samples) {
    if (sample.seen.views.size() != rig.size())
      throw std::invalid_argument(
          "contour: a sample for the refinement of camera orientations is of another rig");
    if (!sample.start.isFinite())
      throw std::invalid_argument(
          "contour: a start pose for the refinement of camera orientations is not finite");
  }
}

/// Cross-validation: fits each half of the samples with the rotations that the other half gives.
/// \param disagreement half the difference between the estimates of the two halves
std::vector<std::optional<ValidationFit>> crossValidationFits(const CameraRig& rig,
                                                              const ContourOptions& contour,
                                                              const ContourBody& body,
                                                              const Samples& samples,
                                                              ImageShifts& disagreement) {
  const auto middle = samples.begin() + std::ptrdiff_t(samples.size() / 2);
  const Samples halves[2] = {{samples.begin(), middle}, {middle, samples.end()}};
  ImageShifts estimated[2];
  for (int half = 0; half < 2; ++half) {
    OrientationRefiner estimation(rig, contour, body, halves[half]);
    estimation.run();
    estimated[half] = estimation.pixels();
  }
  disagreement = 0.5 * (estimated[0] - estimated[1]);
  std::vector<std::optional<ValidationFit>> fits;
  for (int half = 0; half < 2; ++half)
    for (auto& fit : validationFits(rig, contour, body, halves[half], estimated[1 - half]))
      fits.push_back(std::move(fit));
  return fits;
}

}  // namespace

OrientationRefinement refineCameraOrientations(const CameraRig& rig, const ContourOptions& contour,
                                               const ContourBody& body,
                                               const std::vector<OrientationSample>& samples) {
  contour.validate();
  check(rig, samples);
  OrientationRefinement out;
  out.rig = rig;
  Samples usable;
  std::vector<size_t> places;
  for (size_t i = 0; i < samples.size(); ++i) {
    out.poses.push_back(samples[i].start);
    if (samples[i].seen.usableViews() < 2) continue;
    usable.push_back(&samples[i]);
    places.push_back(i);
  }
  out.samples_used = int(usable.size());
  if (out.samples_used < kMinSamples) return out;

  const ImageShifts none = ImageShifts::Zero(Eigen::Index(2 * rig.size()));
  const auto before = validationFits(rig, contour, body, usable, none);
  out.samples_used = 0;
  ImageShifts disagreement;
  compare(before, crossValidationFits(rig, contour, body, usable, disagreement), &out);
  if (out.samples_used < kMinSamples) return out;

  OrientationRefiner all(rig, contour, body, usable);
  all.run();
  out.corrections = all.corrections(disagreement);
  const bool gains = out.significance >= kMinSignificance &&
                     out.after.distance <= (1.0 - kMinGain) * out.before.distance &&
                     out.after.overlap >= out.before.overlap;
  out.status =
      gains ? OrientationRefinementStatus::kCorrected : OrientationRefinementStatus::kNoGain;
  if (gains) out.rig = rotatedRig(rig, all.pixels());
  const auto fits = gains ? validationFits(rig, contour, body, usable, all.pixels()) : before;
  for (size_t i = 0; i < fits.size(); ++i)
    if (fits[i]) out.poses[places[i]] = fits[i]->pose;
  return out;
}

}  // namespace markerless_mocap
