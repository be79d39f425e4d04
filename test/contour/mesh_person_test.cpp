// Accuracy on a person whose shape the fitted body can only come near to.
#include <gtest/gtest.h>

#include <algorithm>

#include "contour/drawn_body.h"
#include "contour/fit/contour_fitter.h"
#include "contour/mesh_person.h"
#include "contour/shape_estimation.h"
#include "markerless_mocap/tracking/person_resources.h"

namespace markerless_mocap {
namespace {

// Bounds are 1.3 times what was measured.
constexpr double kMaxShapeJointError = 1.3 * 0.0076;  ///< mean of joints and instants, metres
constexpr double kMaxFitJointError = 1.3 * 0.0078;    ///< the same of poses fitted afterwards
constexpr double kMaxLengthError = 1.3 * 0.0074;      ///< of each limb's bone, metres
constexpr double kMaxStatureError = 1.3 * 0.012;      ///< metres

constexpr int kInstants = 12;  ///< that sizes are estimated from

double jointError(const ContourBody& body, const ContourPose& pose, const Eigen::Matrix3Xd& truth) {
  return (body.points(pose).leftCols<15>() - truth).colwise().norm().mean();
}

/// Sizes are estimated once for all tests.
class MeshPersonTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    person_ = new MeshPerson("ring8");
    const ContourObserver observer(person_->rig(), ContourOptions());
    std::vector<ShapeSample> samples;
    for (int i = 0; i < kInstants; ++i) {
      const MeshPerson::Sight sight = person_->at(i);
      samples.push_back(
          {observer.observe(sight.masks), disturbed(sight.pose, 0.05, 0.02, unsigned(i) + 30), {}});
      joints_.push_back(sight.joints);
    }
    ShapePrior prior;
    prior.shape_statistics = PersonResources::standard().shape_statistics;
    prior.stature = 1.75;
    estimate_ =
        new ShapeEstimate(estimateShape(person_->rig(), ContourOptions(), prior,
                                        prior.shape_statistics.meanShape(prior.stature), samples));
  }
  static void TearDownTestSuite() {
    delete estimate_;
    delete person_;
    joints_.clear();
  }

  static MeshPerson* person_;
  static ShapeEstimate* estimate_;
  static std::vector<Eigen::Matrix3Xd> joints_;
};
MeshPerson* MeshPersonTest::person_ = nullptr;
ShapeEstimate* MeshPersonTest::estimate_ = nullptr;
std::vector<Eigen::Matrix3Xd> MeshPersonTest::joints_;

TEST_F(MeshPersonTest, SizesAndPosesAreEstimatedTogether) {
  EXPECT_EQ(estimate_->samples_used, kInstants);
  const ContourBody body(estimate_->shape);
  double error = 0.0;
  for (size_t i = 0; i < kInstants; ++i)
    error += jointError(body, estimate_->poses[i], joints_[i]) / kInstants;
  EXPECT_LT(error, kMaxShapeJointError);
  EXPECT_NEAR(estimate_->stature, MeshPerson::kStature, kMaxStatureError);
}

TEST_F(MeshPersonTest, BonesOfTheLimbsAreAsLongAsThePersons) {
  const auto length = [&](const char* from, const char* to) {
    const auto column = [](const std::string& name) {
      const auto& names = contourPointNames();
      return std::find(names.begin(), names.end(), name) - names.begin();
    };
    return (joints_[0].col(column(from)) - joints_[0].col(column(to))).norm();
  };
  EXPECT_NEAR(estimate_->shape[BodyLength::kThigh], length("l_hip", "l_knee"), kMaxLengthError);
  EXPECT_NEAR(estimate_->shape[BodyLength::kShank], length("l_knee", "l_ankle"), kMaxLengthError);
  EXPECT_NEAR(estimate_->shape[BodyLength::kUpperArm], length("l_shoulder", "l_elbow"),
              kMaxLengthError);
  EXPECT_NEAR(estimate_->shape[BodyLength::kForearm], length("l_elbow", "l_wrist"),
              kMaxLengthError);
}

TEST_F(MeshPersonTest, PosesAreFoundFromAFarStartAndFromANearOne) {
  const ContourOptions options;
  const ContourObserver observer(person_->rig(), options);
  const ContourFitter fitter(person_->rig(), options);
  const ContourBody body(estimate_->shape);
  constexpr int kPoses = 6;
  double far = 0.0, near = 0.0;
  for (int i = 0; i < kPoses; ++i) {
    const MeshPerson::Sight sight = person_->at(kInstants + 2 * i);
    const ContourObservation seen = observer.observe(sight.masks);
    const auto errorFrom = [&](const ContourPose& start, const RobustSchedule& schedule) {
      const ContourFit fit = fitter.fit(seen, body, start, std::nullopt, schedule);
      EXPECT_EQ(fit.status, ContourFitStatus::kFitted);
      EXPECT_GT(fit.overlap, 0.9);
      return jointError(body, fit.pose, sight.joints);
    };
    far += errorFrom(disturbed(sight.pose, 0.1, 0.03, unsigned(i) + 1), RobustSchedule::wide()) /
           kPoses;
    near +=
        errorFrom(disturbed(sight.pose, 0.04, 0.01, unsigned(i) + 1), fitter.schedule(1.0 / 15)) /
        kPoses;
  }
  EXPECT_LT(far, kMaxFitJointError);
  EXPECT_LT(near, kMaxFitJointError);
}

}  // namespace
}  // namespace markerless_mocap
