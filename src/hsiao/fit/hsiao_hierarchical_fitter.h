#pragma once

#include <cstdint>
#include <vector>

#include "hsiao/fit/hsiao_skeleton_error.h"
#include "hsiao/model/hsiao_body_model.h"

namespace markerless_mocap {

/// Settings of the swarm stages.
struct HsiaoFitterSettings {
  HsiaoLimits limits = HsiaoLimits::fromThesis();
  double particles_per_parameter = 2.0;
  double iterations_per_parameter = 1.5;
  int fine_tune_particles = 16;
  int fine_tune_iterations = 16;
  int initial_headings = 2;  ///< directions the body is first tried to face
};

/// Parameters and their skeleton error (Eq. 3-27, mean per part, metres).
struct HsiaoFit {
  HsiaoVector v;
  double error_m = 0.0;
};

/// Lowest and highest value of each parameter.
struct HsiaoBounds {
  HsiaoVector lower, upper;
};

/// Fits H's profile to part curves by swarms in stages that accumulate (Hsiao 2008, 3.2.2.2), and
/// fine-tunes part by part (3.2.2.4).
class HsiaoHierarchicalFitter {
 public:
  HsiaoHierarchicalFitter(const HsiaoBodyModel& profile, const HsiaoFitterSettings& settings);

  /// Basic fits: joint limits only, one per facing direction, best first.
  /// \param rest angles of parts that are not seen
  std::vector<HsiaoFit> fitBasic(const HsiaoSkeletonError& error, const HsiaoVector& rest,
                                 uint64_t seed) const;

  /// Temporal fit: joint limits and a range around `last`.
  /// \param guesses where else particles start (moved inside the range)
  HsiaoFit fitTemporal(const HsiaoSkeletonError& error, const HsiaoVector& last,
                       const HsiaoVector& reach, std::vector<HsiaoVector> guesses,
                       uint64_t seed) const;

  /// Joint limits; centre, neck and spin without bounds.
  HsiaoBounds limits() const;

 private:
  using Active = std::array<bool, kPartCount>;
  using Parameters = std::vector<int>;
  struct Search;
  void search(const HsiaoSkeletonError& error, const Search& what, HsiaoVector& v) const;
  HsiaoFit fitFromHeading(const HsiaoSkeletonError& error, HsiaoVector v, uint64_t seed) const;
  void initializeLimbs(const HsiaoSkeletonError& error, PartLabel first,
                       const std::array<Parameters, 2>& limbs, uint64_t seed, HsiaoVector& v) const;
  void fineTune(const HsiaoSkeletonError& error, const HsiaoBounds& range, uint64_t seed,
                HsiaoVector& v) const;
  double errorOf(const HsiaoSkeletonError& error, const HsiaoVector& v, const Active& active) const;

  const HsiaoBodyModel* profile_;
  HsiaoFitterSettings settings_;
};

}  // namespace markerless_mocap
