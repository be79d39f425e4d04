/// How the background is learned, kept and followed.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "silhouette/background/background.h"
#include "silhouette/background/background_learner.h"
#include "silhouette/background/color_modes.h"
#include "silhouette/scene.h"

namespace markerless_mocap {
namespace {

SilhouetteOptions ofModel(const std::string& model) {
  SilhouetteOptions options;
  options.model = model;
  return options;
}

class BackgroundModel : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Models, BackgroundModel,
                         testing::Values("gaussian", "mean_shift", "mog2", "knn"));

TEST_P(BackgroundModel, FindsADiscAndNothingElse) {
  const cv::Mat scene = makeScene(3);
  SilhouetteExtractor extractor = learned(scene, ofModel(GetParam()));
  EXPECT_EQ(cv::countNonZero(extractor.update(withNoise(scene, 100)).mask), 0);
  cv::Mat image = scene.clone(), disc = exactMask({});
  cv::circle(image, {80, 60}, 25, {220, 20, 20}, cv::FILLED);
  cv::circle(disc, {80, 60}, 25, 255, cv::FILLED);
  EXPECT_GT(iou(extractor.update(withNoise(image, 101)).mask, disc), 0.97);
}

TEST_P(BackgroundModel, SettingsChangeAndTheBackgroundStays) {
  const cv::Mat scene = makeScene(3);
  const SilhouetteOptions options = ofModel(GetParam());
  SilhouetteExtractor extractor = learned(scene, options);
  const cv::Mat image = withPerson(scene);
  SilhouetteOptions blind = options;
  blind.threshold_sigmas = blind.min_sigma = 50;  // nothing differs that much
  // These are fixed.
  blind.background_frames = 99;
  blind.model = "network";
  blind.background = "recording";
  blind.max_megapixels = 0.01;
  blind.network.file = "none";
  extractor.change(blind);
  EXPECT_EQ(cv::countNonZero(extractor.update(image).mask), 0);
  extractor.change(options);
  EXPECT_GT(iou(extractor.update(image).mask, exactMask()), 0.95);
  blind.threshold_sigmas = 99;
  EXPECT_THROW(extractor.change(blind), std::invalid_argument);
  EXPECT_GT(iou(extractor.update(image).mask, exactMask()), 0.95);
}

TEST_P(BackgroundModel, SettingsMayChangeWhileItLearns) {
  const cv::Mat scene = makeScene(3);
  SilhouetteOptions options = ofModel(GetParam());
  SilhouetteExtractor extractor(options);
  for (int i = 0; i < options.background_frames; ++i) {
    if (i == 5) {
      options.open_radius_px = 0;
      extractor.change(options);
    }
    EXPECT_EQ(extractor.update(withNoise(scene, i)).state, SilhouetteState::kLearning);
  }
  EXPECT_GT(iou(extractor.update(withPerson(scene)).mask, exactMask()), 0.95);
}

class OwnModel : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Models, OwnModel, testing::Values("gaussian", "mean_shift"));

TEST_P(OwnModel, PersonWhoStandsStillForAMinuteIsStillThere) {
  const cv::Mat scene = makeScene(3);
  SilhouetteExtractor extractor = learned(scene, ofModel(GetParam()));
  cv::Mat mask;
  for (int i = 0; i < 600; ++i)  // 10 Hz
    mask = extractor.update(withNoise(withPerson(scene), 100 + i)).mask;
  EXPECT_GT(iou(mask, exactMask()), 0.97);
}

TEST_P(OwnModel, SlowDriftIsFollowedAlsoBehindThePerson) {
  const cv::Mat scene = makeScene(3);
  SilhouetteOptions options = ofModel(GetParam());
  options.remove_shadows = false;
  cv::Mat light = scene.clone();
  SilhouetteExtractor extractor = learned(scene, options);
  for (int i = 0; i < 800; ++i) {
    light = scene * (1 + 0.5 * i / 800);
    extractor.update(withNoise(withPerson(light), 100 + i));
  }
  // The light has changed by half, and the person goes away.
  const SilhouetteResult after = extractor.update(withNoise(light, 99));
  EXPECT_EQ(cv::countNonZero(after.mask), 0);
  EXPECT_NEAR(after.light_gain, 1, 0.15) << "the background has followed";
}

TEST_P(OwnModel, DriftOfAPartOfTheSceneIsFollowedUnlessTheRateIsZero) {
  const cv::Mat scene = makeScene(3);
  for (const double rate : {0.004, 0.0}) {
    SilhouetteOptions options = ofModel(GetParam());
    options.update_rate = rate;
    SilhouetteExtractor extractor = learned(scene, options);
    cv::Mat image, mask;
    for (int i = 0; i <= 1000; ++i) {
      image = scene.clone();
      image(cv::Rect(0, 0, 50, 120)) += cv::Scalar::all(20.0 * i / 1000);
      mask = extractor.update(withNoise(image, 100 + i)).mask;
    }
    if (rate > 0) {
      EXPECT_EQ(cv::countNonZero(mask), 0);
    }
    if (rate == 0) {
      EXPECT_GT(cv::countNonZero(mask), 2000);
    }
  }
}

