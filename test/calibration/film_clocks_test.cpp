#include <gtest/gtest.h>

#include "calibration/board_scene.h"
#include "calibration/calibrate.h"

namespace markerless_mocap {
namespace {

constexpr double kSeconds = 100.0;

/// Films that were started by hand: of different rates, and up to a minute apart.
class FilmClocksTest : public ::testing::Test {
 protected:
  FilmClocksTest() { scene_.addRing(4); }

  /// \param motion_time time of the board's motion at a time that all films share, s
  template <class MotionTime>
  CalibrationInput films(const MotionTime& motion_time) const {
    CalibrationInput input = scene_.input(0);
    std::mt19937 random(3);
    for (size_t i = 0; i < scene_.cameras.size(); ++i)
      for (int k = 0; k < int(kSeconds * rates_[i]); ++k) {
        const double time = k / rates_[i];
        const auto board = BoardScene::boardAt(motion_time(time + starts_[i]));
        if (auto view = scene_.viewAt(i, time, board, &random)) input.views.push_back(*view);
      }
    return input;
  }

  /// At no even pace.
  static double uneven(double time) {
    return time + 1.6 * std::sin(0.37 * time) + 0.7 * std::sin(1.13 * time + 1);
  }

  BoardScene scene_;
  std::vector<double> starts_ = {0.0, 23.417, -41.233, 7.062};  // s
  std::vector<double> rates_ = {5.0, 25.0 / 6, 29.97 / 6, 5.0};
};

TEST_F(FilmClocksTest, StartsUpToAMinuteApartAreFoundAndCertain) {
  CalibrationInput input = films(uneven);
  const FilmClocks clocks = searchClocks(input);
  ASSERT_TRUE(clocks.certain());
  EXPECT_LT(clocks.for_none, 0.5);
  for (size_t i = 0; i < starts_.size(); ++i)
    EXPECT_NEAR(clocks.offsets[i] - clocks.offsets[0], starts_[i], 0.03) << i;
  input.estimate_offsets = true;
  input.clocks = clocks;
  const RigCalibration result = calibrateRig(input);
  for (size_t i = 0; i < starts_.size(); ++i)
    EXPECT_NEAR(result.cameras[i].time_offset - result.cameras[0].time_offset, starts_[i], 0.005);
  EXPECT_LT(rigError(result, scene_.cameras).largestPosition(), 0.006);
  EXPECT_NE(std::find_if(result.verdict.begin(), result.verdict.end(),
                         [](const std::string& sentence) {
                           return sentence.find("The film of cam1 began 64.6") == 0;
                         }),
            result.verdict.end());
}

TEST_F(FilmClocksTest, FilmsThatBeganTogetherAreToldFromOthers) {
  starts_ = {0, 0, 0, 0};
  const FilmClocks clocks = searchClocks(films(uneven));
  EXPECT_TRUE(clocks.certain());
  EXPECT_GT(clocks.for_none, 0.9);
  for (const double offset : clocks.offsets) EXPECT_NEAR(offset, 0.0, 0.03);
}

TEST_F(FilmClocksTest, ABoardThatIsWavedInARhythmIsNotCertain) {
  CalibrationInput input = films([](double time) { return time - 9.0 * std::floor(time / 9.0); });
  const FilmClocks clocks = searchClocks(input);
  EXPECT_FALSE(clocks.certain());
  input.estimate_offsets = true;
  input.clocks = clocks;
  const RigCalibration result = calibrateRig(input);
  EXPECT_FALSE(result.good);
  EXPECT_NE(std::find_if(result.verdict.begin(), result.verdict.end(),
                         [](const std::string& sentence) {
                           return sentence.find("began is not certain") != std::string::npos;
                         }),
            result.verdict.end());
}

TEST_F(FilmClocksTest, ABoardThatLiesStillTellsNothing) {
  const FilmClocks clocks = searchClocks(films([](double) { return 2.0; }));
  EXPECT_FALSE(clocks.certain());
}

}  // namespace
}  // namespace markerless_mocap
