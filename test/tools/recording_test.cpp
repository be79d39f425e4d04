#include "tools/common/recording.h"

#include <gtest/gtest.h>
#include <sensor_msgs/CompressedImage.h>
#include <tf2_msgs/TFMessage.h>

#include "markerless_mocap/camera/rig_file.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"
#include "tools/common/camera_bag_writer.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kSecond = 1000000000;

class RecordingTest : public ToolTest {
 protected:
  /// One second at 10 Hz; the k-th instant lacks camera `missing` when k is 4.
  void writeBag(const std::string& name, int missing = -1, bool masks = false) const {
    CameraBagWriter bag(path(name), ringOfFour(), 0);
    bag.writeTransforms(kSecond);
    for (int k = 0; k < 10; ++k)
      for (int i = 0; i < 4; ++i)
        if (k != 4 || i != missing)
          bag.write(kSecond + k * kSecond / 10, i, smallImage(true),
                    masks ? smallMask() : cv::Mat());
    bag.commit();
  }

  /// One image of each camera; `change` may spoil what is known of a camera before it is written.
  template <class Change>
  void writeSpoilt(const std::string& name, const Change& change, bool with_tf = true) const {
    BagWriter bag(path(name));
    const auto ring = ringOfFour();
    const ros::Time stamp(1.0);
    for (size_t i = 0; i < ring.size(); ++i) {
      sensor_msgs::CameraInfo info = messageFromCalibration(ring[i]);
      info.header.stamp = stamp;
      info.header.frame_id = ring[i].name + "_optical";
      if (change(i, &info)) bag.write("/" + ring[i].name + "/camera_info", stamp, info);
      bag.write("/" + ring[i].name + "/image_raw", stamp,
                messageFromMat(smallImage(true), info.header));
      geometry_msgs::TransformStamped transform;
      transform.header.frame_id = "world";
      transform.child_frame_id = info.header.frame_id;
      transform.transform.rotation.w = 1.0;
      tf2_msgs::TFMessage tf;
      tf.transforms.push_back(transform);
      if (with_tf) bag.writeLatched("/tf_static", stamp, tf);
    }
    bag.commit();
  }

  std::string refusal(const std::string& name, const RecordingOptions& options = {}) const {
    return errorTextOf<std::exception>([&] { Recording recording(path(name), options); });
  }

  static std::vector<FrameSet> allOf(Recording& recording) {
    std::vector<FrameSet> frame_sets;
    while (auto frame_set = recording.next()) frame_sets.push_back(std::move(*frame_set));
    return frame_sets;
  }
};

TEST_F(RecordingTest, EveryInstantComesInOrderAMissingCameraIsEmpty) {
  writeBag("in.bag", 2);
  Recording recording(path("in.bag"), {});
  const auto frame_sets = allOf(recording);
  ASSERT_EQ(frame_sets.size(), 10u);
  for (int k = 0; k < 10; ++k) {
    EXPECT_EQ(frame_sets[k].stamp_ns, kSecond + k * kSecond / 10);
    EXPECT_EQ(frame_sets[k].frames[2].image.empty(), k == 4);
    EXPECT_FALSE(frame_sets[k].frames[1].image.empty());
  }
  EXPECT_EQ(recording.counts().incomplete, 1u);
}

TEST_F(RecordingTest, StartAndDurationAreSecondsAfterTheFirstImage) {
  writeBag("in.bag");
  RecordingOptions options;
  options.start = 0.25;
  options.duration = 0.4;
  Recording recording(path("in.bag"), options);
  const auto frame_sets = allOf(recording);
  ASSERT_EQ(frame_sets.size(), 4u);
  EXPECT_EQ(frame_sets.front().stamp_ns, kSecond + 3 * kSecond / 10);
  options.start = 5.0;
  Recording late(path("in.bag"), options);
  EXPECT_EQ(errorTextOf<std::exception>([&] { allOf(late); }),
            "the start lies after the end of the recording");
}

TEST_F(RecordingTest, ChosenCamerasKeepTheirOrder) {
  writeBag("in.bag");
  RecordingOptions options;
  options.cameras = {"cam3", "cam1"};
  Recording recording(path("in.bag"), options);
  ASSERT_EQ(recording.rig().size(), 2u);
  EXPECT_EQ(recording.rig()[0].name(), "cam3");
  options.cameras = {"cam9", "cam1"};
  EXPECT_EQ(refusal("in.bag", options),
            "camera cam9 is not in the bag, it has cam0, cam1, cam2, cam3");
  options.cameras = {"cam1"};
  EXPECT_EQ(refusal("in.bag", options), "camera cam1 is the only one, at least two are needed");
}

TEST_F(RecordingTest, MasksAreReadOnlyWhenAskedFor) {
  writeBag("in.bag", -1, true);
  Recording images(path("in.bag"), {});
  EXPECT_TRUE(allOf(images)[0].frames[0].mask.empty());
  RecordingOptions options;
  options.use_masks = true;
  Recording masks(path("in.bag"), options);
  const auto frame_sets = allOf(masks);
  EXPECT_FALSE(frame_sets[0].frames[0].mask.empty());
  EXPECT_FALSE(frame_sets[0].frames[0].image.empty());
  writeBag("none.bag");
  EXPECT_EQ(refusal("none.bag", options), "camera cam0 has no silhouettes in the bag");
}

