#include "evaluation/uncertainty_calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

TEST(UncertaintyCalibration, HoldsWhatIsExpectedAgainstWhatIs) {
  // Expected 10 mm of eight frames, 40 mm of two; the errors are 3, 4 and 25 mm, then 30 and 90.
  const std::vector<double> expected{0.04, 0.01, 0.01, 0.01, 0.01, 0.01,
                                     0.01, 0.01, 0.01, 0.04, NAN,  0.01};
  const std::vector<double> errors{30, 3, 4, 4, 4, 4, 4, 3, 25, 90, 5, NAN};
  const UncertaintyCalibration found = uncertaintyCalibration("l_wrist", expected, errors);
  EXPECT_EQ(found.frames, 10u);
  EXPECT_NEAR(found.expected_mm, std::sqrt((8 * 100 + 2 * 1600) / 10.0), 1e-9);
  EXPECT_NEAR(found.actual_mm, std::sqrt((2 * 9 + 5 * 16 + 625 + 900 + 8100) / 10.0), 1e-9);
  EXPECT_NEAR(found.fraction_within_two_sigma, 0.8, 1e-12);
  EXPECT_NEAR(found.normalised_95, 2.5, 1e-12) << "the largest of ten";
  ASSERT_EQ(found.bins.size(), 5u);
  EXPECT_EQ(found.bins[0].frames, 2u);
  EXPECT_NEAR(found.bins[0].expected_mm, 10.0, 1e-9);
  EXPECT_NEAR(found.bins[0].actual_mm, std::sqrt((9 + 16) / 2.0), 1e-9);
  EXPECT_NEAR(found.bins[4].expected_mm, 40.0, 1e-9);
  EXPECT_NEAR(found.bins[4].actual_mm, std::sqrt((900 + 8100) / 2.0), 1e-9);
}

TEST(UncertaintyCalibration, WithoutFramesNothingIsSaid) {
  const UncertaintyCalibration found = uncertaintyCalibration("head", {NAN, 0.01}, {3, NAN});
  EXPECT_EQ(found.frames, 0u);
  EXPECT_TRUE(std::isnan(found.fraction_within_two_sigma));
  EXPECT_TRUE(std::isnan(found.expected_mm));
  EXPECT_TRUE(std::isnan(found.normalised_95));
  EXPECT_TRUE(found.bins.empty());
  EXPECT_THROW(uncertaintyCalibration("head", {0.01}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
