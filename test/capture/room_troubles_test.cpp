/// What changes in the room beside the person.
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "capture/trouble_fixture.h"

namespace markerless_mocap {
namespace {

constexpr double kFps = 4.0;
constexpr int kEmpty = 2;  ///< frame sets of the empty room
constexpr double kInEmpty = -0.25;

/// A studio with one trouble, and the same without.
class Compared {
 public:
  Compared(double DegradationOptions::*trouble, double value, const std::string& motion = "wave")
      : plain_(studio(filmOf(easyStudio(), motion))),
        changed_(studio(filmOf(with(trouble, value), motion))) {}

  /// \param seconds since the person came
  StudioFrameSet plainAt(double seconds) const { return plain_.render(indexAt(seconds)); }
  StudioFrameSet at(double seconds) const { return changed_.render(indexAt(seconds)); }
  /// How much the pictures differ from those without the trouble, beside the person, grey levels.
  double changeAt(double seconds) const { return apart(at(seconds), plainAt(seconds)); }
  /// The same from one time to another.
  double changeBetween(double one, double other) const { return apart(at(one), at(other)); }
  /// Mean of a channel, divided by that without the trouble, in the camera where it is furthest
  /// from 1.
  double ratioAt(double seconds, int channel) const {
    const StudioFrameSet a = at(seconds), b = plainAt(seconds);
    double largest = 1.0;
    for (size_t i = 0; i < a.images.size(); ++i) {
      const double ratio = cv::mean(a.images[i])[channel] / cv::mean(b.images[i])[channel];
      if (std::abs(ratio - 1.0) > std::abs(largest - 1.0)) largest = ratio;
    }
    return largest;
  }
  /// Fraction of the pixels of all cameras that differ at two times, beside the person.
  double fractionThatMoves(double one, double other) const {
    const StudioFrameSet a = at(one), b = at(other);
    double moved = 0.0, all = 0.0;
    for (size_t i = 0; i < a.images.size(); ++i) {
      cv::Mat apart, channels[3];
      cv::absdiff(a.images[i], b.images[i], apart);
      cv::split(apart, channels);
      const cv::Mat differs = cv::max(channels[0], cv::max(channels[1], channels[2])) > 2;
      moved += cv::countNonZero(differs & beside(a.masks[i], b.masks[i]));
      all += double(apart.total());
    }
    return moved / all;
  }
  void expectTruthIsTheSame(double seconds) const {
    EXPECT_EQ(at(seconds).points, plainAt(seconds).points);
  }
  /// Things in front of the person may hide pixels of the masks and add none.
  void expectMasksShowNothingElse(double seconds) const {
    const StudioFrameSet a = at(seconds), b = plainAt(seconds);
    for (size_t i = 0; i < a.masks.size(); ++i)
      EXPECT_EQ(cv::countNonZero(a.masks[i] & ~b.masks[i]), 0);
  }
  int hiddenAt(double seconds) const {
    const StudioFrameSet a = at(seconds), b = plainAt(seconds);
    int hidden = 0;
    for (size_t i = 0; i < a.masks.size(); ++i)
      hidden += cv::countNonZero(b.masks[i] & ~a.masks[i]);
    return hidden;
  }

 private:
  static StudioOptions filmOf(StudioOptions options, const std::string& motion) {
    options.motion = motion;
    options.background_frames = kEmpty;
    options.fps = kFps;
    return options;
  }
  static int indexAt(double seconds) { return kEmpty + int(std::lround(seconds * kFps)); }
  /// Where neither shows the person, not even in a part of a pixel.
  static cv::Mat beside(const cv::Mat& mask, const cv::Mat& other) {
    cv::Mat person;
    cv::dilate(mask | other, person, cv::Mat());
    return ~person;
  }
  static double apart(const StudioFrameSet& a, const StudioFrameSet& b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.images.size(); ++i)
      sum += meanDifference(a.images[i], b.images[i], beside(a.masks[i], b.masks[i]));
    return sum;
  }

