#include "tools/offline/offline_run.h"

#include <gtest/gtest.h>
#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "markerless_mocap/ros/messages.h"
#include "pages/page_reader.h"
#include "tools/common/camera_bag_writer.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kSecond = 1000000000;

class OfflineRun : public ToolTest {
 protected:
  OfflineRun() {
    options_.input = path("in.bag");
    options_.output = path("out.bag");
    options_.urdf_template = MOCAP_SOURCE_DIR "/urdf/human.urdf.in";
    options_.pipeline.silhouette.background_frames = 2;
  }

  /// Two empty instants, then a box stands in the middle for three.
  void writeBag(int frame_sets = 5, bool somebody = true) const {
    CameraBagWriter bag(options_.input, ringOfFour(), 0);
    bag.writeTransforms(kSecond);
    for (int k = 0; k < frame_sets; ++k)
      for (int i = 0; i < 4; ++i)
        bag.write(kSecond + k * kSecond / 10, i, smallImage(somebody && k >= 2), cv::Mat());
    bag.commit();
  }

  std::map<std::string, int> countsByTopic() const {
    std::map<std::string, int> counts;
    rosbag::Bag bag(options_.output);
    for (const rosbag::MessageInstance& message : rosbag::View(bag)) ++counts[message.getTopic()];
    return counts;
  }

  OfflineOptions options_;
};

TEST_F(OfflineRun, LeavesNothingBehindWhenInterrupted) {
  writeBag();
  int frame_sets = 0;
  options_.interrupted = [&] { return ++frame_sets == 4; };
  try {
    runOffline(options_, nullptr, false);
    FAIL() << "the run went on";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(), "interrupted, " + options_.output + " is not written");
  }
  EXPECT_EQ(frame_sets, 4);
  EXPECT_FALSE(std::filesystem::exists(options_.output));
  EXPECT_FALSE(hasUnfinished());
}

TEST_F(OfflineRun, WritesEveryProductOfEveryInstant) {
  writeBag();
  const RunSummary summary = runOffline(options_, nullptr, false);
  EXPECT_EQ(summary.frame_sets(), 5);
  EXPECT_EQ(summary.processed(), 3);
  auto counts = countsByTopic();
  EXPECT_EQ(counts["/tf_static"], 1);
  EXPECT_EQ(counts["/hull/grid"], 1);
  EXPECT_EQ(counts["/humans/bodies/person1/human_description"], 1);
  for (const char* topic :
       {"/hull/points", "/segmentation/points", "/segmentation/parts", "/pose_tree", "/pose"})
    EXPECT_EQ(counts[topic], 3) << topic;
  EXPECT_EQ(counts["/tf"], summary.poses());
  EXPECT_EQ(counts["/humans/bodies/person1/joint_states"], summary.poses());
}

TEST_F(OfflineRun, StampsAreTheInputs) {
  writeBag();
  runOffline(options_, nullptr, false);
  rosbag::Bag bag(options_.output);
  std::vector<double> stamps;
  for (const auto& message : rosbag::View(bag, rosbag::TopicQuery("/hull/points"))) {
    const auto cloud = message.instantiate<sensor_msgs::PointCloud2>();
    EXPECT_EQ(cloud->header.stamp, message.getTime());
    EXPECT_EQ(cloud->header.frame_id, "world");
    EXPECT_GT(cloud->width, 0u);
    stamps.push_back(cloud->header.stamp.toSec());
  }
  EXPECT_EQ(stamps, (std::vector<double>{1.2, 1.3, 1.4}));
}

TEST_F(OfflineRun, TwiceTheSameBytes) {
  writeBag();
  options_.masks_out = true;
  runOffline(options_, nullptr, false);
  options_.output = path("again.bag");
  runOffline(options_, nullptr, false);
  const std::string bytes = bytesOf("out.bag");
  EXPECT_GT(bytes.size(), 1000u);
  EXPECT_TRUE(bytes == bytesOf("again.bag"));
}

