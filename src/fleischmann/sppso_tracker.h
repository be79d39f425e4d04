#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fleischmann/appearance_fitness.h"
#include "markerless_mocap/products/body_pose.h"
#include "fleischmann/motion_statistics.h"
#include "markerless_mocap/fleischmann/sppso_options.h"
#include "fleischmann/search/sppso_plan.h"

namespace markerless_mocap {

/// What the search by images says about one instant.
struct SppsoPose {
  PoseStatus status = PoseStatus::kLost;
  std::string reason;   ///< one sentence when lost
  FleischmannVector v;  ///< meaningful unless lost
  Fitness fitness;      ///< of v
  int views = 0;        ///< that show a person
  int evaluations = 0;  ///< of the fitness
};

/// Follows one person from a pose that is given, by comparing the drawn body with silhouettes and
/// edges: each frame is searched about the last pose, as far as people move in its time
/// (Fleischmann 2012, 5.3). It never finds a person by itself.
class SppsoTracker {
 public:
  /// Throws std::invalid_argument on options out of range.
  SppsoTracker(const CameraRig& rig, const FleischmannProfile& profile, const ConeBody& body,
               const MotionStatistics& statistics, const SppsoOptions& options);

  /// The pose at an instant, which is taken as it is. The parameters should lie within the limits.
  void start(int64_t stamp_ns, const FleischmannVector& v);
  /// Looks for the person about a pose that is only roughly right, in rounds that search ever
  /// nearer to the best so far, and goes on from there. Keeps the last pose if nothing is found.
  /// \param views as for update() \param better_than fitness that must be surpassed
  SppsoPose startNear(int64_t stamp_ns, const FleischmannVector& v,
                      const std::vector<AppearanceView>& views, double better_than = 0.0);
  /// Forgets all poses.
  void reset();
  /// \param stamp_ns capture time, later than the last one, else the frame is lost
  /// \param views one for each camera; throws std::invalid_argument if they do not fit the rig
  SppsoPose update(int64_t stamp_ns, const std::vector<AppearanceView>& views);
  /// Where a search at an instant starts: the last pose, and `prediction` of its last change gone
  /// on. Only after start().
  FleischmannVector predicted(int64_t stamp_ns) const;
  const AppearanceFitness& fitness() const { return fitness_; }

 private:
  struct Known {
    int64_t stamp_ns;
    FleischmannVector v;
  };
  SearchProblem problem() const;
  FleischmannVector withinLimits(const FleischmannVector& v) const;
  /// Why the last pose is of no use now; empty if it is.
  std::string obstacle(int64_t stamp_ns, int views) const;
  void search(const SearchStart& start, uint64_t seed, SppsoPose& pose) const;
  /// Goes on from a pose if it is good enough to be claimed.
  void take(int64_t stamp_ns, SppsoPose& pose);

  AppearanceFitness fitness_;
  LimbCollision collision_;
  MotionStatistics statistics_;
  SppsoOptions options_;
  SppsoPlan plan_;
  FleischmannLimits limits_ = FleischmannLimits::anatomical();
  std::optional<Known> last_, before_;
};

}  // namespace markerless_mocap
