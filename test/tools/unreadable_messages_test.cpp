// Bags whose messages are cut off, or were defined otherwise: each tool says which topic it is.
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <tf2_msgs/TFMessage.h>

#include <cstring>

#include "markerless_mocap/JointPositions.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"
#include "tools/calibrate_rig/film.h"
#include "tools/check/check_recording.h"
#include "tools/common/bag_io.h"
#include "tools/common/result_record.h"
#include "tools/common/truth_record.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

/// A message of any type, as its bytes.
struct AnyMessage {
  const char *type, *md5sum;
  std::vector<uint8_t> bytes;
};

template <class Message>
AnyMessage cutOff() {
  return {ros::message_traits::DataType<Message>::value(),
          ros::message_traits::MD5Sum<Message>::value(),
          {1, 0, 0, 0, 9}};
}

template <class Message>
AnyMessage ofAnotherRos() {
  return {ros::message_traits::DataType<Message>::value(), "0123456789abcdef0123456789abcdef",
          std::vector<uint8_t>(64, 0)};
}

}  // namespace
}  // namespace markerless_mocap

namespace ros {
namespace message_traits {
template <>
struct IsMessage<markerless_mocap::AnyMessage> : TrueType {};
template <>
struct MD5Sum<markerless_mocap::AnyMessage> {
  static const char* value(const markerless_mocap::AnyMessage& message) { return message.md5sum; }
};
template <>
struct DataType<markerless_mocap::AnyMessage> {
  static const char* value(const markerless_mocap::AnyMessage& message) { return message.type; }
};
template <>
struct Definition<markerless_mocap::AnyMessage> {
  static const char* value(const markerless_mocap::AnyMessage&) { return "uint32 something"; }
};
}  // namespace message_traits
namespace serialization {
template <>
struct Serializer<markerless_mocap::AnyMessage> {
  template <class Stream>
  static void write(Stream& stream, const markerless_mocap::AnyMessage& message) {
    std::memcpy(stream.advance(uint32_t(message.bytes.size())), message.bytes.data(),
                message.bytes.size());
  }
  static uint32_t serializedLength(const markerless_mocap::AnyMessage& message) {
    return uint32_t(message.bytes.size());
  }
};
}  // namespace serialization
}  // namespace ros

namespace markerless_mocap {
namespace {

class UnreadableMessagesTest : public ToolTest {
 protected:
  void write(const std::string& topic, const AnyMessage& message) const {
    BagWriter bag(path("in.bag"));
    bag.write(topic, ros::Time(1.0), message);
    bag.commit();
  }
  /// One camera with its camera_info, and a message in place of its image.
  void writeInPlaceOfImages(const AnyMessage& message) const {
    BagWriter bag(path("in.bag"));
    bag.write("/cam0/image_raw", ros::Time(1.0), message);
    bag.write("/cam0/camera_info", ros::Time(1.0), messageFromCalibration(ringOfFour()[0]));
    bag.commit();
  }
  template <class Act>
  static std::string refusal(const Act& act) {
    return errorTextOf<std::exception>(act);
  }
  std::string refusalOfResults() const {
    return refusal([&] { readResults(path("in.bag"), ""); });
  }
  std::string refusalOfCheck() const {
    CheckArguments arguments;
    arguments.bag = path("in.bag");
    return refusal([&] { readSeenRig(arguments, {}, nullptr, false); });
  }
};

TEST_F(UnreadableMessagesTest, ResultsThatAreCutOffNameTheirTopic) {
  write("/tf", cutOff<tf2_msgs::TFMessage>());
  EXPECT_EQ(refusalOfResults(), "a message of /tf is damaged");
}

TEST_F(UnreadableMessagesTest, TruthThatIsCutOffNamesItsTopic) {
  write("/ground_truth/joints", cutOff<JointPositions>());
  EXPECT_EQ(refusal([&] { readTruth(path("in.bag")); }),
            "a message of /ground_truth/joints is damaged");
}

TEST_F(UnreadableMessagesTest, FilmsThatAreCutOffNameTheirTopic) {
  writeInPlaceOfImages(cutOff<sensor_msgs::Image>());
  EXPECT_EQ(refusal([&] {
              openFilm({"cam0", path("in.bag"), "/cam0/image_raw"})->next();
            }),
            "a message of /cam0/image_raw is damaged");
}

TEST_F(UnreadableMessagesTest, CheckedImagesThatAreCutOffNameTheirTopic) {
  writeInPlaceOfImages(cutOff<sensor_msgs::Image>());
  EXPECT_EQ(refusalOfCheck(), "a message of /cam0/image_raw is damaged");
}

TEST_F(UnreadableMessagesTest, ResultsOfAnotherRosAreToldFromNone) {
  write("/tf", ofAnotherRos<tf2_msgs::TFMessage>());
  EXPECT_EQ(refusalOfResults(),
            path("in.bag") +
                " has no results: neither a frame body_<id> in tf nor /pose; topic /tf holds a "
                "tf2_msgs/TFMessage of another md5 sum than this ROS has");
}

TEST_F(UnreadableMessagesTest, TruthOfAnotherRosIsToldFromNone) {
  write("/ground_truth/joints", ofAnotherRos<JointPositions>());
  EXPECT_EQ(refusal([&] { readTruth(path("in.bag")); }),
            path("in.bag") +
                " has no ground truth: no topic /ground_truth/joints; topic /ground_truth/joints "
                "holds a markerless_mocap/JointPositions of another md5 sum than this ROS has");
}

TEST_F(UnreadableMessagesTest, ImagesOfAnotherRosAreToldFromNone) {
  writeInPlaceOfImages(ofAnotherRos<sensor_msgs::Image>());
  const std::string sentence =
      "not all images can be read; topic /cam0/image_raw holds a sensor_msgs/Image of another md5 "
      "sum than this ROS has";
  EXPECT_EQ(refusalOfCheck(), sentence);
  EXPECT_EQ(refusal([&] { findFilms({path("in.bag")}, ""); }), sentence);
}

}  // namespace
}  // namespace markerless_mocap
