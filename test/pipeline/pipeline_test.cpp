#include "markerless_mocap/pipeline/pipeline.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "body/body_fixture.h"
#include "hull/hull_scene.h"

namespace markerless_mocap {
namespace {

constexpr int kCameras = 4;
constexpr int kBackgroundFrames = 3;

/// Four cameras around a cube of 1.2 m, in which a sphere may stand.
class PipelineTest : public ::testing::Test {
 protected:
  PipelineTest() : rig_(makeRig(kCameras)) {
    options_.hull = makeOptions();
    options_.silhouette.background_frames = kBackgroundFrames;
  }

  Pipeline pipeline() const {
    PersonResources sources;
    sources.urdf_template = humanTemplate();
    return {rig_, sources, options_};
  }

  std::vector<CameraFrame> empty() const {
    const cv::Mat grey(rig_[0].height(), rig_[0].width(), CV_8UC3, cv::Scalar(90, 90, 90));
    return std::vector<CameraFrame>(kCameras, CameraFrame{grey, {}});
  }

  /// A red sphere before the grey wall.
  std::vector<CameraFrame> withSphere() const {
    std::vector<CameraFrame> frames = empty();
    for (int i = 0; i < kCameras; ++i) {
      frames[i].image = frames[i].image.clone();
      frames[i].image.setTo(cv::Scalar(20, 20, 220), renderMask(rig_[i], {Sphere()}));
    }
    return frames;
  }

  std::vector<CameraFrame> masksOnly() const {
    std::vector<CameraFrame> frames(kCameras);
    for (int i = 0; i < kCameras; ++i) frames[i].mask = renderMask(rig_[i], {Sphere()});
    return frames;
  }

