#include "motion/motion_script.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include "error_text_of.h"

namespace markerless_mocap {
namespace {

std::string faultOf(const std::string& text) {
  return errorTextOf([&] { parseMotionScript(text, "m.yaml"); });
}

const std::string kHead = "seconds: 4\nstart: {x: 0.5, y: -0.5, heading: 180}\n";

TEST(MotionScript, readsWhatIsWritten) {
  const MotionScript script = parseMotionScript(
      kHead +
          "path:\n"
          "  - stand: 1.5\n"
          "  - {go: 0.8, turn: 90, seconds: 1.0, steps: 3, first: left, width: 0.12}\n"
          "tracks:\n"
          "  trunk: [[0, 0, 0, 0], [2, 10, -5, 20]]\n",
      "m.yaml");
  EXPECT_EQ(script.name, "m.yaml");
  EXPECT_DOUBLE_EQ(script.seconds, 4.0);
  EXPECT_DOUBLE_EQ(script.start_heading, M_PI);
  ASSERT_EQ(script.path.size(), 2u);
  EXPECT_EQ(script.path[0].kind, Move::Kind::kStand);
  EXPECT_DOUBLE_EQ(script.path[0].seconds, 1.5);
  EXPECT_EQ(script.path[1].kind, Move::Kind::kGo);
  EXPECT_DOUBLE_EQ(script.path[1].turn, M_PI / 2);
  EXPECT_EQ(script.path[1].steps, 3);
  EXPECT_EQ(script.path[1].first, Move::First::kLeft);
  EXPECT_DOUBLE_EQ(script.path[1].stance.width, 0.12);
  EXPECT_DOUBLE_EQ(script.track(Track::kTrunk).at(2.0)[2], 20.0);
  EXPECT_EQ(script.track(Track::kLeftArm).at(1.0), trackRow(Track::kLeftArm).neutral);
}

TEST(MotionScript, saysWhatIsWrongInOneSentence) {
  const std::string path = "path: [{stand: 1}]\n";
  EXPECT_EQ(faultOf(kHead + path), "m.yaml misses the key tracks");
  EXPECT_EQ(faultOf("start: {}\n" + path + "tracks: {}\n"), "m.yaml misses the key seconds");
  EXPECT_EQ(faultOf("seconds: -2\nstart: {}\npath: []\ntracks: {}\n"),
            "m.yaml/seconds is -2, allowed is a number from 0.01 to 600");
  EXPECT_EQ(faultOf(kHead + path + "tracks: {}\nspeed: 1\n"),
            "m.yaml has the unknown key speed, allowed are seconds, start, path, feet, tracks");
  EXPECT_EQ(faultOf(kHead + "path: [{swim: 1}]\ntracks: {}\n"),
            "m.yaml/path[0] names no move, allowed is one of stand, go, shift, jump");
  EXPECT_EQ(faultOf(kHead + "path: [{stand: 1}, {go: 1}]\ntracks: {}\n"),
            "m.yaml/path[1] misses the key seconds");
  EXPECT_EQ(faultOf(kHead + "path: [{go: far, seconds: 1}]\ntracks: {}\n"),
            "m.yaml/path[0]/go is far, allowed is a number from -10 to 10");
  EXPECT_EQ(faultOf(kHead + "path: [{go: 1, seconds: 1, steps: 2.5}]\ntracks: {}\n"),
            "m.yaml/path[0]/steps is 2.5, allowed is a whole number from 1 to 200");
  EXPECT_EQ(faultOf(kHead + "path: [{stand: 9}]\ntracks: {}\n"),
            "m.yaml/path takes 9 s, allowed is up to the motion's 4 s");
  EXPECT_EQ(faultOf(kHead + "path: 7\ntracks: {}\n"), "m.yaml/path is 7, allowed is a list");
}

TEST(MotionScript, saysWhatIsWrongWithKeys) {
  const std::string head = kHead + "path: []\n";
  EXPECT_EQ(faultOf(head + "tracks: {tail: [[0, 1]]}\n").substr(0, 66),
            "m.yaml/tracks has the unknown key tail, allowed are drop, shift, p");
  EXPECT_EQ(faultOf(head + "tracks: {drop: [[1, 0], [0.5, 0.1]]}\n"),
            "m.yaml/tracks/drop[1] is [0.5, 0.1], allowed is a time after the key before, 1 s");
  EXPECT_EQ(faultOf(head + "tracks: {drop: [[7, 0]]}\n"),
            "m.yaml/tracks/drop[0] is [7, 0], allowed is a time from 0 to the motion's 4 s");
  EXPECT_EQ(faultOf(head + "tracks: {drop: [[1, 0, 0]]}\n"),
            "m.yaml/tracks/drop[0] is [1, 0, 0], allowed is 2 numbers: seconds and the 1 of drop");
  EXPECT_EQ(faultOf(head + "tracks: {drop: [[1, .nan]]}\n"),
            "m.yaml/tracks/drop[0] is [1, .nan], allowed is 2 numbers: seconds and the 1 of drop");
  EXPECT_EQ(faultOf(head + "tracks: {drop: [[1, 3]]}\n"),
            "m.yaml/tracks/drop[0] is [1, 3], allowed is as number 2 one from -0.05 to 0.4");
}

TEST(MotionScript, saysWhatIsWrongWithFeet) {
  const std::string head = kHead + "path: []\ntracks: {}\n";
  EXPECT_EQ(faultOf(head + "feet: [{foot: middle, keys: []}]\n"),
            "m.yaml/feet[0]/foot is middle, allowed is one of left, right");
  EXPECT_EQ(faultOf(head + "feet: [{foot: left, keys: [[1, 0, 0, 0, 0], [2, 0, 0, 0.1, 0]]}]\n"),
            "m.yaml/feet[0]/keys is [[1, 0, 0, 0, 0], [2, 0, 0, 0.1, 0]], allowed is a first and a "
            "last key with zeros: the foot comes back to where it stood");
}

TEST(MotionScript, saysWhatIsWrongWithFiles) {
  EXPECT_EQ(faultOf("a: [1\nb: 2\n").rfind("m.yaml is no YAML: ", 0), 0u);
  EXPECT_EQ(errorTextOf([] { readMotionScript("/nowhere/dance.yaml"); }),
            "cannot read the motion /nowhere/dance.yaml: there is no such file");
  EXPECT_EQ(errorTextOf([] { readMotionScript("/"); }),
            "cannot read the motion /: it is a folder, pipe or device, allowed are files");
}

}  // namespace
}  // namespace markerless_mocap
