#include "tools/check/check_recording.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "markerless_mocap/camera/rig_file.h"
#include "tools/common/camera_bag_writer.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kStart = 1000'000'000'000, kPeriod = 50'000'000;  // ns

class CheckRecordingTest : public ToolTest {
 protected:
  /// Twenty textured images of each camera; those of `dropped` every fifth one.
  void writeBag(const std::string& dropped, bool transforms = true) {
    CameraBagWriter writer(path("in.bag"), ringOfFour(), 0);
    if (transforms) writer.writeTransforms(kStart);
    cv::RNG random(3);
    cv::Mat tiles(6, 8, CV_8UC3), room;
    random.fill(tiles, cv::RNG::UNIFORM, 40, 200);
    cv::resize(tiles, room, {80, 60}, 0, 0, cv::INTER_NEAREST);
    for (int i = 0; i < 20; ++i)
      for (size_t c = 0; c < 4; ++c) {
        cv::Mat image = room.clone();
        image.at<cv::Vec3b>(0, i) = {0, 0, uint8_t(i)};  // no two are the same
        if (ringOfFour()[c].name != dropped || i % 5 != 2)
          writer.write(kStart + i * kPeriod, c, image, cv::Mat());
      }
    writer.commit();
  }

  CheckResult check() {
    CheckArguments arguments;
    arguments.bag = path("in.bag");
    arguments.rig = rig_;
    return resultOf(readSeenRig(arguments, {}, nullptr, false), arguments.bag);
  }

  std::vector<std::string> names() {
    std::vector<std::string> out;
    for (const Finding& finding : check().findings)
      out.push_back(finding.what + " " + finding.camera);
    return out;
  }

  std::string rig_;
};

using Names = std::vector<std::string>;

TEST_F(CheckRecordingTest, SaysNothingOfAGoodBagButThatNobodyMoves) {
  writeBag("");
  const CheckResult result = check();
  EXPECT_FALSE(isAnythingWrong(result));
  EXPECT_EQ(result.cameras.size(), 4u);
  ASSERT_EQ(result.not_checked.size(), 1u);
  std::ostringstream text;
  print(result, text);
  EXPECT_NE(text.str().find("4 cameras (cam0, cam1, cam2, cam3), 1 s: nothing wrong was found"),
            std::string::npos)
      << text.str();
}

TEST_F(CheckRecordingTest, FindsDroppedImages) {
  writeBag("cam2");
  EXPECT_EQ(names(), Names{"images_dropped cam2"});
  EXPECT_TRUE(isAnythingWrong(check()));
}

TEST_F(CheckRecordingTest, FindsCamerasWithoutTransform) {
  writeBag("", false);
  EXPECT_EQ(names(),
            (Names{"tf_missing cam0", "tf_missing cam1", "tf_missing cam2", "tf_missing cam3"}));
  EXPECT_EQ(check().findings[0].evidence, "tf does not connect cam0_optical to world");
}

TEST_F(CheckRecordingTest, TakesTheCalibrationFromARigFile) {
  writeBag("", false);
  rig_ = path("rig.yaml");
  writeRig(rig_, ringOfFour());
  EXPECT_EQ(names(), Names{});
}

TEST_F(CheckRecordingTest, WritesJson) {
  writeBag("cam1");
  const auto json = nlohmann::json::parse(jsonOf(check()));
  EXPECT_EQ(json["ok"], false);
  EXPECT_EQ(json["cameras"].size(), 4u);
  ASSERT_EQ(json["findings"].size(), 1u);
  EXPECT_EQ(json["findings"][0]["what"], "images_dropped");
  EXPECT_EQ(json["findings"][0]["camera"], "cam1");
  EXPECT_EQ(json["findings"][0]["severity"], "warning");
  EXPECT_NE(json["findings"][0]["evidence"].get<std::string>().find("%"), std::string::npos);
}

TEST_F(CheckRecordingTest, SaysInOneSentenceWhatIsNoRecording) {
  CheckArguments arguments;
  const auto read = [&] { readSeenRig(arguments, {}, nullptr, false); };
  arguments.bag = path("no.bag");
  EXPECT_NE(errorTextOf<std::exception>(read).find("no.bag"), std::string::npos);
  writeText("text.bag", "this is no bag");
  arguments.bag = path("text.bag");
  EXPECT_NE(errorTextOf<std::exception>(read).find("text.bag"), std::string::npos);
  BagWriter(path("empty.bag")).commit();
  arguments.bag = path("empty.bag");
  EXPECT_NE(errorTextOf<std::exception>(read).find("the bag has no cameras"), std::string::npos);
  writeBag("");
  arguments.bag = path("in.bag");
  arguments.cameras = {"cam7"};
  EXPECT_EQ(errorTextOf<std::exception>(read),
            "camera cam7 is not in the bag, it has cam0, cam1, cam2, cam3");
}

}  // namespace
}  // namespace markerless_mocap