TEST_F(RecordingTest, BagThatIsNoneMissingOrCutOffIsTold) {
  EXPECT_EQ(refusal("none.bag"), "there is no bag " + path("none.bag"));
  writeText("text.bag", "this is no bag");
  EXPECT_NE(refusal("text.bag").find("text.bag is not a bag or was cut off"), std::string::npos);
  writeText("nothing.bag", "");
  EXPECT_NE(refusal("nothing.bag").find("nothing.bag is not a bag or was cut off"),
            std::string::npos);
  writeBag("cut.bag");
  cutInHalf("cut.bag");
  EXPECT_NE(refusal("cut.bag").find("cut.bag is not a bag or was cut off"), std::string::npos);
}

TEST_F(RecordingTest, BagWithoutCamerasSaysWhichTopicsAreMissed) {
  BagWriter bag(path("in.bag"));
  bag.write("/other", ros::Time(1.0), tf2_msgs::TFMessage());
  bag.commit();
  EXPECT_EQ(refusal("in.bag").substr(0, 26), "the bag has no cameras: no");
}

TEST_F(RecordingTest, CameraWithoutInfoIsNamed) {
  writeSpoilt("in.bag", [](size_t i, sensor_msgs::CameraInfo*) { return i != 1; });
  EXPECT_EQ(refusal("in.bag"), "camera cam1 has images but no topic cam1/camera_info in the bag");
}

TEST_F(RecordingTest, ZeroAndNanCalibrationsNameTheCamera) {
  writeSpoilt("zero.bag", [](size_t i, sensor_msgs::CameraInfo* info) {
    if (i == 2) info->K.fill(0.0);
    return true;
  });
  EXPECT_NE(refusal("zero.bag").find("cam2"), std::string::npos);
  writeSpoilt("nan.bag", [](size_t i, sensor_msgs::CameraInfo* info) {
    if (i == 3) info->K[0] = NAN;
    return true;
  });
  EXPECT_NE(refusal("nan.bag").find("cam3"), std::string::npos);
}

/// As a camera_info of another ROS: the type's name is the same, the definition is not.
struct ForeignCameraInfo : sensor_msgs::CameraInfo {};

}  // namespace
}  // namespace markerless_mocap

namespace ros {
namespace message_traits {
template <>
struct MD5Sum<markerless_mocap::ForeignCameraInfo> {
  static const char* value() { return "0123456789abcdef0123456789abcdef"; }
  static const char* value(const markerless_mocap::ForeignCameraInfo&) { return value(); }
};
template <>
struct DataType<markerless_mocap::ForeignCameraInfo> : DataType<sensor_msgs::CameraInfo> {
  using DataType<sensor_msgs::CameraInfo>::value;
  static const char* value(const markerless_mocap::ForeignCameraInfo&) { return value(); }
};
template <>
struct Definition<markerless_mocap::ForeignCameraInfo> {
  static const char* value() { return "uint32 height"; }
  static const char* value(const markerless_mocap::ForeignCameraInfo&) { return value(); }
};
}  // namespace message_traits
namespace serialization {
template <>
struct Serializer<markerless_mocap::ForeignCameraInfo> : Serializer<sensor_msgs::CameraInfo> {};
}  // namespace serialization
}  // namespace ros