TEST_F(OfflineRun, ResultsHoldNoImagesThoughTheReportShowsThem) {
  writeBag();
  options_.report_folder = path("report");
  runOffline(options_, nullptr, false);
  rosbag::Bag bag(options_.output);
  rosbag::View results(bag);
  ASSERT_GT(results.size(), 0u);
  for (const rosbag::ConnectionInfo* connection : results.getConnections())
    EXPECT_EQ(connection->datatype.find("Image"), std::string::npos) << connection->topic;
}

TEST_F(OfflineRun, MasksAreWrittenOnRequest) {
  writeBag();
  options_.masks_out = true;
  runOffline(options_, nullptr, false);
  EXPECT_EQ(countsByTopic()["/cam0/silhouette"], 3);
  EXPECT_EQ(countsByTopic().count("/cam0/person"), 0u) << "a box is nobody's pose";
}

TEST_F(OfflineRun, BoxIsNoPersonAndTheSummarySaysWhy) {
  writeBag();
  const RunSummary summary = runOffline(options_, nullptr, false);
  EXPECT_EQ(summary.poses(), 0);
  std::ostringstream text;
  summary.print(text);
  EXPECT_NE(text.str().find("3 lost"), std::string::npos) << text.str();
  EXPECT_NE(text.str().find("3 times: "), std::string::npos) << text.str();
  EXPECT_NE(text.str().find("No frame has a pose"), std::string::npos) << text.str();
  EXPECT_EQ(text.str().find("show nobody"), std::string::npos) << "there is a box";
  EXPECT_NE(text.str().find("check_recording tells"), std::string::npos) << text.str();
}

TEST_F(OfflineRun, WhatIsDoneBeforeTheFirstPoseIsShown) {
  writeBag();
  std::ostringstream notes;
  runOffline(options_, &notes, false);
  const std::string text = notes.str();
  EXPECT_LT(text.find("looking for the background 0 %"), text.find("measuring the person 0 %"));
  EXPECT_LT(text.find("measuring the person 100 %"), text.find("mocap_offline 0 %")) << text;
}

TEST_F(OfflineRun, WhoKeepsStillIsTakenForTheRoomAndTheSummarySaysSo) {
  PipelineResult nobody;
  RunSummary summary(false);
  for (int i = 0; i < 4; ++i) summary.add(nobody);
  std::ostringstream text;
  summary.print(text);
  EXPECT_NE(text.str().find("In 4 of 4 frame sets the silhouettes show nobody"), std::string::npos)
      << text.str();
}

TEST_F(OfflineRun, RecordingThatEndsWhileLearningIsAnErrorAndLeavesNoBag) {
  writeBag(2);
  EXPECT_EQ(errorTextOf<std::exception>([&] { runOffline(options_, nullptr, false); }),
            "the recording ends while the background is being learned, after 2 frame sets");
  EXPECT_FALSE(std::filesystem::exists(options_.output));
  EXPECT_FALSE(hasUnfinished());
}

TEST_F(OfflineRun, UnusedSilhouettesAreRecalledWhenLearningDoesNotEnd) {
  CameraBagWriter bag(options_.input, ringOfFour(), 0);
  bag.writeTransforms(kSecond);
  for (int i = 0; i < 4; ++i) bag.write(kSecond, i, smallImage(true), smallMask());
  bag.commit();
  EXPECT_EQ(errorTextOf<std::exception>([&] { runOffline(options_, nullptr, false); }),
            "the recording ends while the background is being learned, after 1 frame sets; its "
            "silhouettes need --use-masks");
  options_.recording.use_masks = true;
  EXPECT_EQ(runOffline(options_, nullptr, false).processed(), 1);
}

TEST_F(OfflineRun, InputIsNotOverwritten) {
  writeBag();
  options_.output = options_.input;
  EXPECT_EQ(errorTextOf<std::exception>([&] { runOffline(options_, nullptr, false); }),
            "input and output are the same file " + options_.input);
}

