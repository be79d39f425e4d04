// Bags that lack something, or hold something wrong.
#include <sensor_msgs/CompressedImage.h>

#include "tools/recording_fixture.h"

namespace markerless_mocap {
namespace {

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

}  // namespace
}  // namespace markerless_mocap
