#include "tools/offline/report_page.h"

#include <gtest/gtest.h>

#include <cmath>

#include "pages/page_reader.h"
#include "tools/common/person_urdf.h"

namespace markerless_mocap {
namespace {

BodyModel body() {
  return BodyModel::fromUrdf(bodyUrdf("", "person1", 1.75), "person1");
}

/// Two instants: a person whose left arm is not seen, and nobody.
ReportContent sample(const BodyModel& body) {
  ReportContent content;
  content.title = "a <b> & c";
  ResultFrame tracked{1600000000500000000, FrameStatus::kTracked, "", {}, {}};
  body.forwardKinematics(Eigen::Isometry3d::Identity(), Eigen::VectorXd::Zero(body.angleCount()),
                         tracked.T_world_link);
  tracked.T_world_link[size_t(body.linkIndex("l_wrist"))].matrix().setConstant(NAN);
  tracked.part_sigma_m = {0.01, 0.02, 0.123, 0.03, 0.03, 0.03};
  content.frames = {tracked, {1600000000600000000, FrameStatus::kLost, "nobody", {}, {}}};
  content.rows = {{0.5, 0.05, {true, true, false, true, true, true}}, {NAN, NAN, {}}};
  const cv::Mat picture = cv::Mat::zeros(8, 8, CV_8UC3);
  content.cameras = {{"cam0", "learned from <x>", picture, 0.125, {0.5, 0.25}, {0.625, NAN}},
                     {"cam1", "none", cv::Mat(), 0.0, {NAN, NAN}, {NAN, NAN}}};
  return content;
}

class ReportPage : public ::testing::Test {
 protected:
  Json page() const {
    PlayerContent player;
    player.body = &body_;
    player.frames = &content_.frames;
    return contentOf(reportPage(content_, playerPart(player), body_).html());
  }

  BodyModel body_ = body();
  ReportContent content_ = sample(body_);
};

TEST_F(ReportPage, SaysWhenAndWhyAPoseIsLost) {
  const Json content = page(), player = partUnder(content, "", "player");
  EXPECT_TRUE(says(content, "2 frame sets: 1 tracked, 0 reinitialized, 1 lost"));
  EXPECT_EQ(player["start"], "1600000000.500");
  EXPECT_NEAR(floatsOf(player["seconds"]).at(1), 0.1, 1e-6);
  EXPECT_EQ(player["status"], Json::parse(R"([[0, 1, 2, ""], [1, 2, 1, "nobody"]])"));
  EXPECT_EQ(player["states"][1]["name"], "lost");
  EXPECT_EQ(player["events"],
            Json::parse(R"([{"frame": 0, "frames": 1, "what": "l_arm not seen", "why": ""},
                            {"frame": 1, "frames": 1, "what": "no pose", "why": "nobody"}])"));
}

TEST_F(ReportPage, RemarksComeFirst) {
  content_.remarks = {"cam0 is turned", "x < y"};
  const Json parts = page()["parts"];
  EXPECT_EQ(parts[0]["text"], "cam0 is turned");
  EXPECT_EQ(parts[1]["text"], "x < y");
}

TEST_F(ReportPage, CurvesHaveTheFiguresAndNoneWhereThereIsNone) {
  const Json content = page();
  const std::vector<float> overlap =
      floatsOf(partUnder(content, "Overlap of body and masks", "lines")["lines"][0]["values"]);
  const std::vector<float> error =
      floatsOf(partUnder(content, "Skeleton error", "lines")["lines"][0]["values"]);
  EXPECT_FLOAT_EQ(overlap.at(0), 0.5f);
  EXPECT_FLOAT_EQ(error.at(0), 50.0f) << "in mm";
  EXPECT_TRUE(std::isnan(overlap.at(1)));
  EXPECT_TRUE(std::isnan(error.at(1)));
  EXPECT_FLOAT_EQ(
      floatsOf(partUnder(content, "Expected errors", "lines")["lines"][2]["values"]).at(0), 12.3f);
}

TEST_F(ReportPage, MethodWithoutSkeletonErrorHasNoPlotOfIt) {
  content_.rows[0].skeleton_error_m = NAN;
  EXPECT_FALSE(hasPart(page(), "Skeleton error", "lines"));
}

TEST_F(ReportPage, EachPartHasABandThatTellsWhenItWasNotSeen) {
  const Json part = partUnder(page(), "Parts of the body that were not seen", "bands");
  ASSERT_EQ(part["bands"].size(), 6u);
  for (size_t i = 0; i < 6; ++i) {
    const Json runs = part["bands"][i]["runs"];
    EXPECT_EQ(runs[0], Json({0, 1, i == 2 ? 1 : 0, ""}));
    EXPECT_EQ(runs[1], Json::parse(R"([1, 2, 2, "nobody"])"));
  }
  EXPECT_EQ(part["states"][1]["name"], "not seen");
}

TEST_F(ReportPage, TellsHowOftenPartsWereNotSeenAndWhy) {
  const Json content = page();
  const Json rows = partUnder(content, "Parts of the body that were not seen", "table")["rows"];
  EXPECT_EQ(rows[2], Json::parse(R"(["l_arm", "0", "1", "1", "", "12.3"])"));
  EXPECT_EQ(rows[3], Json::parse(R"(["r_arm", "1", "0", "1", "3.0", ""])"));
  const Json reasons = lastUnder(content, "Parts of the body that were not seen", "table")["rows"];
  EXPECT_EQ(reasons, Json::parse(R"([["1", "no pose: nobody"],
                                     ["1", "not all parts seen: no message"]])"));
}

TEST_F(ReportPage, ReasonsThatDifferInNumbersCountTogether) {
  content_.frames[0] = content_.frames[1];
  content_.frames[0].stamp_ns -= 100000000;
  content_.frames[0].reason = "overlap 0.41";
  content_.frames[1].reason = "overlap 0.38";
  const Json reasons = lastUnder(page(), "Parts of the body that were not seen", "table")["rows"];
  EXPECT_EQ(reasons, Json::parse(R"([["2", "no pose: overlap 0.41"]])"));
}

TEST_F(ReportPage, WithoutAPoseThereIsNoMotion) {
  content_.frames[0] = content_.frames[1];
  content_.frames[0].stamp_ns -= 100000000;
  EXPECT_FALSE(hasPart(page(), "Joint angles", "text"));
  EXPECT_TRUE(hasPart(page(), "", "player"));
}

TEST_F(ReportPage, EachCameraShowsItsBackgroundAndHowFarItsMasksAreKnown) {
  const Json content = page();
  EXPECT_EQ(partUnder(content, "cam0", "picture")["caption"],
            "Background: learned from <x>; blue: never seen without the person, 12.5 % of the "
            "image");
  EXPECT_EQ(partUnder(content, "cam1", "text")["text"], "Background: none");
  EXPECT_TRUE(says(content, "37.5 % is unknown on average"));
  EXPECT_TRUE(says(content, "This camera gave no mask"));
  const Json lines = partUnder(content, "cam0", "lines")["lines"];
  EXPECT_EQ(floatsOf(lines[0]["values"]), (std::vector<float>{0.5f, 0.25f}));
  EXPECT_EQ(floatsOf(lines[1]["values"]).at(0), 0.625f);
  EXPECT_EQ(partUnder(content, "What each camera saw", "table")["rows"],
            Json::parse(R"([["cam0", "0.625"], ["cam1", "-"]])"));
}

}  // namespace
}  // namespace markerless_mocap