TEST_F(OfflineRun, AReportThatCannotBeWrittenIsToldBeforeTheRun) {
  writeBag();
  options_.report_folder = options_.input + "/report";
  std::ostringstream notes;
  const std::string fault =
      errorTextOf<std::exception>([&] { runOffline(options_, &notes, false); });
  EXPECT_EQ(fault, "cannot make the folder " + options_.report_folder + " or write into it");
  EXPECT_EQ(notes.str(), "");
  EXPECT_FALSE(std::filesystem::exists(options_.output));
}

TEST_F(OfflineRun, UnreadableBodyAndBadIdAreTold) {
  writeBag();
  options_.urdf_template = path("none.urdf");
  EXPECT_EQ(errorTextOf<std::exception>([&] { runOffline(options_, nullptr, false); }),
            "cannot read " + options_.urdf_template + ": there is no such file");
  writeText("broken.urdf", "<robot>");
  options_.urdf_template = path("broken.urdf");
  const std::string broken =
      errorTextOf<std::exception>([&] { runOffline(options_, nullptr, false); });
  EXPECT_EQ(broken.find(options_.urdf_template + ": URDF of the body: "), 0u) << broken;
  EXPECT_FALSE(std::filesystem::exists(options_.output));
}

TEST_F(OfflineRun, ProgressWithoutTerminalIsALineEveryTenPercentFromZero) {
  writeBag(12, false);
  std::ostringstream notes;
  runOffline(options_, &notes, false);
  const std::string text = notes.str();
  EXPECT_EQ(text.find('\r'), std::string::npos);
  const auto lines = [&](const std::string& begin) {
    const std::regex line("(^|\\n)" + begin + " \\d+ %");
    return std::distance(std::sregex_iterator(text.begin(), text.end(), line),
                         std::sregex_iterator());
  };
  EXPECT_LE(lines("looking for the background"), 11) << text;
  EXPECT_EQ(lines("measuring the person"), 11) << text;
  EXPECT_EQ(lines("mocap_offline"), 11) << text;
  EXPECT_EQ(text.find("looking for the background 0 %"), 0u) << text;
  EXPECT_LT(text.find("measuring the person 100 %"),
            text.find("the body could not be measured: its stature is set to 1.7"))
      << text;
  EXPECT_NE(text.find("mocap_offline 100 %"), std::string::npos) << text;
}

TEST_F(OfflineRun, ReportIsOnePageWithPicturesOfItsOwn) {
  writeBag();
  options_.report_folder = path("report");
  runOffline(options_, nullptr, false);
  const Json content = contentOf(bytesOf("report/report.html"));
  EXPECT_TRUE(says(content, "3 lost"));
  EXPECT_TRUE(says(content, "learned from the first images"));
  EXPECT_TRUE(says(content, "all of it is known"));
  EXPECT_TRUE(std::filesystem::exists(path("report/instant_000002.png")));
  const Json player = partUnder(content, "", "player");
  EXPECT_EQ(floatsOf(player["seconds"]).size(), 3u);
  EXPECT_EQ(player["cameras"].size(), 4u);
  ASSERT_EQ(player["views"].size(), 3u);
  const std::vector<uint8_t> jpeg = bytesOfBase64(player["views"][1]["cameras"][2]["jpeg"]);
  EXPECT_EQ(cv::imdecode(jpeg, cv::IMREAD_COLOR).cols, 256);
}

TEST_F(OfflineRun, ReportWithoutImagesHasNone) {
  writeBag();
  options_.report_folder = path("report");
  options_.report_images = false;
  runOffline(options_, nullptr, false);
  const std::string page = bytesOf("report/report.html");
  EXPECT_EQ(page.find("\"/9j/"), std::string::npos) << "the first bytes of a JPEG";
  EXPECT_FALSE(std::filesystem::exists(path("report/instant_000002.png")));
  const Json view = partUnder(contentOf(page), "", "player")["views"][1]["cameras"][2];
  EXPECT_NE(view["mask"], "") << "outlines stay";
}