  VirtualStudio plain_, changed_;
};

TEST(RoomTroublesTest, broughtChairIsNotInTheEmptyRoom) {
  const Compared chair(&DegradationOptions::brought_chair_distance, 0.4, "sit_couch");
  EXPECT_EQ(chair.changeAt(kInEmpty), 0.0);
  EXPECT_GT(chair.changeAt(0.0), 0.5);
  EXPECT_GT(chair.changeAt(6.0), 0.3);  // beside the person who sits on it
  EXPECT_GT(chair.hiddenAt(6.0), 20);
  chair.expectTruthIsTheSame(6.0);
  chair.expectMasksShowNothingElse(6.0);
}

TEST(RoomTroublesTest, boxIsPutDownAndStays) {
  const Compared box(&DegradationOptions::brought_box_distance, 1.2);
  EXPECT_EQ(box.changeAt(kInEmpty), 0.0);
  EXPECT_EQ(box.changeAt(1.75), 0.0);
  EXPECT_GT(box.changeAt(2.0), 0.5);
  EXPECT_GT(box.changeAt(5.0), 0.5);
  box.expectTruthIsTheSame(2.0);
  box.expectMasksShowNothingElse(2.0);
}

TEST(RoomTroublesTest, boxIsMovedOnce) {
  const Compared box(&DegradationOptions::moved_box_shift, 0.5);
  EXPECT_GT(box.changeAt(kInEmpty), 0.5);
  EXPECT_EQ(box.changeBetween(0.0, 2.0), 0.0);
  EXPECT_GT(box.changeBetween(2.0, 3.0), 0.5);
  EXPECT_EQ(box.changeBetween(3.0, 7.0), 0.0);
}

TEST(RoomTroublesTest, doorOpensAndShuts) {
  const Compared door(&DegradationOptions::door_angle, 80.0);
  EXPECT_GT(door.changeAt(kInEmpty), 0.1);  // it is in the wall
  EXPECT_EQ(door.changeBetween(kInEmpty, 1.0), 0.0);
  EXPECT_GT(door.changeBetween(1.0, 1.5), 0.1);
  EXPECT_GT(door.changeBetween(1.0, 3.0), 0.1);
  EXPECT_EQ(door.changeBetween(1.0, 5.0), 0.0);
  door.expectMasksShowNothingElse(3.0);
}

TEST(RoomTroublesTest, bystanderFidgetsAllTheTimeAndIsNoPersonOfTheMasks) {
  const Compared bystander(&DegradationOptions::bystander_distance, 2.5);
  EXPECT_GT(bystander.changeAt(kInEmpty), 0.3);
  EXPECT_GT(bystander.changeBetween(-0.5, -0.25), 0.01);
  EXPECT_GT(bystander.changeBetween(1.0, 2.0), 0.05);
  for (const cv::Mat& mask : bystander.at(kInEmpty).masks) EXPECT_EQ(cv::countNonZero(mask), 0);
  bystander.expectTruthIsTheSame(2.0);
  bystander.expectMasksShowNothingElse(2.0);
}

TEST(RoomTroublesTest, screenAndWindowAreInOnePlaceAndMove) {
  for (const auto trouble :
       {&DegradationOptions::screen_width, &DegradationOptions::window_width}) {
    const Compared picture(trouble, 2.0);
    EXPECT_GT(picture.changeBetween(-0.5, -0.25), 0.02);
    EXPECT_GT(picture.changeBetween(1.0, 3.0), 0.05);
    EXPECT_LT(picture.fractionThatMoves(1.0, 3.0), 0.1);
    picture.expectMasksShowNothingElse(1.0);
    EXPECT_EQ(picture.hiddenAt(1.0), 0);
  }
}

TEST(RoomTroublesTest, lampGoesOffAndOn) {
  const Compared lamp(&DegradationOptions::light_switch, 0.8);
  EXPECT_EQ(lamp.changeAt(kInEmpty), 0.0);
  EXPECT_EQ(lamp.changeAt(1.75), 0.0);
  EXPECT_LT(lamp.ratioAt(2.0, 1), 0.97);
  EXPECT_GT(lamp.ratioAt(2.0, 1), 0.5);
  EXPECT_EQ(lamp.changeAt(4.0), 0.0);
  EXPECT_GT(lamp.changeAt(6.0), 1.0);
}

TEST(RoomTroublesTest, sunAddsLightThatWanders) {
  const Compared sun(&DegradationOptions::sun_patches, 1.0);
  const StudioFrameSet plain = sun.plainAt(kInEmpty), sunny = sun.at(kInEmpty);
  for (size_t i = 0; i < plain.images.size(); ++i) {
    cv::Mat darker;
    cv::subtract(plain.images[i], sunny.images[i], darker);
    EXPECT_EQ(cv::norm(darker, cv::NORM_INF), 0.0);
  }
  EXPECT_GT(sun.ratioAt(kInEmpty, 1), 1.02);
  EXPECT_GT(sun.changeBetween(1.0, 3.0), 0.5);
}

TEST(RoomTroublesTest, exposureAndWhiteBalanceFollowThePersonOnly) {
  // The person is darker than the room, so that the camera opens.
  const Compared exposure(&DegradationOptions::auto_exposure, 1.0);
  EXPECT_EQ(exposure.changeAt(kInEmpty), 0.0);
  EXPECT_GT(exposure.ratioAt(1.0, 1), 1.01);
  EXPECT_LT(exposure.ratioAt(1.0, 1), 1.3);
  const Compared balance(&DegradationOptions::auto_white_balance, 1.0);
  EXPECT_EQ(balance.changeAt(kInEmpty), 0.0);
  EXPECT_GT(balance.changeAt(1.0), 0.2);
}

TEST(RoomTroublesTest, floorMirrorsThePerson) {
  const Compared floor(&DegradationOptions::floor_reflection, 0.3);
  EXPECT_GT(floor.changeAt(kInEmpty), 0.5);  // the walls' reflections
  // Beside the person, who casts no shadow here, only reflections differ from the empty room.
  EXPECT_GT(floor.changeBetween(kInEmpty, 1.0), 0.2);
  floor.expectMasksShowNothingElse(1.0);
  EXPECT_EQ(floor.hiddenAt(1.0), 0);
}

TEST(RoomTroublesTest, recordingWithoutTheEmptyRoomStartsWithThePerson) {
  StudioOptions options = easyStudio();
  options.background_frames = 0;
  const VirtualStudio room = studio(options);
  EXPECT_TRUE(room.render(0).person);
  for (const cv::Mat& mask : room.render(0).masks) EXPECT_GT(cv::countNonZero(mask), 300);
}

}  // namespace
}  // namespace markerless_mocap
