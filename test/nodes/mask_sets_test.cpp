#include "nodes/common/mask_sets.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>

#include "ros/camera_conversions.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kFrame_ns = 40'000'000;

class MaskSetsTest : public ::testing::Test {
 protected:
  MaskSetsTest()
      : sets(
            {2, 2, 0.005, 0.1, {}}, [this](const MaskSet&) { return images_lack; },
            [this](const MaskSet& set) { passed.push_back(set); }) {}
  void add(size_t camera, int frame) {
    const auto mask = boost::make_shared<sensor_msgs::Image>();
    mask->header.stamp = rosTime(1'000'000'000 + frame * kFrame_ns);
    sets.add(camera, mask);
  }
  void addBoth(int frame) {
    add(0, frame);
    add(1, frame);
  }

  bool images_lack = false;
  std::vector<MaskSet> passed;
  MaskSets sets;
};

TEST_F(MaskSetsTest, JoinsSilhouettesOfOneTime) {
  addBoth(0);
  ASSERT_EQ(passed.size(), 1u);
  EXPECT_EQ(countOf(passed[0]), 2u);
}

TEST_F(MaskSetsTest, WaitForImagesInTheOrderOfTime) {
  images_lack = true;
  addBoth(0);
  addBoth(1);
  EXPECT_TRUE(passed.empty());
  images_lack = false;
  sets.passOn();
  ASSERT_EQ(passed.size(), 2u);
  EXPECT_LT(passed[0].stamp_ns, passed[1].stamp_ns);
}

TEST_F(MaskSetsTest, DoNotWaitForImagesFromBeforeAJumpOfTime) {
  images_lack = true;
  addBoth(1000);
  for (int frame = 0; frame < 4; ++frame) addBoth(frame);
  images_lack = false;
  sets.passOn();
  ASSERT_FALSE(passed.empty());
  for (const MaskSet& set : passed) EXPECT_LT(set.stamp_ns, 2'000'000'000);
}

TEST_F(MaskSetsTest, TellALoneSilhouetteBetweenSetsOfMore) {
  MaskSet lone;
  lone.stamp_ns = 1'100'000'000;
  lone.present = {true, false};
  EXPECT_FALSE(sets.isStray(lone));  // nothing has been used yet
  addBoth(0);
  sets.noteUsed(passed[0]);
  EXPECT_TRUE(sets.isStray(lone));
  EXPECT_FALSE(sets.isStray(passed[0]));
  lone.stamp_ns = 1'600'000'000;
  EXPECT_FALSE(sets.isStray(lone));
}

}  // namespace
}  // namespace markerless_mocap