// A box of 24 x 40 pixels that sways by 8 covers 16 x 40 of the 80 x 60 pixels in every image.
TEST_F(OfflineRun, ReportTintsWhatTheBackgroundOfARecordingDoesNotKnow) {
  CameraBagWriter bag(options_.input, ringOfFour(), 0);
  bag.writeTransforms(kSecond);
  for (int k = 0; k < 48; ++k)
    for (int i = 0; i < 4; ++i) {
      cv::Mat image = smallImage(false);
      image(cv::Rect(30 + std::abs(k % 16 - 8), 10, 24, 40)).setTo(cv::Scalar(30, 200, 240));
      bag.write(kSecond + k * kSecond / 10, i, image, cv::Mat());
    }
  bag.commit();
  options_.pipeline.silhouette.background_frames = 30;  // two images show no motion
  options_.pipeline.fitting.person.measure = false;
  options_.report_folder = path("report");
  runOffline(options_, nullptr, false);
  const Json picture = partUnder(contentOf(bytesOf("report/report.html")), "cam2", "picture");
  EXPECT_EQ(
      picture["caption"].get<std::string>().find(
          "Background: learned from the whole recording; blue: never seen without the person"),
      0u);
  const cv::Mat background = cv::imdecode(bytesOfBase64(picture["jpeg"]), cv::IMREAD_COLOR);
  ASSERT_EQ(background.size(), cv::Size(80, 60));
  EXPECT_GT(background.at<cv::Vec3b>(30, 46)[0], 100) << "the box has 30";
  EXPECT_NEAR(background.at<cv::Vec3b>(5, 10)[0], 80, 6);
  EXPECT_NEAR(background.at<cv::Vec3b>(5, 10)[2], 80, 6);
}

TEST_F(OfflineRun, ReportSaysThatMasksWereRecorded) {
  CameraBagWriter bag(options_.input, ringOfFour(), 0);
  bag.writeTransforms(kSecond);
  for (int i = 0; i < 4; ++i) bag.write(kSecond, i, smallImage(true), smallMask());
  bag.commit();
  options_.recording.use_masks = true;
  options_.report_folder = path("report");
  runOffline(options_, nullptr, false);
  EXPECT_NE(bytesOf("report/report.html").find("Background: none, as the masks were recorded"),
            std::string::npos);
}

TEST(RunSummaryText, PosesThatHardlyOverlapTheSilhouettesAreDoubted) {
  const auto textWith = [](double overlap) {
    RunSummary summary(false);
    PipelineResult tracked;
    tracked.pose.status = PoseStatus::kTracked;
    summary.add(tracked);
    summary.addOverlaps({overlap, overlap});
    std::ostringstream out;
    summary.print(out);
    return out.str();
  };
  EXPECT_NE(textWith(0.37).find("these poses are probably wrong"), std::string::npos);
  EXPECT_EQ(textWith(0.7).find("these poses are probably wrong"), std::string::npos);
}

TEST_F(OfflineRun, ConfigurationErrorsNameFileAndKey) {
  writeText("typo.yaml", "visual_hull: {pich: 0.02}\n");
  EXPECT_EQ(
      errorTextOf<std::exception>([&] { readConfiguration(path("typo.yaml")); }),
      path("typo.yaml") + ": visual_hull/pich is not an option (value 0.02), did you mean pitch?");
  writeText("broken.yaml", "visual_hull: {pitch: [\n");
  EXPECT_EQ(errorTextOf<std::exception>([&] {
              readConfiguration(path("broken.yaml"));
            }).find(path("broken.yaml") + " is no YAML: "),
            0u);
  EXPECT_EQ(errorTextOf<std::exception>([&] { readConfiguration(path("none.yaml")); }),
            "cannot read the configuration " + path("none.yaml") + ": there is no such file");
  ASSERT_EQ(mkfifo(path("pipe.yaml").c_str(), 0600), 0);
  EXPECT_EQ(errorTextOf<std::exception>([&] { readConfiguration(path("pipe.yaml")); }),
            "cannot read the configuration " + path("pipe.yaml") +
                ": it is a folder, pipe or device, allowed are files");
}

}  // namespace
}  // namespace markerless_mocap
