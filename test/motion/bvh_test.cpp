#include "motion/bvh.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>
#include "error_text_of.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

const std::string kHierarchy = R"(HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Knee
  {
    OFFSET 0 -4 0
    CHANNELS 3 Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 -3 1
    }
  }
}
)";

std::string motionOf(const std::string& frames, int count, const std::string& time = "0.025") {
  return "MOTION\nFrames: " + std::to_string(count) + "\nFrame Time: " + time + "\n" + frames;
}

BvhMotion read(const std::string& text) {
  std::istringstream stream(text);
  return readBvh(stream, "walk.bvh");
}

std::string faultOf(const std::string& text) {
  return errorTextOf([&] { read(text); });
}

void expectAt(const Vector3d& place, double x, double y, double z) {
  EXPECT_NEAR((place - Vector3d(x, y, z)).norm(), 0.0, 1e-12) << place.transpose();
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(Bvh, readsTheHierarchy) {
  const BvhMotion motion = read(kHierarchy + motionOf("1 2 3 0 0 0 0 0 0\n", 1));
  ASSERT_EQ(motion.joints.size(), 3u);
  EXPECT_EQ(motion.joints[0].name, "Hips");
  EXPECT_EQ(motion.joints[1].name, "Knee");
  EXPECT_EQ(motion.joints[2].name, "Knee end");
  EXPECT_TRUE(motion.joints[2].is_end);
  EXPECT_EQ(motion.joints[0].parent, -1);
  EXPECT_EQ(motion.joints[2].parent, 1);
  EXPECT_EQ(motion.joints[0].channels.size(), 6u);
  EXPECT_EQ(motion.joints[0].channels[3].axis, 2);
  EXPECT_TRUE(motion.joints[0].channels[3].rotates);
  EXPECT_DOUBLE_EQ(motion.frame_time, 0.025);
  EXPECT_EQ(motion.frames.size(), 1u);
}

TEST(Bvh, restHasNoRotationsAndItsOffsets) {
  const BvhPose rest = read(kHierarchy + motionOf("1 2 3 90 0 0 0 90 0\n", 1)).rest();
  expectAt(rest.positions[0], 0, 0, 0);
  expectAt(rest.positions[1], 0, -4, 0);
  expectAt(rest.positions[2], 0, -7, 1);
}

// Rz(90) takes (0,-4,0) to (4,0,0). Rz(90) Rx(90) takes (0,-3,1) by Rx to (0,-1,-3), by Rz to
// (1,0,-3).
TEST(Bvh, turnsInTheOrderOfTheChannels) {
  const BvhPose pose = read(kHierarchy + motionOf("1 2 3 90 0 0 0 90 0\n", 1)).pose(0);
  expectAt(pose.positions[0], 1, 2, 3);
  expectAt(pose.positions[1], 5, 2, 3);
  expectAt(pose.positions[2], 6, 2, 0);
}

// Rx(90) Rz(90) takes (0,-4,0) by Rz to (4,0,0), by Rx to itself; Rz(90) Rx(90) by Rx to (0,0,-4),
// by Rz to itself.
TEST(Bvh, anotherOrderIsAnotherPose) {
  const std::string order = "Zrotation Xrotation Yrotation\n  JOINT";
  const std::string values = motionOf("0 0 0 90 90 0 0 0 0\n", 1);
  expectAt(read(kHierarchy + values).pose(0).positions[1], 0, 0, -4);
  const std::string swapped = changed(kHierarchy, order, "Xrotation Zrotation Yrotation\n  JOINT");
  expectAt(read(swapped + values).pose(0).positions[1], 4, 0, 0);
}

TEST(Bvh, positionsMayFollowRotations) {
  const std::string rotated_first =
      changed(kHierarchy, "Xposition Yposition Zposition Zrotation Xrotation Yrotation",
              "Zrotation Xrotation Yrotation Zposition Yposition Xposition");
  const BvhPose pose = read(rotated_first + motionOf("90 0 0 3 2 1 0 90 0\n", 1)).pose(0);
  expectAt(pose.positions[0], 1, 2, 3);
  expectAt(pose.positions[2], 6, 2, 0);
}

TEST(Bvh, positionsOfAJointReplaceItsOffsetUnlessTheyAreAboutZero) {
  const std::string places =
      changed(kHierarchy, "CHANNELS 3 Zrotation Xrotation Yrotation",
              "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation");
  const BvhMotion replacing =
      read(places + motionOf("0 0 0 0 0 0 0 -5 0 0 0 0\n0 0 0 0 0 0 0 -6 0 0 0 0\n", 2));
  expectAt(replacing.pose(0).positions[1], 0, -5, 0);
  expectAt(replacing.pose(1).positions[2], 0, -9, 1);
  const BvhMotion displacing = read(places + motionOf("0 0 0 0 0 0 0 0.01 0 0 0 0\n", 1));
  expectAt(displacing.pose(0).positions[1], 0, -3.99, 0);
}

TEST(Bvh, readsAnySpacingLineEndAndCase) {
  const BvhMotion plain = read(kHierarchy + motionOf("1 2 3 90 0 0 0 90 0\n", 1));
  std::string windows;
  for (char c : kHierarchy + motionOf("1 2 3 90 0 0 0 90 0\n", 1))
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const std::string odd =
      "\n hierarchy\n\n\tRoot\tHips{\tOFFSET 0 0\n 0 Channels 6 XPOSITION yposition Zposition "
      "zrotation Xrotation Yrotation Joint Knee{ offset 0 -4 0 CHANNELS 3 Zrotation Xrotation "
      "Yrotation END SITE{OFFSET 0 -3 1}}}\nmotion\nframes : 1\n\nFRAME  TIME:.025\n\n"
      "  1\t2 3.  9e1 0 -0 0 +90 0  \n\n";
  for (const std::string& text : {windows, odd, "\xEF\xBB\xBF" + windows}) {
    const BvhMotion motion = read(text);
    EXPECT_EQ(motion.joints[1].name, "Knee");
    EXPECT_DOUBLE_EQ(motion.frame_time, plain.frame_time);
    EXPECT_EQ(motion.frames, plain.frames);
    expectAt(motion.pose(0).positions[2], 6, 2, 0);
  }
}

TEST(Bvh, namesMayHoldBlanksAndColons) {
  const BvhMotion motion = read(changed(kHierarchy, "JOINT Knee", "JOINT Bip01 L: Calf") +
                                motionOf("0 0 0 0 0 0 0 0 0\n", 1));
  EXPECT_EQ(motion.joints[1].name, "Bip01 L: Calf");
}

TEST(Bvh, aFrameOfAnotherLengthIsRefused) {
  EXPECT_EQ(faultOf(kHierarchy + motionOf("0 0 0 0 0 0 0 0 0\n0 0 0 0 0 0 0 0\n", 2)),
            "walk.bvh, line 20: frame 2 has 8 values, the hierarchy has 9 channels");
  EXPECT_EQ(faultOf(kHierarchy + motionOf("0 0 0 0 0 0 0 0 0 0\n", 1)),
            "walk.bvh, line 19: frame 1 has 10 values, the hierarchy has 9 channels");
}

TEST(Bvh, whatIsNoNumberIsRefused) {
  EXPECT_EQ(faultOf(kHierarchy + motionOf("0 0 0 nan 0 0 0 0 0\n", 1)),
            "walk.bvh, line 19: value 4 of frame 1 is \"nan\", allowed is a finite number");
  EXPECT_EQ(faultOf(kHierarchy + motionOf("0 0 0 0 0 0 0 0 -inf\n", 1)),
            "walk.bvh, line 19: value 9 of frame 1 is \"-inf\", allowed is a finite number");
  EXPECT_EQ(faultOf(kHierarchy + motionOf("0 0 0 0 0,5 0 0 0 0\n", 1)),
            "walk.bvh, line 19: value 5 of frame 1 is \"0,5\", allowed is a number");
  EXPECT_EQ(faultOf(changed(kHierarchy, "0 -4 0", "0 x 0")),
            "walk.bvh, line 8: the offset of Knee is \"x\", allowed is a number");
}

TEST(Bvh, theNumberOfFramesMustBeRight) {
  EXPECT_EQ(faultOf(kHierarchy + motionOf("", 0)),
            "walk.bvh, line 17: the file has no frames, at least one is needed");
  EXPECT_EQ(faultOf(kHierarchy + motionOf("0 0 0 0 0 0 0 0 0\n", 3)),
            "walk.bvh, line 18: Frames: tells 3, the file has 1 lines of them");
  EXPECT_EQ(faultOf(kHierarchy + motionOf("0 0 0 0 0 0 0 0 0\n0 0 0 0 0 0 0 0 0\n", 1)),
            "walk.bvh, line 18: Frames: tells 1, the file has 2 lines of them");
  EXPECT_EQ(faultOf(kHierarchy + motionOf("", -2)),
            "walk.bvh, line 17: the number of frames is -2, allowed is a whole number from 0 on");
}

TEST(Bvh, theFrameTimeMustBePositive) {
  EXPECT_EQ(faultOf(kHierarchy + motionOf("0 0 0 0 0 0 0 0 0\n", 1, "0")),
            "walk.bvh, line 18: the frame time is 0.000000 s, allowed is more than 0");
  EXPECT_EQ(faultOf(kHierarchy + motionOf("0 0 0 0 0 0 0 0 0\n", 1, "-0.01")),
            "walk.bvh, line 18: the frame time is -0.010000 s, allowed is more than 0");
}

TEST(Bvh, otherFilesAreRefused) {
  const std::string no_bvh =
      "walk.bvh, line 1: this is not a BVH file, which begins with HIERARCHY";
  EXPECT_EQ(faultOf(""), no_bvh);
  EXPECT_EQ(faultOf(std::string("\x89PNG\r\n\0\0\0\rIHDR", 15)), no_bvh);
  EXPECT_EQ(faultOf("HIERARCHY\nJOINT Hips\n"),
            "walk.bvh, line 1: no ROOT after HIERARCHY, a BVH file's skeleton begins with one");
}

TEST(Bvh, brokenHierarchiesAreRefused) {
  const std::string motion = motionOf("0 0 0 0 0 0 0 0 0\n", 1);
  EXPECT_EQ(faultOf(changed(kHierarchy, "3 Zrotation", "3 Wrotation") + motion),
            "walk.bvh, line 9: unknown channel \"Wrotation\", allowed are Xposition, Yposition, "
            "Zposition, Xrotation, Yrotation, Zrotation");
  EXPECT_EQ(faultOf(changed(kHierarchy, "CHANNELS 3", "CHANNELS 7") + motion),
            "walk.bvh, line 9: Knee has 7 channels, allowed are 0 to 6");
  EXPECT_EQ(faultOf(changed(kHierarchy, "ROOT Hips\n", "ROOT\n") + motion),
            "walk.bvh, line 3: a ROOT has no name");
  EXPECT_EQ(faultOf(kHierarchy + kHierarchy.substr(10)),
            "walk.bvh, line 16: a second ROOT, allowed is one skeleton per file");
  EXPECT_EQ(faultOf(changed(kHierarchy, "    End Site", "    Sphere") + motion),
            "walk.bvh, line 10: \"Sphere\" stands in Knee, allowed are OFFSET, CHANNELS, JOINT, "
            "End Site and \"}\"");
}

TEST(Bvh, cutOffFilesAreRefused) {
  const std::string whole = kHierarchy + motionOf("0 0 0 0 0 0 0 0 0\n", 1);
  EXPECT_EQ(faultOf(kHierarchy.substr(0, kHierarchy.find("    End"))),
            "walk.bvh, line 9: the file ends where the \"}\" of Knee is expected");
  EXPECT_EQ(faultOf(kHierarchy),
            "walk.bvh, line 15: the file ends where MOTION after the hierarchy is expected");
  EXPECT_EQ(faultOf(whole.substr(0, whole.find("Frame Time"))),
            "walk.bvh, line 17: the file ends where Frame Time: after Frames: is expected");
  // Wherever it is cut before its last number, a sentence comes, no crash and no motion.
  for (size_t length = 0; length + 3 < whole.size(); ++length)
    EXPECT_NE(faultOf(whole.substr(0, length)), "") << length;
}

TEST(Bvh, aDeepHierarchyEndsInASentence) {
  std::string deep = "HIERARCHY\nROOT a\n{\n";
  for (int i = 0; i < 5000; ++i) deep += "JOINT a\n{\n";
  EXPECT_EQ(faultOf(deep), "walk.bvh, line 4002: the file has more than the 2000 joints allowed");
}

TEST(Bvh, aFileThatCannotBeReadIsNamed) {
  const auto fault = [](const std::string& path) { return errorTextOf([&] { readBvh(path); }); };
  EXPECT_EQ(fault("/nowhere/walk.bvh"),
            "cannot read the BVH file /nowhere/walk.bvh: there is no such file");
  EXPECT_EQ(fault("/"),
            "cannot read the BVH file /: it is a folder, pipe or device, allowed are files");
}

}  // namespace
}  // namespace markerless_mocap
