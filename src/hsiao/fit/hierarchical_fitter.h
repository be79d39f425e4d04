#pragma once

#include <cstdint>
#include <vector>

#include "hsiao/model/hsiao_profile.h"
#include "hsiao/fit/skeleton_error.h"

namespace markerless_mocap {

/// Settings of the swarm stages.
struct FitterSettings {
  HsiaoLimits limits = HsiaoLimits::thesis();
  double particles_per_parameter = 2.0;
  double iterations_per_parameter = 1.5;
  int tune_particles = 16;
  int tune_iterations = 16;
  int spin_starts = 2;  ///< directions the body is first tried to face
};

/// Parameters and their skeleton error (Eq. 3-27, mean per part, metres).
struct ProfileFit {
  HsiaoVector v;
  double error_m = 0.0;
};

/// Lowest and highest value of each parameter.
struct HsiaoRange {
  HsiaoVector lower, upper;
};

/// Fits H's profile to part curves by swarms in stages that accumulate (Hsiao 2008, 3.2.2.2), and
/// fine-tunes part by part (3.2.2.4).
class HierarchicalFitter {
 public:
  HierarchicalFitter(const HsiaoProfile& profile, const FitterSettings& settings);

  /// Basic fits: joint limits only, one per facing direction, best first.
  /// \param rest angles of parts that are not seen
  std::vector<ProfileFit> fitAlone(const SkeletonError& error, const HsiaoVector& rest,
                                   uint64_t seed) const;

  /// Temporal fit: joint limits and a range around `last`.
  /// \param guesses where else particles start (moved inside the range)
  ProfileFit fitNear(const SkeletonError& error, const HsiaoVector& last, const HsiaoVector& reach,
                     std::vector<HsiaoVector> guesses, uint64_t seed) const;

  /// Joint limits; centre, neck and spin without bounds.
  HsiaoRange limits() const;

 private:
  using Active = std::array<bool, kPartCount>;
  using Parameters = std::vector<int>;
  struct Search;
  void search(const SkeletonError& error, const Search& what, HsiaoVector& v) const;
  ProfileFit fitFacing(const SkeletonError& error, HsiaoVector v, uint64_t seed) const;
  void guessLimbs(const SkeletonError& error, PartLabel first,
                  const std::array<Parameters, 2>& limbs, uint64_t seed, HsiaoVector& v) const;
  void tune(const SkeletonError& error, const HsiaoRange& range, uint64_t seed,
            HsiaoVector& v) const;
  double errorOf(const SkeletonError& error, const HsiaoVector& v, const Active& active) const;

  const HsiaoProfile* profile_;
  FitterSettings settings_;
};

}  // namespace markerless_mocap
