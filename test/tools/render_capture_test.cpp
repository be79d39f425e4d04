#include "tools/render/render_capture.h"
#include "tools/common/studio_settings.h"

#include <gtest/gtest.h>
#include <markerless_mocap/JointPositions.h>
#include <rosbag/view.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/JointState.h>

#include <map>

#include "capture/ground_truth.h"
#include "markerless_mocap/camera/rig_file.h"
#include "tools/common/bag_io.h"
#include "tools/common/person_urdf.h"
#include "tools/common/recording.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

class RenderCaptureTest : public ToolTest {
 protected:
  RenderCaptureTest() {
    options_.output = path("out.bag");
    options_.files.urdf_template = readText(std::string(MOCAP_SOURCE_DIR) + "/urdf/human.urdf.in");
    options_.files.motions_folder = std::string(MOCAP_SOURCE_DIR) + "/config/motions";
    options_.studio.rig = "ring4";
    options_.studio.width = 64;
    options_.studio.height = 48;
    options_.studio.background_frames = 2;
    options_.studio.fps = 10.0;
    options_.studio.duration = 0.5;
  }

  RenderSummary render() const { return renderCapture(options_, nullptr, false); }
  std::map<std::string, int> messagesByTopic() const {
    rosbag::Bag bag;
    openForReading(options_.output, bag);
    std::map<std::string, int> counts;
    for (const rosbag::MessageInstance& message : rosbag::View(bag)) ++counts[message.getTopic()];
    return counts;
  }
  template <class Message>
  std::vector<boost::shared_ptr<Message>> messagesOn(const std::string& topic) const {
    rosbag::Bag bag;
    openForReading(options_.output, bag);
    std::vector<boost::shared_ptr<Message>> messages;
    for (const auto& message : rosbag::View(bag, rosbag::TopicQuery(topic)))
      messages.push_back(message.instantiate<Message>());
    return messages;
  }

  RenderOptions options_;
};

TEST_F(RenderCaptureTest, bagHoldsImagesCalibrationAndTruth) {
  const RenderSummary summary = render();
  EXPECT_EQ(summary.frame_sets, 7);
  EXPECT_EQ(summary.cameras, 4);
  const auto counts = messagesByTopic();
  for (const char* camera : {"/cam0", "/cam1", "/cam2", "/cam3"}) {
    EXPECT_EQ(counts.at(std::string(camera) + "/image_raw"), 7);
    EXPECT_EQ(counts.at(std::string(camera) + "/camera_info"), 7);
    EXPECT_EQ(counts.at("/ground_truth" + std::string(camera) + "/silhouette"), 7);
  }
  EXPECT_EQ(counts.at("/tf_static"), 1);
  EXPECT_EQ(counts.at("/ground_truth/joints"), 5);
  EXPECT_EQ(counts.at("/ground_truth/joint_states"), 5);
  EXPECT_EQ(counts.at("/ground_truth/human_description"), 1);
  EXPECT_EQ(counts.size(), 4u * 3 + 4);
}

TEST_F(RenderCaptureTest, truthIsTheStudiosAtTheImagesStamps) {
  render();
  const VirtualStudio studio(options_.studio, options_.files, "truth");
  const auto joints = messagesOn<JointPositions>("/ground_truth/joints");
  const auto images = messagesOn<sensor_msgs::Image>("/cam2/image_raw");
  ASSERT_EQ(joints.size(), 5u);
  EXPECT_EQ(images[0]->header.stamp, ros::Time(1000.0));
  for (size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(joints[k]->header.stamp, images[k + 2]->header.stamp);
    EXPECT_EQ(joints[k]->header.frame_id, "world");
    EXPECT_EQ(joints[k]->names, groundTruthNames());
    const StudioFrameSet frame_set = studio.render(int(k) + 2);
    EXPECT_EQ(joints[k]->positions[4].x, frame_set.points[4].x());
    EXPECT_EQ(joints[k]->positions[4].z, frame_set.points[4].z());
  }
  const auto states = messagesOn<sensor_msgs::JointState>("/ground_truth/joint_states");
  EXPECT_EQ(states[0]->name.size(), states[0]->position.size());
}

TEST_F(RenderCaptureTest, aRecordingReadsItWithoutTheTruthAsACamera) {
  options_.masks = true;
  render();
  Recording recording(options_.output, {});
  EXPECT_EQ(recording.rig().size(), 4u);
  EXPECT_TRUE(recording.hasMasks());
}

