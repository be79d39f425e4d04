// Small versions of what Fleischmann 2012 says; `reproduce fleischmann` has the large ones.

#include <gtest/gtest.h>

#include <string>

#include "fleischmann/appearance_scene.h"
#include "fleischmann/fleischmann_pose_estimator.h"
#include "fleischmann/model/fleischmann_urdf_converter.h"
#include "fleischmann/painted_person.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kFrame_ns = 1000000000 / 20;
constexpr int kFrames = 10, kSeeds = 3;

/// Half a step in half a second, filmed at 20 fps.
FleischmannVector walkAt(int frame) {
  const double t = double(frame) / kFrames;
  FleischmannVector v = stride();
  v.segment<2>(kPelvisPosition) += 0.6 * t * Eigen::Vector2d(std::cos(0.4), std::sin(0.4));
  v[kPelvisOrientation + 2] += 0.3 * t;
  v[kLeftHip + 1] -= 0.8 * t;
  v[kRightHip + 1] += 0.8 * t;
  v[kRightKnee] += 0.6 * std::sin(M_PI * t);
  v[kLeftShoulder + 1] += 0.7 * t;
  v[kRightShoulder + 1] -= 0.7 * t;
  return v;
}

FleischmannOptions published(const std::string& search) {
  FleischmannOptions options;
  options.search = search;
  options.include_start_particle = false;
  options.min_silhouette_fitness = 0.0;
  options.body.joint_limits = "full";
  options.body.collision_pairs = "all";
  options.image.hide_covered_edges = true;
  options.swarm.crossover = 0.5;
  options.swarm.carry_particles = true;
  return options;
}

/// The walk as painted views, made once.
class Claims : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto model = std::make_shared<BodyModel>(sampleBody());
    for (int frame = 1; frame <= kFrames; ++frame) {
      Eigen::Isometry3d root;
      Eigen::VectorXd angles;
      FleischmannUrdfConverter(model).convert(walkAt(frame), root, angles);
      views().push_back(paintedViews(ringOfFour(), *model, root, angles));
    }
  }
  static std::vector<std::vector<FleischmannView>>& views() {
    static std::vector<std::vector<FleischmannView>> views;
    return views;
  }

  /// Mean error of the markers over the walk and the seeds, mm.
  static double meanError(const FleischmannOptions& base) {
    const FleischmannBodyModel body_model(sampleBody());
    FleischmannMotionStatistics statistics;  // the largest changes of this walk at 60 fps, and some
    statistics.max_change.setConstant(0.03);
    statistics.max_change.segment<3>(kPelvisPosition).setConstant(0.02);
    double sum = 0.0;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      FleischmannOptions options = base;
      options.seed = seed;
      FleischmannPoseEstimator tracker(ringOfFour(), body_model,
                                       FleischmannBodyShape(sampleBody(), body_model, options.body),
                                       statistics, options);
      tracker.start(0, walkAt(0));
      for (int frame = 1; frame <= kFrames; ++frame)
        sum += error(body_model, tracker.update(frame * kFrame_ns, views()[size_t(frame - 1)]).v,
                     walkAt(frame));
    }
    return 1e3 * sum / (kSeeds * kFrames);
  }

 private:
  static double error(const FleischmannBodyModel& body_model, const FleischmannVector& found,
                      const FleischmannVector& truth) {
    FleischmannFrames here, there;
    body_model.frames(found.data(), here);
    body_model.frames(truth.data(), there);
    const auto a = body_model.markers(here), b = body_model.markers(there);
    double sum = 0.0;
    for (size_t m = 0; m < a.size(); ++m) sum += (a[m] - b[m]).norm() / double(a.size());
    return sum;
  }
};

// 6.5. Walks of half a second do not tell soft stages from hard ones (59.8 and 63.5 mm).
TEST_F(Claims, softStagesAreBetterThanTheFilterAt20Fps) {
  const double soft = meanError(published("two_soft"));
  const double filter = meanError(published("annealed_filter"));
  EXPECT_LT(1.2 * soft, filter);
}

// 6.8.
TEST_F(Claims, aSwarmOfTwoIsNone) {
  FleischmannOptions two = published("two_soft");
  two.swarm.final_stage_particles = 2;
  two.swarm.final_stage_iterations = 400;
  const double base = meanError(published("two_soft")), few = meanError(two);
  EXPECT_LT(1.1 * base, few);
}

}  // namespace
}  // namespace markerless_mocap
