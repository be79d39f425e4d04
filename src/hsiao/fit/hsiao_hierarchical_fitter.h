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
  int initial_headings = 2;   ///< number of start directions of the body
  bool as_published = false;  ///< the stages of Table 3-3 only
  double inertia = 0.6;
  double cognitive_weight = 1.5;
  double social_weight = 1.5;
};

/// Parameters and their skeleton error (Eq. 3-27, mean per part, metres).
struct HsiaoFit {
  HsiaoVector v;
  double error_m = 0.0;
};

/// Minimum and maximum of each parameter.
struct HsiaoBounds {
  HsiaoVector lower, upper;
};

/// Fits Hsiao's model to part curves by a hierarchical particle swarm (Hsiao 2008, 3.2.2.2), with
/// fine tuning part by part (3.2.2.4).
class HsiaoHierarchicalFitter {
 public:
  HsiaoHierarchicalFitter(const HsiaoBodyModel& body_model, const HsiaoFitterSettings& settings);

  /// Basic PSO: within the joint limits, one fit per initial heading, best first; as published,
  /// one fit.
  /// \param rest angles of parts that are not seen
  std::vector<HsiaoFit> fitBasic(const HsiaoSkeletonError& error, const HsiaoVector& rest,
                                 uint64_t seed) const;

  /// Temporal PSO: within the joint limits and a range around `last`.
  /// \param reach half the range of each parameter
  /// \param guesses further start positions (clamped to the range), which the published search
  ///   does not use
  HsiaoFit fitTemporal(const HsiaoSkeletonError& error, const HsiaoVector& last,
                       const HsiaoVector& reach, std::vector<HsiaoVector> guesses,
                       uint64_t seed) const;

  /// Joint limits; centre, neck and spin are not bounded.
  HsiaoBounds limits() const;

 private:
  using Active = std::array<bool, kPartCount>;
  using Parameters = std::vector<int>;
  struct Search;
  void search(const HsiaoSkeletonError& error, const Search& what, HsiaoVector& v) const;
  std::vector<HsiaoFit> fitHeadings(const HsiaoSkeletonError& error, HsiaoVector v,
                                    uint64_t seed) const;
  HsiaoFit follow(const HsiaoSkeletonError& error, const HsiaoBounds& range, HsiaoVector v,
                  std::vector<HsiaoVector> guesses, uint64_t seed) const;
  HsiaoFit fitStages(const HsiaoSkeletonError& error, const HsiaoBounds& allowed, HsiaoVector v,
                     uint64_t seed) const;
  HsiaoFit fitFromHeading(const HsiaoSkeletonError& error, HsiaoVector v, uint64_t seed) const;
  void initializeLimbs(const HsiaoSkeletonError& error, PartLabel first,
                       const std::array<Parameters, 2>& limbs, uint64_t seed, HsiaoVector& v) const;
  void fineTune(const HsiaoSkeletonError& error, const HsiaoBounds& range, uint64_t seed,
                HsiaoVector& v) const;
  double errorOf(const HsiaoSkeletonError& error, const HsiaoVector& v, const Active& active) const;

  const HsiaoBodyModel* body_model_;
  HsiaoFitterSettings settings_;
};

}  // namespace markerless_mocap
