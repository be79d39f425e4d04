#include "hsiao/fit/hsiao_refiner.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "numerics/segment.h"

namespace markerless_mocap {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Residuals are divided by their typical values in a good fit (metres), so that the weights are
// comparable.
constexpr double kTypicalCurve = 0.05;
constexpr double kTypicalSurface = 0.02;
constexpr double kTypicalOutside = 0.02;
// Surface voxels farther from the body than this have little weight: clothes, ghosts, carried
// objects.
constexpr double kSurfaceScale = 0.08;
constexpr double kCurveScale = 0.15;
// Step of the numeric derivative, metres and radians.
constexpr double kStep = 1e-5;
constexpr int kSphereStep = 3;
// Limbs of a smaller radius, in voxels, may be missing in the hull: fingers.
constexpr double kMinRadius = 1.0;

// The part of the model that a segment belongs to.
int partOf(int segment) {
  if (segment == kTorsoSegment) return int(PartLabel::kTorso);
  if (segment == kHeadSegment) return int(PartLabel::kHead);
  const PartLabel first = segment < kThighSegment ? PartLabel::kArm1 : PartLabel::kLeg1;
  return int(first) + (segment - kUpperArmSegment) % 2;
}

bool isArm(int part) {
  return part == int(PartLabel::kArm1) || part == int(PartLabel::kArm2);
}

// A point on the bones of a part: between node `bone` and the next one.
struct BonePlace {
  int bone;
  double fraction;
};

std::vector<BonePlace> nearestPlaces(const std::vector<HsiaoSegmentPoint>& bones,
                                     const HsiaoFrames& frames,
                                     const std::vector<Vector3d>& points) {
  std::vector<BonePlace> places;
  for (const Vector3d& point : points) {
    BonePlace nearest{0, 0.0};
    double min_distance = HUGE_VAL;
    for (int n = 0; n + 1 < int(bones.size()); ++n) {
      const Vector3d a = bones[n].inWorld(frames), ab = bones[n + 1].inWorld(frames) - a;
      const double fraction = nearestFraction(point, a, ab);
      const double distance = (a + fraction * ab - point).squaredNorm();
      if (distance >= min_distance) continue;
      min_distance = distance;
      nearest = {n, fraction};
    }
    places.push_back(nearest);
  }
  return places;
}

// Cauchy weight: 1 near zero, decreasing with the square beyond the scale.
double cauchyWeight(double deviation, double scale) {
  const double q = deviation / scale;
  return 1.0 / (1.0 + q * q);
}

}  // namespace

struct HsiaoRefiner::Problem {
  const HsiaoRefinerData* data;
  PartAssignment assignment;
  std::vector<Correspondence> surface;
  std::array<std::vector<double>, kPartCount> curve_weights;
  std::array<std::vector<BonePlace>, kPartCount> arm_places;
  std::vector<HsiaoInteriorSphere> spheres;
  int size = 0;

  // The model points for the samples of a data part. The visible length of fingers in a hull
  // varies, so the samples of an arm are matched to the nearest points of its bones, not by arc
  // length.
  void modelPoints(const HsiaoBodyModel& body_model, const HsiaoFrames& frames, int part,
                   std::vector<Vector3d>& out) const {
    const PartLabel model = PartLabel(assignment[part]);
    if (!isArm(part)) return data->curves->modelSamples(frames, PartLabel(part), model, out);
    out.clear();
    for (const BonePlace& place : arm_places[part]) {
      const Vector3d a = body_model.bones(model)[place.bone].inWorld(frames);
      const Vector3d b = body_model.bones(model)[place.bone + 1].inWorld(frames);
      out.push_back(a + place.fraction * (b - a));
    }
  }
};

HsiaoRefiner::HsiaoRefiner(const HsiaoBodyModel& body_model, const HsiaoBodyShape& shape,
                           const HsiaoRefinerSettings& settings)
    : body_model_(&body_model), shape_(&shape), settings_(settings) {}

void HsiaoRefiner::associate(const HsiaoFrames& frames, Problem& problem) const {
  problem.assignment =
      assignParts(problem.data->curves->matrix(frames, {true, true, true, true, true, true}));
  associateSurface(frames, problem);
  problem.spheres.clear();
  for (size_t i = 0; i < shape_->spheres().size(); i += kSphereStep)
    if (shape_->spheres()[i].radius > kMinRadius * problem.data->hull->lattice.pitch)
      problem.spheres.push_back(shape_->spheres()[i]);
  problem.size = int(problem.surface.size() + problem.spheres.size());
  for (int i = 0; i < kPartCount; ++i) associateCurve(frames, i, problem);
}

void HsiaoRefiner::associateSurface(const HsiaoFrames& frames, Problem& problem) const {
  const HsiaoRefinerData& data = *problem.data;
  std::vector<HsiaoWorldCone> cones;
  shape_->inWorld(frames, cones);
  const std::vector<uint32_t>& surface = data.field->surface();
  const size_t stride = std::max<size_t>(1, surface.size() / settings_.refinement_surface_points);
  const bool labelled = data.parts->labels.size() == data.hull->voxels.size();
  problem.surface.clear();
  for (size_t i = 0; i < surface.size(); i += stride) {
    const Vector3d point = data.hull->lattice.center(data.hull->voxels[surface[i]].index);
    const int label = labelled ? data.parts->labels[surface[i]] : int(PartLabel::kTorso);
    const int own = problem.assignment[label];
    const bool anywhere = own <= int(PartLabel::kTorso);
    int nearest = -1;
    double distance = HUGE_VAL;
    for (size_t c = 0; c < cones.size(); ++c) {
      const int part = partOf(shape_->cones()[c].segment);
      if (!anywhere && part != own && part != int(PartLabel::kTorso)) continue;
      const double d = cones[c].signedDistance(point);
      if (d >= distance) continue;
      distance = d;
      nearest = int(c);
    }
    problem.surface.push_back({point, nearest, cauchyWeight(distance, kSurfaceScale)});
  }
}

