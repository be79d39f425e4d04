#include "contour/track/color_check.h"

#include <Eigen/Geometry>
#include <chrono>
#include <cmath>
#include <utility>

#include "contour/track/default_postures.h"
#include "contour/track/exchanged_sides.h"
#include "numerics/low_priority.h"

namespace markerless_mocap {
namespace {

constexpr double kMinGain = 0.01;       // of the score
constexpr double kOtherRotation = 0.3;  // radians; a joint that differs by more was wrong

double angleBetween(const Eigen::Matrix3d& one, const Eigen::Matrix3d& other) {
  return Eigen::AngleAxisd(one.transpose() * other).angle();
}

}  // namespace

std::optional<RegionFit> answered(const ColorQuestion& question) {
  constexpr size_t kLimbSearches = 1;  // of each list
  const ColorScene scene = question.scene();
  std::vector<RegionFit> fits = searchByColor(
      scene, {question.pose, withLegsSwapped(scene.body, question.pose)}, nullptr, kLimbSearches);
  const ContourObservation seen = scene.observer.observeLargest(scene.frame, scene.hull).seen;
  std::vector<RegionFit> others = searchProposalsByColor(
      scene, seen, question.proposals, fits.empty() ? nullptr : &fits.front(), kLimbSearches);
  if (!others.empty() && (fits.empty() || others.front().score() > fits.front().score() + kMinGain))
    fits = std::move(others);
  if (fits.empty()) return std::nullopt;
  return std::move(fits.front());
}

std::optional<RegionFit> preferred(const ColorScene& scene, const ContourPose& tracked,
                                   const ContourPose& rival) {
  const RegionFit own = fitByColor(scene, tracked);
  const RegionFit other = fitByColor(scene, rival);
  const bool is_fitted = own.fit.status == ContourFitStatus::kFitted;
  const bool rival_is_fitted = other.fit.status == ContourFitStatus::kFitted;
  if (rival_is_fitted && (!is_fitted || other.score() > own.score() + kMinGain)) return other;
  return is_fitted ? std::optional(own) : std::nullopt;
}

ColorQuestion completed(ColorQuestion question) {
  const ContourObservation seen =
      question.observer.observeLargest(question.frame, question.hull).seen;
  completeProposals(question.tracker, seen, question.body, question.hull, question.proposals);
  return question;
}

void ColorCheck::ask(ColorQuestion question, Urgency urgency) {
  forgotten_ = false;
  answer_ = std::async(std::launch::async, [question = std::move(question), urgency]() mutable {
    const auto find = [&] {
      const ContourPose asked = question.pose;
      return Answer{asked, answered(completed(std::move(question)))};
    };
    return urgency == kAwaited ? find() : unobtrusively(find);
  });
}

std::optional<ColorCheck::Answer> ColorCheck::answer() {
  if (!answer_.valid() || answer_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return std::nullopt;
  Answer answer = answer_.get();
  if (std::exchange(forgotten_, false)) return std::nullopt;
  return answer;
}

ContourPose broughtForward(const ContourPose& found, const ContourPose& asked,
                           const ContourPose& now) {
  ContourPose out = now;
  out.position += found.position - asked.position;
  for (size_t i = 0; i < out.rotations.size(); ++i)
    if (angleBetween(found.rotations[i], asked.rotations[i]) > kOtherRotation)
      out.rotations[i] = found.rotations[i];
  // The body may have turned since.
  constexpr size_t kRoot = SphericalJoint::kRoot;
  out.rotations[kRoot] =
      now.rotations[kRoot] * asked.rotations[kRoot].transpose() * found.rotations[kRoot];
  for (size_t i = 0; i < out.angles.size(); ++i)
    if (std::abs(found.angles[i] - asked.angles[i]) > kOtherRotation)
      out.angles[i] = found.angles[i];
  return out;
}

}  // namespace markerless_mocap