TEST_P(OwnModel, LearnsFromAStreamThatAPersonCrosses) {
  const cv::Mat scene = makeScene(3);
  SilhouetteExtractor extractor(ofModel(GetParam()));
  for (int i = 0; i < 30; ++i)
    extractor.update(withNoise(withPerson(scene, {4 * i, 30, 30, 70}), i));
  EXPECT_EQ(cv::countNonZero(extractor.update(withNoise(scene, 100)).mask), 0);
  const cv::Mat mask = extractor.update(withNoise(withPerson(scene), 101)).mask;
  EXPECT_GT(iou(mask, exactMask()), 0.97);
}

TEST_P(OwnModel, SavedBackgroundGivesTheSameMasks) {
  const std::string path = testing::TempDir() + std::to_string(getpid()) + ".background";
  const cv::Mat scene = makeScene(3), image = withNoise(withPerson(scene), 100);
  SilhouetteExtractor first = learned(scene, ofModel(GetParam()));
  first.saveBackground(path);
  SilhouetteExtractor second(ofModel(GetParam()));
  second.loadBackground(path);
  const cv::Mat mask = first.update(image).mask;
  EXPECT_EQ(cv::countNonZero(second.update(image).mask != mask), 0);
  second.reset();
  EXPECT_EQ(cv::countNonZero(second.update(image).mask != mask), 0) << "a reset keeps the file's";
  second.relearn();
  EXPECT_EQ(second.update(image).state, SilhouetteState::kLearning);
  std::remove(path.c_str());
}

TEST(MeanShift, KnowsTwoColorsOfAPixel) {
  const cv::Mat dark = makeScene(3);
  cv::Mat bright = dark.clone();
  bright(cv::Rect(0, 0, 40, 120)) += cv::Scalar::all(60);  // a screen that blinks
  for (const std::string model : {"gaussian", "mean_shift"}) {
    SilhouetteExtractor extractor(ofModel(model));
    for (int i = 0; i < 30; ++i) extractor.update(withNoise(i / 5 % 3 ? dark : bright, i));
    const int found = cv::countNonZero(extractor.update(withNoise(bright, 50)).mask) +
                      cv::countNonZero(extractor.update(withNoise(dark, 51)).mask);
    if (model == "gaussian") {
      EXPECT_GT(found, 3000);
    }
    if (model == "mean_shift") {
      EXPECT_EQ(found, 0);
    }
  }
}

TEST(ColorModes, AreWhereTheSamplesAre) {
  std::vector<float> samples;
  for (int i = 0; i < 20; ++i) samples.push_back(i < 7 ? 200 + i % 3 : 50 + i % 3);
  const std::vector<ColorMode> modes = findColorModes(samples, 1, 4, 3);
  ASSERT_EQ(modes.size(), 2u);
  EXPECT_EQ(modes[0].count, 13);
  EXPECT_NEAR(modes[0].mean[0], 51, 1);
  EXPECT_EQ(modes[1].count, 7);
  EXPECT_NEAR(modes[1].mean[0], 201, 1);
}

TEST(BackgroundLearner, SpreadIsTheNoises) {
  BackgroundLearner learner(60, false);
  for (int i = 0; i < 60; ++i) learner.add(withNoise(makeScene(3), i));
  const Background background = learner.learn(1, 1);
  double sum = 0;
  for (int x = 0; x < kSize.width; ++x) sum += background.sigma(0, 60)[x];
  EXPECT_NEAR(sum / kSize.width / Background::kMeanScale, 2, 0.15);
}

TEST(Stale, IsABackgroundThatNoLongerFits) {
  const cv::Mat scene = makeScene(3);
  cv::Mat other;
  cv::flip(scene, other, 1);
  SilhouetteOptions options;
  options.stale_frames = 5;
  options.threshold_sigmas = 1;
  SilhouetteExtractor extractor = learned(scene, options);
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(extractor.update(other).state, SilhouetteState::kReady) << i;
  const SilhouetteResult fifth = extractor.update(other);
  EXPECT_EQ(fifth.state, SilhouetteState::kStale);
  EXPECT_GT(fifth.changed_fraction, 0.5);
  EXPECT_FALSE(fifth.mask.empty());
  EXPECT_EQ(extractor.update(scene).state, SilhouetteState::kReady) << "it fits again";
}

TEST(Stale, IsALightThatIsOff) {
  SilhouetteOptions options;
  options.stale_frames = 1;
  SilhouetteExtractor extractor = learned(makeScene(3), options);
  EXPECT_EQ(extractor.update(makeScene(3) * 0.3).state, SilhouetteState::kStale);
}

