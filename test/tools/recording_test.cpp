#include "tools/common/recording.h"

#include "markerless_mocap/camera/rig_file.h"
#include "tools/recording_fixture.h"

namespace markerless_mocap {
namespace {

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

TEST_F(RecordingTest, FrameSetsTellHowMuchLaterEachImageWasTaken) {
  {
    CameraBagWriter bag(path("in.bag"), ringOfFour(), 0);
    bag.writeTransforms(kSecond);
    for (int k = 0; k < 5; ++k)
      for (int i = 0; i < 4; ++i)
        bag.write(kSecond + k * kSecond / 10 + i * kSecond / 50, i, smallImage(true), cv::Mat());
    bag.commit();
  }
  RecordingOptions options;
  options.stamp_tolerance = 0.07;
  Recording recording(path("in.bag"), options);
  const auto frame_sets = allOf(recording);
  ASSERT_EQ(frame_sets.size(), 5u);
  for (const FrameSet& frame_set : frame_sets)
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(frame_set.frames[size_t(i)].later_s, 0.02 * i - 0.03, 1e-6);
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
            "the start is 5 s, after the end of the recording, which has 0.9 s");
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
