#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "body/body_fixture.h"
#include "hull/hull_scene.h"
#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {
namespace {

constexpr int kCameras = 8;

void addLimb(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
             std::vector<Sphere>* spheres) {
  const int steps = int((to - from).norm() / (0.5 * radius)) + 1;
  for (int i = 0; i <= steps; ++i)
    spheres->push_back({from + double(i) / steps * (to - from), radius});
}

/// Somebody of 1.5 m who faces +x, of spheres. In a leap with the legs drawn up and the arms led
/// far out the feet are nearer to the neck than the hands, by the way along the body.
std::vector<Sphere> person(bool leaping) {
  std::vector<Sphere> spheres;
  const double hips = 0.02, ankles = leaping ? -0.3 : -0.7;
  addLimb({0, 0, 0.66}, {0, 0, 0.70}, 0.08, &spheres);
  addLimb({0, 0, 0.45}, {0, 0, 0.62}, 0.05, &spheres);
  addLimb({0, 0, hips}, {0, 0, 0.38}, 0.11, &spheres);
  for (const double side : {1.0, -1.0}) {
    addLimb({0, 0, 0.43}, {0, 0.18 * side, 0.43}, 0.05, &spheres);
    const Eigen::Vector3d elbow(0, (leaping ? 0.55 : 0.38) * side, 0.45);
    const Eigen::Vector3d hand(leaping ? 0.5 : 0.1, (leaping ? 0.75 : 0.6) * side, 0.45);
    addLimb({0, 0.18 * side, 0.43}, elbow, 0.045, &spheres);
    addLimb(elbow, hand, 0.04, &spheres);
    const Eigen::Vector3d knee(0.06, 0.16 * side, 0.5 * (hips + ankles)),
        ankle(0, 0.2 * side, ankles);
    addLimb({0, 0.09 * side, hips}, knee, 0.06, &spheres);
    addLimb(knee, ankle, 0.05, &spheres);
    addLimb(ankle, ankle + Eigen::Vector3d(0.14, 0, -0.03), 0.04, &spheres);
  }
  return spheres;
}

class FollowedLabels : public ::testing::Test {
 protected:
  FollowedLabels() {
    options_.hull.volume = "explicit";
    options_.hull.volume_min = {-0.9, -0.9, -0.9};
    options_.hull.volume_max = {0.9, 0.9, 0.9};
    options_.hull.pitch = 0.025;
    options_.pose_tree.labelling = "ranking";
    options_.pose_tree.min_rank = 0.0;
  }

  /// Labels of the second of two frames: somebody stands, then leaps.
  PoseTree secondTree(bool follow) const {
    PipelineOptions options = options_;
    options.pose_tree.follow_labels = follow;
    const CameraRig rig = makeRig(kCameras);
    PersonResources sources;
    sources.urdf_template = humanTemplate();
    Pipeline pipeline(rig, sources, options);
    PoseTree tree;
    for (const bool leaping : {false, true}) {
      const std::vector<Sphere> spheres = person(leaping);
      std::vector<CameraFrame> frames(kCameras);
      for (int i = 0; i < kCameras; ++i)
        frames[size_t(i)].mask = renderMask(rig[size_t(i)], spheres);
      tree = pipeline.process(leaping, frames).tree;
      EXPECT_TRUE(tree.valid()) << tree.reason;
    }
    return tree;
  }

  PipelineOptions options_;
};

double height(const PoseTree& tree, Extremity extremity) {
  return tree.extremity(extremity).position.z();
}

TEST_F(FollowedLabels, HandsThatReachFurtherThanTheFeetStayHands) {
  const PoseTree tree = secondTree(true);
  for (const Extremity hand : {Extremity::kLeftHand, Extremity::kRightHand})
    EXPECT_GT(height(tree, hand), 0.2);
  for (const Extremity foot : {Extremity::kLeftFoot, Extremity::kRightFoot})
    EXPECT_LT(height(tree, foot), -0.2);
}

TEST_F(FollowedLabels, AFrameAloneTakesTheFurthestEndsForFeet) {
  const PoseTree tree = secondTree(false);
  EXPECT_GT(height(tree, Extremity::kLeftFoot), 0.2);
  EXPECT_GT(height(tree, Extremity::kRightFoot), 0.2);
}

}  // namespace
}  // namespace markerless_mocap
