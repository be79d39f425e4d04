#include "studies/learn_contour_body/learn_contour_body.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <stdexcept>

#include "capture/ground_truth.h"
#include "contour/contour_urdf_converter.h"

namespace markerless_mocap {
namespace {

constexpr double kSecondsBetween = 0.5;  // between the frames of a motion

// Prior standard deviations around the hand-made shape: fractions of the parameter, and of the
// stature for offsets.
constexpr double kLengthDeviation = 0.3, kRadiusDeviation = 0.4, kOffsetDeviation = 0.02;

/// The n-th number of a sequence that is evenly distributed over 0 to 1 (van der Corput).
double evenly(int n, int base) {
  double value = 0.0, fraction = 1.0;
  for (; n > 0; n /= base) {
    fraction /= base;
    value += fraction * (n % base);
  }
  return value;
}

StudioOptions filmOf(const LearnOptions& options, int person, const std::string& motion) {
  StudioOptions studio;
  studio.motion = motion;
  studio.rig = "ring7_overhead";
  studio.volume_half_width = 3.0;
  studio.fps = 1.0 / kSecondsBetween;
  studio.duration = options.frame_sets * kSecondsBetween;
  studio.background_frames = 0;
  studio.character = exampleOf(person);
  return studio;
}

/// The contourPointNames() of the ground truth.
Eigen::Matrix3Xd knownPoints(const std::vector<Eigen::Vector3d>& truth) {
  const std::vector<std::string>&wanted = contourPointNames(), &given = groundTruthNames();
  Eigen::Matrix3Xd points(3, Eigen::Index(wanted.size()));
  for (size_t i = 0; i < wanted.size(); ++i) {
    const auto at = std::find(given.begin(), given.end(), wanted[i]);
    points.col(Eigen::Index(i)) = truth[size_t(at - given.begin())];
  }
  return points;
}

void addFrameSets(const VirtualStudio& studio, const LearnOptions& options,
                  const ContourObserver& observer, std::vector<ShapeSample>& frame_sets) {
  const ContourUrdfConverter conversion(std::make_shared<const BodyModel>(studio.body()));
  for (int i = 0; i < std::min(options.frame_sets, studio.frameSetCount()); ++i) {
    const StudioFrameSet now = studio.render(i);
    ShapeSample frame_set;
    frame_set.seen = observer.observe(now.masks);
    frame_set.start = conversion.poseOf(now.body.T_world_body, now.body.angles);
    frame_set.known_points = knownPoints(now.points);
    frame_sets.push_back(std::move(frame_set));
  }
}

ShapePrior freePrior(double stature) {
  ShapePrior prior;
  prior.shape_statistics = ShapeStatistics::handMade();
  prior.stature = stature;
  prior.deviation = 1e-4;  // the true stature is known
  ShapeParameters& deviation = prior.shape_statistics.deviation;
  for (int i = 0; i < kShapeParameterCount; ++i)
    deviation[i] = isOffset(i) ? kOffsetDeviation
                               : prior.shape_statistics.mean[i] *
                                     (i < BodyLength::kCount ? kLengthDeviation : kRadiusDeviation);
  for (const int kind : {BodyCone::kNeck, BodyCone::kHead})
    for (int end = 0; end < 2; ++end) deviation[offsetIndex(kind, end) + 1] = 0.0;
  return prior;
}

double jointError(const ShapeEstimate& estimate, const std::vector<ShapeSample>& frame_sets) {
  const ContourBody body(estimate.shape);
  double sum = 0.0;
  for (size_t i = 0; i < frame_sets.size(); ++i)
    sum += (body.points(estimate.poses[i]) - frame_sets[i].known_points)
               .leftCols(Eigen::Index(markerNames().size()))
               .colwise()
               .norm()
               .mean();
  return sum / double(frame_sets.size());
}

}  // namespace

CharacterOptions exampleOf(int person) {
  constexpr const char* kClothes[] = {"tight", "loose", "tight", "skirt"};
  CharacterOptions options;
  options.stature = 1.52 + 0.42 * evenly(person + 1, 2);
  options.male = evenly(person + 1, 3);
  options.bmi = 18.5 + 14.0 * evenly(person + 1, 5);
  options.clothes = options.male > 0.5 ? kClothes[person % 2] : kClothes[person % 4];
  options.appearance_seed = person;
  return options;
}

ShapeStatistics learnContourBody(const LearnOptions& options, std::ostream* notes) {
  if (options.people < 1 || options.frame_sets < 1 || options.motions.empty())
    throw std::invalid_argument("at least one person, one motion and one frame are needed");
  const ContourOptions contour;
  std::vector<ShapeParameters> shape;
  std::vector<double> statures;
  for (int person = 0; person < options.people; ++person) {
    std::vector<ShapeSample> frame_sets;
    CameraRig rig;
    for (const std::string& motion : options.motions) {
      if (options.interrupted()) throw std::runtime_error("interrupted");
      const VirtualStudio studio(filmOf(options, person, motion), options.files, "person1");
      rig = studio.rig();
      addFrameSets(studio, options, ContourObserver(rig, contour), frame_sets);
    }
    statures.push_back(exampleOf(person).stature);
    const ShapePrior prior = freePrior(statures.back());
    const ShapeEstimate estimate = estimateShape(
        rig, contour, prior, prior.shape_statistics.meanShape(prior.stature), frame_sets);
    shape.push_back(estimate.shape);
    if (notes)
      *notes << "person " << person + 1 << " of " << options.people << ": joints within "
             << std::fixed << std::setprecision(1) << 1e3 * jointError(estimate, frame_sets)
             << " mm on average\n";
  }
  return ShapeStatistics::fromPeople(shape, statures);
}

}  // namespace markerless_mocap
