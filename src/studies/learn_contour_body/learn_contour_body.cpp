#include "studies/learn_contour_body/learn_contour_body.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <stdexcept>

#include "capture/truth.h"
#include "contour/contour_conversion.h"

namespace markerless_mocap {
namespace {

constexpr double kSecondsBetween = 0.5;  // instants of a motion

// To begin with, sizes may be anywhere near the hand-made ones: shares of the size, and of the
// stature for offsets.
constexpr double kLengthFreedom = 0.3, kRadiusFreedom = 0.4, kOffsetFreedom = 0.02;

/// The n-th of numbers that fill 0 to 1 evenly (van der Corput).
double evenly(int n, int base) {
  double value = 0.0, share = 1.0;
  for (; n > 0; n /= base) {
    share /= base;
    value += share * (n % base);
  }
  return value;
}

StudioOptions filmOf(const LearnOptions& options, int person, const std::string& motion) {
  StudioOptions studio;
  studio.motion = motion;
  studio.rig = "ring7_overhead";
  studio.stage = 3.0;
  studio.fps = 1.0 / kSecondsBetween;
  studio.duration = options.instants * kSecondsBetween;
  studio.background_frames = 0;
  studio.character = exampleOf(person);
  return studio;
}

/// contourPointNames() among the truth's.
Eigen::Matrix3Xd knownPoints(const std::vector<Eigen::Vector3d>& truth) {
  const std::vector<std::string>&wanted = contourPointNames(), &given = truthNames();
  Eigen::Matrix3Xd points(3, Eigen::Index(wanted.size()));
  for (size_t i = 0; i < wanted.size(); ++i) {
    const auto at = std::find(given.begin(), given.end(), wanted[i]);
    points.col(Eigen::Index(i)) = truth[size_t(at - given.begin())];
  }
  return points;
}

void addInstants(const VirtualStudio& studio, const LearnOptions& options,
                 const ContourObserver& observer, std::vector<SizeInstant>& instants) {
  const ContourConversion conversion(std::make_shared<const BodyModel>(studio.body()));
  for (int i = 0; i < std::min(options.instants, studio.instantCount()); ++i) {
    const StudioInstant now = studio.render(i);
    SizeInstant instant;
    instant.seen = observer.observe(now.masks);
    instant.start = conversion.poseOf(now.body.T_world_body, now.body.angles);
    instant.known_points = knownPoints(now.points);
    instants.push_back(std::move(instant));
  }
}

SizePrior freePrior(double stature) {
  SizePrior prior;
  prior.people = ContourTemplate::handMade();
  prior.stature = stature;
  prior.deviation = 1e-4;  // it is known
  ContourSizes& deviation = prior.people.deviation;
  for (int i = 0; i < kContourSizes; ++i)
    deviation[i] = isOffset(i) ? kOffsetFreedom
                               : prior.people.mean[i] *
                                     (i < ContourLength::kCount ? kLengthFreedom : kRadiusFreedom);
  for (const int kind : {ContourCone::kNeck, ContourCone::kHead})
    for (int end = 0; end < 2; ++end) deviation[offsetIndex(kind, end) + 1] = 0.0;
  return prior;
}

double jointError(const SizeEstimate& estimate, const std::vector<SizeInstant>& instants) {
  const ContourBody body(estimate.sizes);
  double sum = 0.0;
  for (size_t i = 0; i < instants.size(); ++i)
    sum += (body.points(estimate.poses[i]) - instants[i].known_points)
               .leftCols(Eigen::Index(markerNames().size()))
               .colwise()
               .norm()
               .mean();
  return sum / double(instants.size());
}

}  // namespace

CharacterOptions exampleOf(int person) {
  constexpr const char* kClothes[] = {"tight", "loose", "tight", "skirt"};
  CharacterOptions options;
  options.stature = 1.52 + 0.42 * evenly(person + 1, 2);
  options.male = evenly(person + 1, 3);
  options.bmi = 18.5 + 14.0 * evenly(person + 1, 5);
  options.clothes = options.male > 0.5 ? kClothes[person % 2] : kClothes[person % 4];
  options.look_seed = person;
  return options;
}

ContourTemplate learnContourBody(const LearnOptions& options, std::ostream* notes) {
  if (options.people < 1 || options.instants < 1 || options.motions.empty())
    throw std::invalid_argument("at least one person, one motion and one instant are needed");
  const ContourOptions contour;
  std::vector<ContourSizes> sizes;
  std::vector<double> statures;
  for (int person = 0; person < options.people; ++person) {
    std::vector<SizeInstant> instants;
    CameraRig rig;
    for (const std::string& motion : options.motions) {
      if (options.interrupted()) throw std::runtime_error("interrupted");
      const VirtualStudio studio(filmOf(options, person, motion), options.files, "person1");
      rig = studio.rig();
      addInstants(studio, options, ContourObserver(rig, contour), instants);
    }
    statures.push_back(exampleOf(person).stature);
    const SizePrior prior = freePrior(statures.back());
    const SizeEstimate estimate =
        estimateSizes(rig, contour, prior, prior.people.sizes(prior.stature), instants, {});
    sizes.push_back(estimate.sizes);
    if (notes)
      *notes << "person " << person + 1 << " of " << options.people << ": joints within "
             << std::fixed << std::setprecision(1) << 1e3 * jointError(estimate, instants)
             << " mm on average\n";
  }
  return ContourTemplate::ofPeople(sizes, statures);
}

}  // namespace markerless_mocap
