#include "studies/sppso_study/sppso_study.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <set>
#include <sstream>

#include "capture/studio_fixture.h"
#include "error_text_of.h"
#include "ros/package_files.h"
#include "studies/common/true_parameters.h"
#include "studies/sppso_study/fleischmann_report.h"

namespace markerless_mocap {
namespace {

StudioOptions studioOfTheStudy() {
  StudioOptions studio;
  studio.rig = "ring4";
  studio.width = 322;
  studio.height = 242;
  studio.fps = 60;
  studio.motion = "walk_in_circle";
  studio.motion_start = 2.0;
  studio.background_frames = 0;
  return studio;
}

const FleischmannSequence& film() {
  static const FleischmannSequence film =
      filmOf(studioOfTheStudy(), packageFiles(), 13, [](int) {});
  return film;
}

FleischmannMotionStatistics packageStatistics() {
  return FleischmannMotionStatistics::fromYaml(
      readText(MOCAP_SOURCE_DIR "/models/motion_statistics.yaml"));
}

TEST(FleischmannSequence, keepsAllThatIsNearThePerson) {
  const VirtualStudio stage(studioOfTheStudy(), packageFiles(), "person1");
  const StudioFrameSet frame_set = stage.render(5);
  const std::vector<FleischmannView> views = wholeViews(film(), 5);
  ASSERT_EQ(views.size(), 4u);
  EXPECT_EQ(film().frames[5].stamp_ns, frame_set.time_ns);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(cv::countNonZero(views[i].silhouette != frame_set.masks[i]), 0);
    EXPECT_GT(cv::countNonZero(views[i].image), cv::countNonZero(views[i].silhouette));
  }
}

// The driven body is the person: its markers are where the joints are.
TEST(FleischmannSequence, knowsTheTrueParameters) {
  const FleischmannBodyModel body_model(*film().body);
  for (size_t f = 0; f < film().frames.size(); ++f) {
    FleischmannFrames frames;
    body_model.frames(film().frames[f].truth.data(), frames);
    const std::vector<Eigen::Vector3d> markers = body_model.markers(frames);
    for (size_t m = 0; m < markers.size(); ++m)
      EXPECT_LT((markers[m] - film().joints.positions[f].col(Eigen::Index(m))).norm(), 0.02)
          << film().joints.names[m];
  }
}

TEST(TrueParameters, statisticsAreOfRealisticWalks) {
  StudioOptions studio;
  studio.duration = 0.5;
  studio.motion_start = 2.0;
  const FleischmannMotionStatistics statistics = statisticsOf({"walk"}, studio, packageFiles());
  EXPECT_GT(statistics.max_change[kLeftKnee], 0.01);
  EXPECT_LT(statistics.max_change.maxCoeff(), 0.3);
  EXPECT_TRUE(
      (statistics.max_change.array() <= 1.3 * packageStatistics().max_change.array() + 0.02).all());
  EXPECT_EQ(errorTextOf([&] { statisticsOf({}, studio, packageFiles()); }),
            "statistics need at least one motion");
}

TEST(FleischmannStudy, tracksTheFilmAtItsRateAndAtAThird) {
  StudyVariant variant{"base", FleischmannOptions(), 60.0, 2};
  const StudyResult fast = runVariant(film(), packageStatistics(), variant);
  ASSERT_EQ(fast.runs.size(), 2u);
  EXPECT_EQ(fast.seconds.size(), 12u);
  EXPECT_EQ(fast.meanOverRuns().size(), 12u);
  EXPECT_LT(fast.meanError(), 60.0);
  EXPECT_GE(fast.maxError(), fast.meanError());
  EXPECT_LE(fast.medianMaxError(), fast.maxError());
  EXPECT_NE(fast.runs[0].errors.D, fast.runs[1].errors.D);
  variant.fps = 20.0;
  variant.runs = 1;
  const StudyResult slow = runVariant(film(), packageStatistics(), variant);
  EXPECT_EQ(slow.seconds.size(), 4u);
  EXPECT_NEAR(slow.seconds[0], 0.05, 1e-6);
  EXPECT_EQ(slow.runs[0].lost, 0);
  variant.fps = 25.0;
  EXPECT_NE(errorTextOf([&] {
              runVariant(film(), packageStatistics(), variant);
            }).find("cannot be downsampled to 25"),
            std::string::npos);
}

TEST(FleischmannStudy, tablesAreThoseOfTheThesisAndEachCanBePlanned) {
  std::set<std::string> ids;
  for (const StudyTable& table : studyTables(FleischmannOptions())) {
    ids.insert(table.id);
    EXPECT_GE(table.variants.size(), 3u);
    for (const StudyVariant& variant : table.variants)
      EXPECT_FALSE(makeSearchPlan(variant.options).edges.empty()) << table.id;
  }
  EXPECT_EQ(ids, (std::set<std::string>{"6.2", "6.5", "6.6", "6.8", "6.10", "ours"}));
}

TEST(FleischmannStudy, curvesAreHighestNearTheTruth) {
  const FitnessCurves curves =
      fitnessCurves(film(), 6, kPelvisPosition + 2, 0.15, FleischmannOptions());
  ASSERT_EQ(curves.offsets.size(), 101u);
  EXPECT_NEAR(curves.offsets[50], 0.0, 1e-12);
  const auto top = std::max_element(curves.silhouette.begin(), curves.silhouette.end());
  EXPECT_EQ(*top, 1.0);
  EXPECT_NEAR(curves.offsets[size_t(top - curves.silhouette.begin())], 0.0, 0.05);
}

TEST(SppsoReport, pageAndLinesHoldEveryRun) {
  StudyReport report;
  report.about = "a sequence of 1 < 2 people";
  StudiedTable studied{{"6.2", "Evaluations", {{"base", FleischmannOptions(), 20.0, 2}}}, {}};
  studied.results.push_back(runVariant(film(), packageStatistics(), studied.table.variants[0]));
  report.tables.push_back(studied);
  report.curves = {{-0.1, 0.0, 0.1}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
  report.parameter = "right_shoulder_forward";
  report.time = {0.001, 0.001, 0.004, 0.002, 0.002};
  const std::string page = studyPage(report);
  EXPECT_NE(page.find("1 \\u003c 2 people"), std::string::npos);
  EXPECT_NE(page.find("6.2 Evaluations"), std::string::npos);
  EXPECT_NE(page.find("40.0 %"), std::string::npos);  // drawing's share of the time
  const std::string lines = studyCsv(report.tables);
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 3);
  EXPECT_NE(lines.find("\n6.2,\"base\",2,"), std::string::npos);
}

TEST(FleischmannStudy, timeIsToldByPart) {
  const TimeByPart time = timeByPart(film(), packageStatistics(), FleischmannOptions());
  for (const double part : {time.observing, time.kinematics, time.drawing_and_silhouette})
    EXPECT_GT(part, 0.0);
  EXPECT_GE(time.total(), time.observing + time.kinematics);
}

}  // namespace
}  // namespace markerless_mocap
