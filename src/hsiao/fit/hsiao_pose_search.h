#pragma once

#include <memory>
#include <optional>

#include "hsiao/fit/hsiao_hierarchical_fitter.h"
#include "hsiao/fit/hsiao_pose_validator.h"
#include "hsiao/fit/hsiao_refiner.h"

namespace markerless_mocap {

/// Finds poses in one frame: the swarms, then the refinement if the hull is used. Remembers where
/// arms were seen.
class HsiaoPoseSearch {
 public:
  HsiaoPoseSearch(const BodyModel& model, std::shared_ptr<const HsiaoBodyModel> body_model,
                  const HsiaoOptions& options);

  /// Basic PSO with several seeds, each fit refined; the best one.
  /// \param last last pose, if there is one
  HsiaoRefinement fitBasic(const HsiaoObservation& now, const std::optional<HsiaoVector>& last,
                           int attempts) const;
  /// The best fit of basic PSO with one seed.
  HsiaoFit fitBasicOnce(const HsiaoObservation& now, const HsiaoVector& last) const;
  /// Temporal PSO around `last`. \param before the pose before it, if it is known
  HsiaoFit fitTemporal(const HsiaoObservation& now, const HsiaoVector& last,
                       const std::optional<HsiaoVector>& before, double seconds) const;
  /// The fit refined by curves and hull; as it is if the hull is not used.
  HsiaoRefinement refine(const HsiaoObservation& now, const HsiaoFit& fit) const;
  /// A pose with all but root and angles: kTracked, or kLost with the reason.
  BodyPose validate(const HsiaoVector& v, const HsiaoObservation& now) const {
    return validator_.validate(v, now);
  }
  /// The same for a pose that does not follow a last one: kReinitialized, or kLost.
  BodyPose validateStart(const HsiaoObservation& now, const HsiaoVector& v) const;
  /// Whether the poses face opposite ways.
  bool areOpposite(const HsiaoVector& a, const HsiaoVector& b) const;

  void storeSeenArms(const HsiaoVector& v, const std::array<bool, kPartCount>& seen);
  void forgetArms();

 private:
  HsiaoVector restOf(const std::optional<HsiaoVector>& last) const;
  uint64_t seed() const { return uint64_t(options_.seed) * 1000003u; }

  HsiaoOptions options_;
  std::shared_ptr<const HsiaoBodyModel> body_model_;
  HsiaoBodyShape shape_;
  HsiaoHierarchicalFitter fitter_;
  HsiaoRefiner refiner_;
  HsiaoPoseValidator validator_;
  HsiaoVector arms_seen_;  ///< arm angles when each arm was last seen; other elements are unused
};

}  // namespace markerless_mocap