TEST_F(RenderCaptureTest, sameOptionsGiveTheSameBytes) {
  options_.images = "jpeg";
  options_.studio.degradations.drop_rate = 0.2;
  render();
  const std::string first = bytesOf("out.bag");
  std::filesystem::remove(options_.output);
  render();
  EXPECT_TRUE(bytesOf("out.bag") == first);
  EXPECT_GT(first.size(), 1000u);
}

TEST_F(RenderCaptureTest, droppedImagesAreCountedAndLeftOut) {
  options_.studio.degradations.drop_rate = 0.5;
  options_.masks = true;
  const RenderSummary summary = render();
  const auto counts = messagesByTopic();
  int images = 0, masks = 0;
  for (const char* camera : {"/cam0", "/cam1", "/cam2", "/cam3"}) {
    images += counts.at(std::string(camera) + "/image_raw");
    masks += counts.at(std::string(camera) + "/silhouette");
    EXPECT_EQ(counts.at("/ground_truth" + std::string(camera) + "/silhouette"), 7);
  }
  EXPECT_GT(summary.dropped, 4);
  EXPECT_EQ(images, 28 - summary.dropped);
  EXPECT_EQ(masks, images);
}

TEST_F(RenderCaptureTest, imagesMayBeJpegOrNone) {
  options_.images = "jpeg";
  render();
  EXPECT_EQ(messagesByTopic().at("/cam0/image_raw/compressed"), 7);
  options_.images = "none";
  options_.masks = true;
  options_.compression = "none";
  render();
  const auto counts = messagesByTopic();
  EXPECT_EQ(counts.count("/cam0/image_raw"), 0u);
  EXPECT_EQ(counts.at("/cam0/silhouette"), 7);
}

TEST_F(RenderCaptureTest, rigGoesOutAsToldAndComesInAgain) {
  options_.rig_out = path("rig.yaml");
  options_.studio.degradations.calibration_error_px = 2.0;
  render();
  const VirtualStudio studio(options_.studio, options_.files, "truth");
  const auto rig = readRig(options_.rig_out);
  ASSERT_EQ(rig.size(), 4u);
  EXPECT_TRUE(rig[1].T_world_camera.isApprox(studio.rig()[1].calibration().T_world_camera, 1e-10));
  options_.studio.degradations.calibration_error_px = 0.0;
  options_.studio.rig = options_.rig_out;
  options_.rig_out = path("again.yaml");
  render();
  EXPECT_EQ(bytesOf("again.yaml"), bytesOf("rig.yaml"));
}

TEST_F(RenderCaptureTest, nothingIsLeftOfAnInterruptedRun) {
  options_.interrupted = [] { return true; };
  EXPECT_EQ(errorTextOf<std::exception>([&] { render(); }),
            "interrupted, " + options_.output + " is not written");
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(RenderCaptureTest, optionsComeFromFileAndChanges) {
  writeText("studio.yaml", "virtual_studio:\n  rig: ring8\n  noise_stddev: 7\n");
  const StudioOptions options =
      readStudioOptions(path("studio.yaml"), {{"noise_stddev", "1.5"}, {"motion", "walk"}});
  EXPECT_EQ(options.rig, "ring8");
  EXPECT_EQ(options.degradations.noise_stddev, 1.5);
  EXPECT_EQ(options.motion, "walk");
  EXPECT_EQ(readStudioOptions("", {}).fps, StudioOptions().fps);
}

TEST_F(RenderCaptureTest, badInputIsNamed) {
  EXPECT_EQ(errorTextOf<std::exception>([] {
              readStudioOptions("", {{"sead", "3"}});
            }),
            "virtual_studio/sead is not an option (value 3), did you mean seed?");
  writeText("other.yaml", "hull:\n  a: 3\n");
  EXPECT_EQ(errorTextOf<std::exception>([&] { readStudioOptions(path("other.yaml"), {}); }),
            path("other.yaml") + " has no section virtual_studio");
  options_.images = "png";
  EXPECT_EQ(errorTextOf<std::exception>([&] { render(); }),
            "images is \"png\", allowed are raw, jpeg and none");
  options_.images = "raw";
  options_.compression = "bz2";
  EXPECT_EQ(errorTextOf<std::exception>([&] { render(); }),
            "compression is \"bz2\", allowed are lz4 and none");
  EXPECT_TRUE(std::filesystem::exists(path("other.yaml")));
  EXPECT_FALSE(std::filesystem::exists(options_.output));
}

}  // namespace
}  // namespace markerless_mocap
