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

/// Result of the search in one frame.
struct FleischmannEstimate {
  PoseStatus status = PoseStatus::kLost;
  std::string reason;    ///< error message if lost
  FleischmannVector v;   ///< valid unless lost
  FitnessTerms fitness;  ///< of v
  int views = 0;         ///< number of views that show a person
  int evaluations = 0;   ///< number of fitness evaluations
};

/// Tracks one person from a given pose by comparing the drawn body with silhouettes and edges. Each
/// frame is searched around the last pose, within the range of the motion statistics (Fleischmann
/// 2012, 5.3). It cannot find a person without a start pose.
class FleischmannPoseEstimator {
 public:
  /// Throws std::invalid_argument if an option is out of range.
  FleischmannPoseEstimator(const CameraRig& rig, const FleischmannBodyModel& body_model,
                           const FleischmannBodyShape& body,
                           const FleischmannMotionStatistics& statistics,
                           const FleischmannOptions& options, const SwarmWatch& watch = nullptr);

  /// Sets the pose at a time without a search. The parameters should be within the limits.
  void start(int64_t stamp_ns, const FleischmannVector& v);
  /// Searches around a pose that is only approximately known, in rounds with decreasing range, and
  /// continues from the result. Keeps the last pose if nothing is found.
  /// \param views as for update()
  /// \param better_than the fitness must exceed this
  FleischmannEstimate reinitializeNear(int64_t stamp_ns, const FleischmannVector& v,
                                       const std::vector<FleischmannView>& views,
                                       double better_than = 0.0);
  /// Forgets all poses.
  void reset();
  /// \param stamp_ns capture time; the frame is lost if it is not later than the last one
  /// \param views one per camera; throws std::invalid_argument if they do not match the rig
  FleischmannEstimate update(int64_t stamp_ns, const std::vector<FleischmannView>& views);
  /// Start of the search at a time: the last pose plus the fraction `prediction` of its last
  /// change, scaled by time. Valid only after start().
  FleischmannVector predicted(int64_t stamp_ns) const;
  const FleischmannFitness& fitness() const { return fitness_; }

 private:
  struct Known {
    int64_t stamp_ns;
    FleischmannVector v;
  };
  SearchProblem problem() const;
  FleischmannVector withinLimits(const FleischmannVector& v) const;
  /// Error message if the last pose cannot be used; else empty.
  std::string updateError(int64_t stamp_ns, int views) const;
  /// \return the last particles, of a filter
  Eigen::MatrixXd search(SearchStart start, uint64_t seed, FleischmannEstimate& pose) const;
  /// Accepts the estimate if its fitness is sufficient.
  void accept(int64_t stamp_ns, FleischmannEstimate& pose);

  FleischmannFitness fitness_;
  LimbCollision collision_;
  FleischmannMotionStatistics statistics_;
  FleischmannOptions options_;
  FleischmannSearchPlan plan_;
  FleischmannLimits limits_;
  std::optional<Known> last_, before_;
  Eigen::MatrixXd particles_;  ///< of the last frame, with carry_particles
};

}  // namespace markerless_mocap
