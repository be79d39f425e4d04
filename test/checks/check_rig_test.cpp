#include "checks/check_rig.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "checks/faults.h"
#include "checks/seen_studio.h"

namespace markerless_mocap {
namespace {

const SeenRig& goodWalk() {
  static const SeenRig rig = filmedWalk({});
  return rig;
}

std::string listOf(const Findings& findings) {
  std::string out;
  for (const Finding& finding : findings)
    out += finding.what + "(" + finding.camera + ") " + finding.evidence + "\n";
  return out;
}

TEST(CheckRig, SaysNothingOfAGoodRecording) {
  EXPECT_EQ(listOf(checkRig(goodWalk())), "");
  EXPECT_TRUE(notChecked(goodWalk()).empty());
}

TEST(CheckRig, NamesNoCauseWhereSilhouettesAreSpoiled) {
  for (const unsigned seed : {8, 20, 48, 52}) {
    SeenRig rig = goodWalk();
    for (unsigned i = 0; i < 4; ++i) spoilOutlines(&rig.cameras[i], seed + i);
    const Findings findings = checkRig(rig);
    ASSERT_EQ(findings.size(), 1u) << listOf(findings);
    EXPECT_EQ(findings[0].what, "silhouettes_disagree");
  }
}

/// As if only the rows from `first` on had been recorded, `height` of them.
void crop(int first, int height, SeenCamera* camera) {
  camera->infos[0].height = height;
  camera->infos[0].K(1, 2) -= first;
  for (SeenPicture& picture : camera->pictures)
    picture.grey = picture.grey.rowRange(first, first + height);
  for (SeenImage& image : camera->images) {
    image.height = height;
    image.outline->centre.y() -= first;
    for (Eigen::Vector2d& corner : image.outline->hull) {
      corner.y() -= first;
      image.outline->cut |= corner.y() < 0 || corner.y() > height - 1;
      corner.y() = std::clamp(corner.y(), 0.0, height - 1.0);
    }
  }
}

TEST(CheckRig, LegsThatMostImagesCutOffAreTold) {
  SeenRig rig = goodWalk();
  crop(50, 100, &rig.cameras[0]);
  crop(50, 100, &rig.cameras[2]);
  EXPECT_EQ(listOf(checkRig(rig)), "");
  crop(50, 100, &rig.cameras[3]);
  const Findings findings = checkRig(rig);
  ASSERT_EQ(findings.size(), 1u) << listOf(findings);
  EXPECT_EQ(findings[0].what, "images_cut_person");
  EXPECT_NE(findings[0].evidence.find("beyond the lower border"), std::string::npos);
}

TEST(CheckRig, AnEvenFloorIsNoCover) {
  SeenRig rig = goodWalk();
  changePictures(&rig.cameras[0], [](const cv::Mat& m) {
    cv::Mat boards(m.size(), CV_8UC1);
    for (int x = 0; x < m.cols; ++x) boards.col(x) = 125 + (x / 18 * 7 % 5 - 2) * 6;
    return boards;
  });
  EXPECT_EQ(listOf(checkRig(rig)), "");
}

TEST(CheckRig, APersonWhoHidesTheRoomIsNoMovedCamera) {
  constexpr int kMoved = 3;  // px
  SeenRig rig = goodWalk();
  cv::Mat shirt(rig.cameras[0].pictures[0].grey.size(), CV_8UC1);
  cv::RNG random(1);
  random.fill(shirt, cv::RNG::UNIFORM, 40, 200);
  cv::GaussianBlur(shirt, shirt, {}, 2.0);
  const cv::Mat shift = (cv::Mat_<double>(2, 3) << 1, 0, kMoved, 0, 1, 0);
  const cv::Mat first = rig.cameras[0].pictures[0].grey;
  int i = 0;
  changePictures(
      &rig.cameras[0],
      [&](const cv::Mat&) {
        cv::Mat out;  // a new one: pictures of all tests are the same
        if (++i < 4)
          cv::warpAffine(first, out, shift, first.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
        else
          cv::flip(shirt, out, i % 3 - 1);
        return out;
      },
      1);
  EXPECT_EQ(listOf(checkRig(rig)).find("camera_moved"), std::string::npos);
}

class FaultTest : public ::testing::TestWithParam<Fault> {};

TEST_P(FaultTest, IsFoundAndNamed) {
  SeenRig rig = goodWalk();
  GetParam().make(&rig);
  const Findings findings = checkRig(rig);
  for (const Finding& finding : findings) {
    EXPECT_FALSE(finding.evidence.empty());
    EXPECT_FALSE(finding.remedy.empty());
    if (finding.what == GetParam().what && finding.camera == GetParam().camera) return;
  }
  ADD_FAILURE() << GetParam().camera << " not found, but:\n" << listOf(findings);
}

std::string nameOf(const ::testing::TestParamInfo<Fault>& info) {
  return info.param.what + (info.param.camera.empty() ? "_of_all" : "_of_one");
}

INSTANTIATE_TEST_SUITE_P(Messages, FaultTest, ::testing::ValuesIn(messageFaults()), nameOf);
INSTANTIATE_TEST_SUITE_P(Geometry, FaultTest, ::testing::ValuesIn(geometryFaults()), nameOf);
INSTANTIATE_TEST_SUITE_P(Time, FaultTest, ::testing::ValuesIn(timeFaults()), nameOf);
INSTANTIATE_TEST_SUITE_P(Pictures, FaultTest, ::testing::ValuesIn(pictureFaults()), nameOf);

TEST(CheckRig, SaysWhatItCouldNotJudge) {
  SeenRig rig = goodWalk();
  for (SeenCamera& camera : rig.cameras)
    for (SeenImage& image : camera.images) image.outline->hull.clear();
  ASSERT_EQ(notChecked(rig).size(), 1u);
  EXPECT_NE(notChecked(rig)[0].find("see somebody move"), std::string::npos);
  EXPECT_EQ(listOf(checkRig(rig)), "");
}

TEST(CheckRig, SaysWhichOtherExchangeWouldLookTheSame) {
  SeenRig rig = goodWalk();
  std::swap(rig.cameras[0].images, rig.cameras[2].images);
  EXPECT_NE(listOf(checkRig(rig)).find("would look nearly the same"), std::string::npos);
}

TEST(CheckRig, AcceptsNothingAtAll) {
  EXPECT_TRUE(checkRig({}).empty());
  SeenRig rig;
  rig.cameras.resize(2);
  EXPECT_FALSE(checkRig(rig).empty());
}

TEST(CheckRig, TellsTheOffsetInMilliseconds) {
  SeenRig rig = goodWalk();
  shiftStamps(&rig.cameras[1], [](double) { return -0.08; });
  for (const Finding& finding : checkRig(rig)) {
    if (finding.what != "time_offset") continue;
    double ms = 0;
    const size_t at = finding.evidence.find("moves in it ");
    ASSERT_NE(at, std::string::npos);
    ms = std::stod(finding.evidence.substr(at + 12));
    EXPECT_NEAR(ms, 80, 12);
    EXPECT_NE(finding.evidence.find("before"), std::string::npos);
    return;
  }
  FAIL() << "no time_offset";
}

TEST(CheckRig, ToldOfOneSpotATurnIsNotClaimed) {
  constexpr double kChair = 5;  // px
  SeenRig rig = goodWalk();
  for (SeenCamera& camera : rig.cameras)
    for (SeenImage& image : camera.images)
      image.outline = camera.images[size_t(6.5 * kTestRate)].outline;
  for (SeenImage& image : rig.cameras[2].images) {
    image.outline->centre.x() += kChair;
    for (Eigen::Vector2d& corner : image.outline->hull) corner.x() += kChair;
  }
  const Findings findings = checkRig(rig);
  ASSERT_EQ(findings.size(), 1u) << listOf(findings);
  EXPECT_EQ(findings[0].what, "person_stays");
  EXPECT_EQ(findings[0].severity, Severity::kNote);
}

TEST(CheckRig, FindsAnOffsetWhereThePersonSoonStandsStill) {
  SeenRig rig = goodWalk();
  for (SeenCamera& camera : rig.cameras)
    for (size_t i = size_t(3.5 * kTestRate); i < camera.images.size(); ++i)
      camera.images[i].outline = camera.images[size_t(3.5 * kTestRate)].outline;
  shiftStamps(&rig.cameras[1], [](double) { return -0.09; });
  EXPECT_NE(listOf(checkRig(rig)).find("time_offset(cam1)"), std::string::npos);
}

}  // namespace
}  // namespace markerless_mocap