  CameraRig rig_;
  PipelineOptions options_;
};

TEST_F(PipelineTest, LearnsTheBackgroundThenCarvesTheSphere) {
  Pipeline pipeline = this->pipeline();
  for (int k = 0; k < kBackgroundFrames; ++k) {
    const PipelineResult learning = pipeline.process(k, empty());
    EXPECT_TRUE(learning.learning);
    EXPECT_TRUE(learning.hull.voxels.empty());
  }
  const PipelineResult result = pipeline.process(kBackgroundFrames, withSphere());
  EXPECT_FALSE(result.learning);
  ASSERT_EQ(result.masks.size(), size_t(kCameras));
  EXPECT_EQ(result.hull.status, HullStatus::kOk) << result.hull.reason;
  const double sphere_litres = 4.0 / 3.0 * M_PI * 4.0 * 4.0 * 4.0;
  EXPECT_GT(result.hull.litres(), 0.9 * sphere_litres);
}

TEST_F(PipelineTest, GivenMasksNeedNoLearningAndAreNotTouched) {
  Pipeline pipeline = this->pipeline();
  const std::vector<CameraFrame> frames = masksOnly();
  const PipelineResult result = pipeline.process(0, frames);
  EXPECT_FALSE(result.learning);
  EXPECT_EQ(result.hull.status, HullStatus::kOk) << result.hull.reason;
  for (int i = 0; i < kCameras; ++i)
    EXPECT_EQ(cv::countNonZero(result.masks[i] != frames[i].mask), 0);
}

TEST_F(PipelineTest, SphereIsNoPersonAndThePoseSaysSo) {
  Pipeline pipeline = this->pipeline();
  const PipelineResult result = pipeline.process(0, masksOnly());
  EXPECT_EQ(result.pose.status, PoseStatus::kLost);
  EXPECT_FALSE(result.pose.reason.empty());
}

TEST_F(PipelineTest, ProductsOnDemandAreMadeToStartAndChangeNoPose) {
  using OnDemand = Pipeline::OnDemand;
  for (const OnDemand products : {OnDemand::kParts, OnDemand::kPartsAndVoxels}) {
    Pipeline always = pipeline(), on_demand = pipeline();
    on_demand.setOnDemand(products);
    int trees = 0;
    on_demand.setStageWatch([&](const std::string& stage, const std::function<void()>& work) {
      trees += stage == PoseTreeOptions::kStage;
      work();
    });
    const int frames = 60;
    for (int k = 0; k < frames; ++k) {
      const PipelineResult one = always.process(k * 33333333, masksOnly());
      const PipelineResult other = on_demand.process(k * 33333333, masksOnly());
      EXPECT_EQ(one.pose.reason, other.pose.reason);
      EXPECT_EQ(one.hull.status, other.hull.status);
      EXPECT_EQ(one.hull.voxels.size(), other.hull.voxels.size()) << "asked for while lost";
    }
    EXPECT_GE(trees, 1);
    EXPECT_LT(trees, frames / 4);
  }
}

TEST_F(PipelineTest, SphereHasNoLabelledTreeAndTheTreeSaysWhy) {
  Pipeline pipeline = this->pipeline();
  const PipelineResult result = pipeline.process(0, masksOnly());
  EXPECT_FALSE(result.tree.valid());
  EXPECT_FALSE(result.tree.reason.empty());
}

TEST_F(PipelineTest, MissingCameraHasNoVote) {
  Pipeline pipeline = this->pipeline();
  std::vector<CameraFrame> frames = masksOnly();
  const size_t all = pipeline.process(0, frames).hull.voxels.size();
  frames[2] = {};
  const PipelineResult result = pipeline.process(1, frames);
  EXPECT_TRUE(result.masks[2].empty());
  EXPECT_EQ(result.hull.status, HullStatus::kOk) << result.hull.reason;
  EXPECT_GE(result.hull.voxels.size(), all);
}

TEST_F(PipelineTest, CameraThatLearnsLaterIsLeftOutMeanwhile) {
  Pipeline pipeline = this->pipeline();
  for (int k = 0; k < kBackgroundFrames; ++k) {
    std::vector<CameraFrame> frames = empty();
    if (k == 0) frames[1] = {};
    pipeline.process(k, frames);
  }
  const PipelineResult result = pipeline.process(kBackgroundFrames, withSphere());
  EXPECT_FALSE(result.learning);
  EXPECT_TRUE(result.masks[1].empty());
  EXPECT_EQ(result.hull.status, HullStatus::kOk) << result.hull.reason;
}

TEST_F(PipelineTest, NoCameraAtAllHasAReason) {
  Pipeline pipeline = this->pipeline();
  const PipelineResult result = pipeline.process(0, std::vector<CameraFrame>(kCameras));
  EXPECT_FALSE(result.learning);
  EXPECT_EQ(result.hull.status, HullStatus::kNoCameras);
  EXPECT_EQ(result.pose.status, PoseStatus::kLost);
}

TEST_F(PipelineTest, WrongSizeNamesCameraAndBothSizes) {
  Pipeline pipeline = this->pipeline();
  std::vector<CameraFrame> frames = masksOnly();
  frames[3].mask = cv::Mat::zeros(50, 40, CV_8UC1);
  EXPECT_EQ(errorTextOf([&] { pipeline.process(0, frames); }),
            "mask of camera cam3 is 40 x 50 pixels, its calibration says 160 x 120");
}

TEST_F(PipelineTest, WrongNumberOfFramesIsRefused) {
  Pipeline pipeline = this->pipeline();
  EXPECT_EQ(errorTextOf([&] { pipeline.process(0, {}); }),
            "pipeline got 0 frames, the rig has 4 cameras");
}

TEST_F(PipelineTest, GivenBackgroundsNeedNoEmptyRoom) {
  RecordingLearner learner(options_.silhouette, 2);
  for (int i = 0; i < 2; ++i) learner.add(empty()[0].image);
  Pipeline pipeline = this->pipeline();
  EXPECT_EQ(errorTextOf([&] { pipeline.useBackgrounds({learner.learn()}); }),
            "pipeline got 1 backgrounds, the rig has 4 cameras");
  pipeline.useBackgrounds(std::vector<SharedBackground>(kCameras, learner.learn()));
  EXPECT_FALSE(pipeline.process(0, empty()).learning);
  pipeline.useBackgrounds(std::vector<SharedBackground>(kCameras));
  EXPECT_TRUE(pipeline.process(0, empty()).learning) << "no background: the first images";
}

TEST_F(PipelineTest, WatchSeesEveryStageInOrder) {
  Pipeline pipeline = this->pipeline();
  std::vector<std::string> seen;
  pipeline.setStageWatch([&](const char* stage, const std::function<void()>& work) {
    seen.push_back(stage);
    work();
  });
  pipeline.process(0, masksOnly());
  EXPECT_EQ(seen, (std::vector<std::string>{"silhouette", "visual_hull", "body_segmentation",
                                            "pose_tree", "pose_fitting"}));
}

/// What comes out of a stream of the empty room, then of the sphere nearer and nearer.
class PipelineStream : public PipelineTest {
 protected:
  static constexpr int kInstants = kBackgroundFrames + 8;