/// White and black images say nothing about the room.
TEST_P(OwnModel, LightThatBlindsTheCameraForAWhileChangesNothing) {
  cv::Mat scene = makeScene(3);
  cv::Mat dark = scene.rowRange(50, kSize.height);
  dark *= 0.2;  // does not become white
  const cv::Mat seen = withNoise(withPerson(scene), 300);
  for (const double light : {8.0, 0.02}) {
    SilhouetteExtractor blinded = learned(scene, ofModel(GetParam()));
    SilhouetteExtractor other = learned(scene, ofModel(GetParam()));
    for (int i = 0; i < 160; ++i) {
      const cv::Mat image = withNoise(withPerson(scene) * light, 100 + i);
      EXPECT_EQ(blinded.update(image).uncovered_fraction, 0);
    }
    EXPECT_EQ(cv::countNonZero(blinded.update(seen).mask != other.update(seen).mask), 0) << light;
  }
}

template <class ActT>
std::string refusal(const ActT& act) {
  try {
    act();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

constexpr int kWidthAt = 32;  // in a background file, bytes

long peakMemory_MB() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

TEST(BackgroundFile, UnusableOnesAreRefusedInOneSentence) {
  const std::string path = testing::TempDir() + std::to_string(getpid()) + "_bad.background";
  SilhouetteExtractor extractor(ofModel("gaussian"));
  EXPECT_EQ(refusal([&] { extractor.loadBackground("/no/such/file"); }),
            "the background file /no/such/file cannot be opened");
  std::ofstream(path) << "nonsense";
  EXPECT_EQ(refusal([&] { extractor.loadBackground(path); }),
            "the file " + path + " holds no background of a silhouette");
  Background({64, 48}, 3, 1).save(path);
  std::ofstream(path, std::ios::app) << "more";
  EXPECT_EQ(refusal([&] { extractor.loadBackground(path); }),
            "the background file " + path + " is shorter or longer than its head says");
  {
    Background({64, 48}, 3, 1).save(path);
    std::fstream damaged(path, std::ios::binary | std::ios::in | std::ios::out);
    damaged.seekp(kWidthAt);
    const int32_t sides[] = {8000, 8000};
    damaged.write(reinterpret_cast<const char*>(sides), sizeof sides);
  }
  const long before = peakMemory_MB();
  EXPECT_EQ(refusal([&] { extractor.loadBackground(path); }),
            "the background file " + path + " is shorter or longer than its head says");
  EXPECT_LT(peakMemory_MB(), before + 100) << "memory for a size that the file cannot have";
  Background({64, 48}, 3, 3).save(path);
  EXPECT_EQ(refusal([&] { extractor.loadBackground(path); }),
            "the background file " + path + " is not of the model gaussian");
  Background({64, 48}, 3, 1).save(path);
  extractor.loadBackground(path);
  EXPECT_EQ(refusal([&] { extractor.update(makeScene(3)); }),
            "silhouette: the image is 160 x 120 BGR, allowed is 64 x 48 BGR, as its background is, "
            "or to learn that anew");
  std::remove(path.c_str());
}

TEST(BackgroundFile, IsNotWrittenBeforeThereIsABackground) {
  SilhouetteExtractor gaussian(ofModel("gaussian"));
  gaussian.update(makeScene(3));
  EXPECT_EQ(refusal([&] { gaussian.saveBackground("/tmp/x"); }),
            "silhouette: the background is not learned yet, 1 of 30 images came");
  EXPECT_EQ(refusal([&] { learned(makeScene(3)).saveBackground("/no/such/folder/x"); }),
            "the background file /no/such/folder/x cannot be written");
  EXPECT_EQ(refusal([&] { SilhouetteExtractor(ofModel("knn")).saveBackground("x"); }),
            "silhouette: the background of the model knn cannot be saved, allowed are gaussian and "
            "mean_shift");
}

TEST(SilhouetteExtractor, ImagesOfFourThousandPixelsWork) {
  const cv::Size size(3840, 2160);
  const cv::Rect person(1700, 600, 300, 900);
  SilhouetteOptions options;
  options.background_frames = 2;
  const cv::Mat scene = makeScene(3, size);
  SilhouetteExtractor extractor(options);
  for (int i = 0; i < 2; ++i) extractor.update(scene);
  EXPECT_GT(iou(extractor.update(withPerson(scene, person)).mask, exactMask(person, size)), 0.99);
}

TEST(SilhouetteExtractor, MasksAreTheSameForAnyNumberOfThreads) {
  const cv::Mat scene = makeScene(3), image = withNoise(withPerson(scene), 100);
  cv::Mat masks[2];
  const int before = cv::getNumThreads();
  for (const int threads : {1, 2}) {
    cv::setNumThreads(threads);
    masks[threads - 1] = learned(scene).update(image).mask;
  }
  cv::setNumThreads(before);
  EXPECT_EQ(cv::countNonZero(masks[0] != masks[1]), 0);
}

}  // namespace
}  // namespace markerless_mocap