namespace markerless_mocap {
namespace {

TEST_F(RecordingTest, CameraInfoOfAnotherMd5SumIsTold) {
  {
    BagWriter bag(path("in.bag"));
    for (const CameraCalibration& camera : ringOfFour()) {
      bag.write("/" + camera.name + "/camera_info", ros::Time(1.0), ForeignCameraInfo());
      bag.write("/" + camera.name + "/image_raw", ros::Time(1.0),
                messageFromMat(smallImage(true), std_msgs::Header()));
    }
    bag.commit();
  }
  EXPECT_EQ(refusal("in.bag"),
            "topic /cam0/camera_info holds a CameraInfo of another md5 sum than this ROS has");
}

TEST_F(RecordingTest, AnImageOfAnotherSizeCostsThatImageOnly) {
  {
    CameraBagWriter bag(path("in.bag"), ringOfFour(), 0);
    bag.writeTransforms(kSecond);
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 4; ++i) {
        const int64_t stamp = kSecond + k * kSecond / 10;
        if (k != 1 || i != 2) {
          bag.write(stamp, size_t(i), smallImage(true), cv::Mat());
          continue;
        }
        std_msgs::Header header;
        header.stamp = rosTime(stamp);
        bag.bag().write("/cam2/image_raw", header.stamp,
                        messageFromMat(cv::Mat(10, 20, CV_8UC3, cv::Scalar(0)), header));
      }
    bag.commit();
  }
  Recording recording(path("in.bag"), {});
  const auto frame_sets = allOf(recording);
  ASSERT_EQ(frame_sets.size(), 3u);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(frame_sets[k].frames[2].image.empty(), k == 1);
  EXPECT_EQ(recording.unreadable(), 1);
  EXPECT_EQ(recording.firstUnreadable(),
            "an image of /cam2/image_raw is 20 x 10 pixels, the others 80 x 60");
}

TEST_F(RecordingTest, MissingTransformIsTold) {
  writeSpoilt(
      "in.bag", [](size_t, sensor_msgs::CameraInfo*) { return true; }, false);
  EXPECT_EQ(refusal("in.bag"), "tf does not connect cam0_optical of cam0 to world");
}

TEST_F(RecordingTest, UnreadableImageIsCountedAndItsCameraMissing) {
  BagWriter bag(path("in.bag"));
  tf2_msgs::TFMessage tf;
  for (const CameraCalibration& camera : ringOfFour()) {
    sensor_msgs::CameraInfo info = messageFromCalibration(camera);
    info.header.stamp = ros::Time(1.0);
    info.header.frame_id = camera.name + "_optical";
    bag.write("/" + camera.name + "/camera_info", info.header.stamp, info);
    sensor_msgs::CompressedImage image;
    image.header = info.header;
    image.format = "jpeg";
    image.data = {1, 2, 3};
    bag.write("/" + camera.name + "/image_raw/compressed", info.header.stamp, image);
    tf.transforms.emplace_back();
    tf.transforms.back().header.frame_id = "world";
    tf.transforms.back().child_frame_id = info.header.frame_id;
    tf.transforms.back().transform.rotation.w = 1.0;
  }
  bag.writeLatched("/tf_static", ros::Time(1.0), tf);
  bag.commit();
  Recording recording(path("in.bag"), {});
  const auto frame_sets = allOf(recording);
  ASSERT_EQ(frame_sets.size(), 1u);
  EXPECT_TRUE(frame_sets[0].frames[0].image.empty());
  EXPECT_EQ(recording.unreadable(), 4);
}

TEST_F(RecordingTest, rigFileStandsForCameraInfoAndTf) {
  writeSpoilt(
      "bare.bag", [](size_t, sensor_msgs::CameraInfo*) { return false; }, false);
  EXPECT_NE(refusal("bare.bag"), "");
  auto ring = ringOfFour();
  std::swap(ring[0], ring[3]);
  ring.push_back(ring[0]);
  ring.back().name = "another";
  writeRig(path("rig.yaml"), ring);
  RecordingOptions options;
  options.rig = path("rig.yaml");
  options.world_frame = "map";
  Recording recording(path("bare.bag"), options);
  ASSERT_EQ(recording.rig().size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(recording.rig()[i].name(), ringOfFour()[i].name);
    EXPECT_EQ(recording.rig()[i].calibration().K, ringOfFour()[i].K);
    EXPECT_EQ(recording.cameras()[i].frame, ringOfFour()[i].name + "_optical");
    EXPECT_EQ(recording.staticTransforms().transforms[i].header.frame_id, "map");
  }
  EXPECT_EQ(allOf(recording).size(), 1u);
}

TEST_F(RecordingTest, cameraThatTheRigFileLacksIsNamed) {
  writeBag("all.bag");
  auto ring = ringOfFour();
  ring.pop_back();
  writeRig(path("rig.yaml"), ring);
  RecordingOptions options;
  options.rig = path("rig.yaml");
  EXPECT_EQ(refusal("all.bag", options),
            options.rig + ": the rig lacks cam3, its cameras are cam0, cam1, cam2");
}

TEST_F(RecordingTest, timeOffsetsOfTheRigFileJoinCamerasWithOtherClocks) {
  CameraBagWriter bag(path("in.bag"), ringOfFour(), 0);
  bag.writeTransforms(kSecond);
  for (int k = 0; k < 10; ++k)
    for (int i = 0; i < 4; ++i)
      bag.write(kSecond + k * kSecond / 10 + (i == 1 ? 13 * kSecond / 20 : 0), i, smallImage(true),
                cv::Mat());
  bag.commit();
  auto ring = ringOfFour();
  writeRig(path("rig.yaml"), ring);
  RecordingOptions options;
  options.rig = path("rig.yaml");
  Recording without(path("in.bag"), options);
  for (const FrameSet& frame_set : allOf(without)) EXPECT_TRUE(frame_set.frames[1].image.empty());
  ASSERT_EQ(without.timingRemarks().size(), 1u);
  EXPECT_EQ(without.timingRemarks()[0].substr(0, 62),
            "10 frame sets lack /cam1/image_raw; in the last, cam1 is left ");
  ring[1].time_offset = -0.65;
  writeRig(path("rig.yaml"), ring);
  Recording with(path("in.bag"), options);
  const auto frame_sets = allOf(with);
  ASSERT_EQ(frame_sets.size(), 10u);
  for (int k = 0; k < 10; ++k) {
    EXPECT_EQ(frame_sets[k].stamp_ns, kSecond + k * kSecond / 10);
    for (const CameraFrame& frame : frame_sets[k].frames) EXPECT_FALSE(frame.image.empty());
  }
  EXPECT_TRUE(with.timingRemarks().empty());
}

}  // namespace
}  // namespace markerless_mocap