void HsiaoRefiner::associateCurve(const HsiaoFrames& frames, int part, Problem& problem) const {
  std::vector<double>& weights = problem.curve_weights[part];
  weights.clear();
  if (problem.assignment[part] < 0) return;
  const std::vector<Vector3d>& samples = problem.data->curves->samples(PartLabel(part));
  if (isArm(part))
    problem.arm_places[part] =
        nearestPlaces(body_model_->bones(PartLabel(problem.assignment[part])), frames, samples);
  std::vector<Vector3d> model;
  problem.modelPoints(*body_model_, frames, part, model);
  for (size_t k = 0; k < model.size(); ++k)
    weights.push_back(cauchyWeight((samples[k] - model[k]).norm(), kCurveScale));
  problem.size += 3 * int(model.size());
}

void HsiaoRefiner::residuals(const HsiaoVector& v, const Problem& problem, VectorXd& out) const {
  HsiaoFrames frames;
  body_model_->frames(v.data(), frames);
  thread_local std::vector<HsiaoWorldCone> cones;
  thread_local std::vector<Vector3d> model;
  shape_->inWorld(frames, cones);
  out.resize(problem.size);
  int row = 0;
  const double surface_scale = std::sqrt(1.0 / problem.surface.size()) / kTypicalSurface;
  for (const Correspondence& c : problem.surface)
    out[row++] = surface_scale * std::sqrt(c.weight) * cones[c.cone].signedDistance(c.point);
  const double inside_scale = std::sqrt(1.0 / problem.spheres.size()) / kTypicalOutside;
  for (const HsiaoInteriorSphere& sphere : problem.spheres)
    out[row++] = inside_scale *
                 std::max(0.0, problem.data->field->signedDistance(sphere.center.inWorld(frames)) +
                                   sphere.radius);
  for (int i = 0; i < kPartCount; ++i) {
    if (problem.assignment[i] < 0) continue;
    const std::vector<Vector3d>& samples = problem.data->curves->samples(PartLabel(i));
    problem.modelPoints(*body_model_, frames, i, model);
    const double scale = std::sqrt(1.0 / (kPartCount * samples.size())) / kTypicalCurve;
    for (size_t k = 0; k < samples.size(); ++k, row += 3)
      out.segment<3>(row) =
          scale * std::sqrt(problem.curve_weights[i][k]) * (samples[k] - model[k]);
  }
}

MatrixXd HsiaoRefiner::slopes(const HsiaoVector& v, const Problem& problem,
                              const VectorXd& here) const {
  MatrixXd slope(here.size(), kHsiaoParameterCount);
  VectorXd there;
  for (int p = 0; p < kHsiaoParameterCount; ++p) {
    HsiaoVector moved = v;
    moved[p] += kStep;
    residuals(moved, problem, there);
    slope.col(p) = (there - here) / kStep;
  }
  return slope;
}

HsiaoVector HsiaoRefiner::inRange(const HsiaoVector& wanted, const HsiaoBounds& range) const {
  HsiaoVector v = wanted.cwiseMax(range.lower).cwiseMin(range.upper);
  const Vector3d center = v.segment<3>(kHsiaoCenter);
  v.segment<3>(kHsiaoNeck) =
      center + body_model_->halfTorso() * (v.segment<3>(kHsiaoNeck) - center).normalized();
  return v;
}

HsiaoRefinement HsiaoRefiner::refine(const HsiaoVector& start, const HsiaoBounds& range,
                                     const HsiaoRefinerData& data) const {
  HsiaoRefinement best{start, HUGE_VAL};
  Problem problem;
  problem.data = &data;
  HsiaoFrames frames;
  VectorXd here, there;
  double damping = 1e-3;
  bool improved = true;
  for (int iteration = 0; iteration < settings_.iterations && improved; ++iteration) {
    body_model_->frames(best.v.data(), frames);
    associate(frames, problem);
    residuals(best.v, problem, here);
    best.cost = here.squaredNorm();
    const MatrixXd slope = slopes(best.v, problem, here);
    const Eigen::Matrix<double, kHsiaoParameterCount, kHsiaoParameterCount> A =
        slope.transpose() * slope;
    const HsiaoVector b = slope.transpose() * here;
    improved = false;
    for (int attempt = 0; attempt < 4 && !improved; ++attempt) {
      auto damped = A;
      damped.diagonal() += damping * A.diagonal() + HsiaoVector::Constant(1e-4);
      const HsiaoVector v = inRange(best.v - damped.ldlt().solve(b), range);
      residuals(v, problem, there);
      improved = there.squaredNorm() < best.cost;
      damping *= improved ? 0.3 : 5.0;
      if (improved) best = {v, there.squaredNorm()};
    }
  }
  return best;
}

}  // namespace markerless_mocap