  FrameSet instantAt(int k) const {
    FrameSet instant{k, empty(), {}};
    for (int i = 0; k >= kBackgroundFrames && i < kCameras; ++i) {
      Sphere sphere;
      sphere.center.x() += 0.01 * k;
      cv::Mat& image = instant.frames[i].image;
      image = image.clone();
      image.setTo(cv::Scalar(20, 20, 220), renderMask(rig_[i], {sphere}));
    }
    return instant;
  }
  Pipeline::Source source(int instants) const {
    return [this, instants, k = 0]() mutable -> std::optional<FrameSet> {
      if (k == instants) return std::nullopt;
      return instantAt(k++);
    };
  }
};

TEST_F(PipelineStream, GivesWhatInstantsGiveOneByOne) {
  Pipeline one_by_one = pipeline(), stream = pipeline();
  int k = 0;
  stream.processStream(source(kInstants),
                       [&](const FrameSet& instant, const PipelineResult& result) {
                         ASSERT_EQ(instant.stamp_ns, k);
                         const PipelineResult expected = one_by_one.process(k, instantAt(k).frames);
                         ++k;
                         ASSERT_EQ(result.learning, expected.learning);
                         ASSERT_EQ(result.hull.voxels.size(), expected.hull.voxels.size());
                         for (size_t v = 0; v < expected.hull.voxels.size(); ++v)
                           ASSERT_EQ(result.hull.voxels[v].index, expected.hull.voxels[v].index);
                         EXPECT_EQ(result.parts.reason, expected.parts.reason);
                         EXPECT_EQ(result.tree.reason, expected.tree.reason);
                         EXPECT_EQ(result.pose.reason, expected.pose.reason);
                         EXPECT_EQ(result.body == nullptr, result.learning);
                       });
  EXPECT_EQ(k, kInstants);
}

TEST_F(PipelineStream, NothingIsAskedForAfterTheEnd) {
  int asked = 0;
  const Pipeline::Source three = source(3);
  pipeline().processStream(
      [&] {
        ++asked;
        return three();
      },
      [](const FrameSet&, const PipelineResult&) {});
  EXPECT_EQ(asked, 4);
}

TEST_F(PipelineStream, ComplaintsOfStagesSourceAndSinkComeThrough) {
  const Pipeline::Sink ignore = [](const FrameSet&, const PipelineResult&) {};
  EXPECT_EQ(errorTextOf([&] { pipeline().processStream([] { return FrameSet(); }, ignore); }),
            "pipeline got 0 frames, the rig has 4 cameras");
  const auto complain = [] { throw std::invalid_argument("no"); };
  EXPECT_EQ(errorTextOf([&] {
              pipeline().processStream(
                  [&]() -> std::optional<FrameSet> {
                    complain();
                    return std::nullopt;
                  },
                  ignore);
            }),
            "no");
  EXPECT_EQ(errorTextOf([&] {
              pipeline().processStream(source(1),
                                       [&](const FrameSet&, const PipelineResult&) { complain(); });
            }),
            "no");
}

}  // namespace
}  // namespace markerless_mocap
