#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fleischmann/fleischmann_fitness.h"
#include "fleischmann/fleischmann_motion_statistics.h"
#include "fleischmann/search/fleischmann_search_plan.h"
#include "markerless_mocap/fleischmann/fleischmann_options.h"
#include "markerless_mocap/products/body_pose.h"

namespace markerless_mocap {

/// What the search by images says about one instant.
struct FleischmannEstimate {
  PoseStatus status = PoseStatus::kLost;
  std::string reason;    ///< one sentence when lost
  FleischmannVector v;   ///< meaningful unless lost
  FitnessTerms fitness;  ///< of v
  int views = 0;         ///< that show a person
  int evaluations = 0;   ///< of the fitness
};

/// Follows one person from a pose that is given, by comparing the drawn body with silhouettes and
/// edges: each frame is searched about the last pose, as far as people move in its time
/// (Fleischmann 2012, 5.3). It never finds a person by itself.
class FleischmannPoseEstimator {
 public:
  /// Throws std::invalid_argument on options out of range.
  FleischmannPoseEstimator(const CameraRig& rig, const FleischmannBodyModel& profile,
                           const FleischmannBodyShape& body,
                           const FleischmannMotionStatistics& statistics,
                           const FleischmannOptions& options);

  /// The pose at an instant, which is taken as it is. The parameters should lie within the limits.
  void start(int64_t stamp_ns, const FleischmannVector& v);
  /// Looks for the person about a pose that is only roughly right, in rounds that search ever
  /// nearer to the best so far, and goes on from there. Keeps the last pose if nothing is found.
  /// \param views as for update() \param better_than fitness that must be surpassed
  FleischmannEstimate reinitializeNear(int64_t stamp_ns, const FleischmannVector& v,
                                       const std::vector<FleischmannView>& views,
                                       double better_than = 0.0);
  /// Forgets all poses.
  void reset();
  /// \param stamp_ns capture time, later than the last one, else the frame is lost
  /// \param views one for each camera; throws std::invalid_argument if they do not fit the rig
  FleischmannEstimate update(int64_t stamp_ns, const std::vector<FleischmannView>& views);
  /// Where a search at an instant starts: the last pose, and `prediction` of its last change gone
  /// on. Only after start().
  FleischmannVector predicted(int64_t stamp_ns) const;
  const FleischmannFitness& fitness() const { return fitness_; }

 private:
  struct Known {
    int64_t stamp_ns;
    FleischmannVector v;
  };
  SearchProblem problem() const;
  FleischmannVector withinLimits(const FleischmannVector& v) const;
  /// Why the last pose is of no use now; empty if it is.
  std::string updateError(int64_t stamp_ns, int views) const;
  void search(const SearchStart& start, uint64_t seed, FleischmannEstimate& pose) const;
  /// Goes on from a pose if it is good enough to be claimed.
  void take(int64_t stamp_ns, FleischmannEstimate& pose);

  FleischmannFitness fitness_;
  LimbCollision collision_;
  FleischmannMotionStatistics statistics_;
  FleischmannOptions options_;
  FleischmannSearchPlan plan_;
  FleischmannLimits limits_ = FleischmannLimits::anatomical();
  std::optional<Known> last_, before_;
};

}  // namespace markerless_mocap
