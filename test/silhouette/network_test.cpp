/// The model network, with nets that tell blue from the rest.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "error_text_of.h"
#include "silhouette/onnx_writer.h"
#include "silhouette/scene.h"

namespace markerless_mocap {
namespace {

/// Of red, green and blue from 0 to 1: positive where blue is stronger than red by 0.3.
const std::vector<float> kBlueness = {-100, 0, 100};
constexpr float kBias = -30;

class NetworkModel : public testing::Test {
 protected:
  ~NetworkModel() override { std::remove(path_.c_str()); }

  SilhouetteOptions options(const cv::Size& size = kSize) const {
    SilhouetteOptions options;
    options.model = "network";
    options.network.file = path_;
    options.network.width_px = size.width;
    options.network.height_px = size.height;
    options.open_radius_px = options.close_radius_px = 0;
    return options;
  }

  /// The mask of an image with a person, from the first image on.
  static cv::Mat maskBy(const SilhouetteOptions& options, int channels = 3) {
    SilhouetteExtractor extractor(options);
    const SilhouetteResult result = extractor.update(withPerson(makeScene(channels)));
    EXPECT_EQ(result.state, SilhouetteState::kReady);
    EXPECT_EQ(result.changed_fraction, 0.0);
    return result.mask;
  }
  static void expectExact(const SilhouetteOptions& options) {
    EXPECT_EQ(cv::norm(maskBy(options), exactMask(), cv::NORM_INF), 0.0);
  }
  std::string refusal(const SilhouetteOptions& options) const {
    return errorTextOf([&] { SilhouetteExtractor{options}; });
  }

  /// One plane of probabilities.
  void writeBlueness(const cv::Size& size = kSize) const {
    OnnxNet({1, 3, size.height, size.width})
        .conv1x1("image", "blueness", {kBlueness}, {kBias})
        .sigmoid("blueness", "person")
        .output("person", {1, 1, size.height, size.width})
        .write(path_);
  }
  /// Three planes of logits: background, person, and a class that is never chosen.
  void writeClasses() const {
    OnnxNet({1, 3, kSize.height, kSize.width})
        .conv1x1("image", "classes", {{0, 0, 0}, kBlueness, {0, 0, 0}}, {0, kBias, -50})
        .output("classes", {1, 3, kSize.height, kSize.width})
        .write(path_);
  }

  /// The tests also run as silhouette_plain_test, maybe at the same time.
  const std::string path_ = testing::TempDir() + std::to_string(getpid()) + ".onnx";
};

TEST_F(NetworkModel, planeOfProbabilitiesGivesTheMask) {
  writeBlueness();
  expectExact(options());
}

TEST_F(NetworkModel, smallInputIsScaledBack) {
  writeBlueness(kSize / 2);
  EXPECT_GT(iou(maskBy(options(kSize / 2)), exactMask()), 0.95);
}

TEST_F(NetworkModel, thresholdDecides) {
  OnnxNet({1, 3, kSize.height, kSize.width})
      .conv1x1("image", "red_part", {{1, 0, 0}}, {0})
      .output("red_part", {1, 1, kSize.height, kSize.width})
      .write(path_);
  SilhouetteOptions asked = options();  // the person's red is 30, the room's 90 and more
  asked.network.threshold = 0.25;
  EXPECT_EQ(cv::norm(maskBy(asked), 255 - exactMask(), cv::NORM_INF), 0.0);
  asked.network.threshold = 0.1;
  EXPECT_EQ(cv::countNonZero(maskBy(asked) == 0), 0);
}

TEST_F(NetworkModel, orderOfColorsIsAsAskedFor) {
  writeBlueness();
  SilhouetteOptions asked = options();
  asked.network.swap_red_and_blue = false;  // then the net looks for red
  EXPECT_EQ(cv::countNonZero(maskBy(asked)), 0);
}

TEST_F(NetworkModel, channelsAreShiftedAndScaled) {
  // Of the whole picture only a red of 90 and more is positive after the shift.
  OnnxNet({1, 3, kSize.height, kSize.width})
      .conv1x1("image", "person", {{-1, 0, 0}}, {0})
      .output("person", {1, 1, kSize.height, kSize.width})
      .write(path_);
  SilhouetteOptions asked = options();
  asked.network.output_values = "logits";
  asked.network.mean = {60, 7, 7};
  asked.network.deviation = {0.5, 9, 9};
  expectExact(asked);
  asked.network.mean = {7, 60, 60};
  EXPECT_EQ(cv::countNonZero(maskBy(asked)), 0);
}

TEST_F(NetworkModel, severalPlanesOfLogitsCompete) {
  writeClasses();
  SilhouetteOptions asked = options();
  asked.network.output_values = "logits";
  asked.network.person_class = 1;
  expectExact(asked);
  asked.network.person_class = 0;
  EXPECT_EQ(cv::norm(maskBy(asked), 255 - exactMask(), cv::NORM_INF), 0.0);
  asked.network.person_class = 2;
  EXPECT_EQ(cv::countNonZero(maskBy(asked)), 0);
}

TEST_F(NetworkModel, labelsAreCompared) {
  OnnxNet({1, 3, kSize.height, kSize.width})
      .conv1x1("image", "blueness", {kBlueness}, {kBias})
      .sigmoid("blueness", "is_person")
      .conv1x1("is_person", "label", {{15}}, {0})
      .output("label", {1, 1, kSize.height, kSize.width})
      .write(path_);
  SilhouetteOptions asked = options();
  asked.network.output_values = "labels";
  asked.network.person_class = 15;
  expectExact(asked);
  asked.network.person_class = 14;
  EXPECT_EQ(cv::countNonZero(maskBy(asked)), 0);
}

TEST_F(NetworkModel, pixelByPixelIsReadAsSuch) {
  OnnxNet({1, kSize.height, kSize.width, 3})
      .transpose("image", "planes", {0, 3, 1, 2})
      .conv1x1("planes", "classes", {{0, 0, 0}, kBlueness}, {0, kBias})
      .transpose("classes", "pixels", {0, 2, 3, 1})
      .output("pixels", {1, kSize.height, kSize.width, 2})
      .write(path_);
  SilhouetteOptions asked = options();
  asked.network.layout = "nhwc";
  asked.network.output_values = "logits";
  asked.network.person_class = 1;
  expectExact(asked);
}

TEST_F(NetworkModel, oneOfSeveralOutputsIsNamed) {
  OnnxNet({1, 3, kSize.height, kSize.width})
      .conv1x1("image", "blueness", {kBlueness}, {kBias})
      .sigmoid("blueness", "person")
      .conv1x1("person", "opposite", {{-1}}, {1})
      .output("person", {1, 1, kSize.height, kSize.width})
      .output("opposite", {1, 1, kSize.height, kSize.width})
      .write(path_);
  SilhouetteOptions asked = options();
  EXPECT_EQ(refusal(asked), "the network file " + path_ +
                                " has several outputs, name one of them in "
                                "silhouette/network/output: opposite, person");
  asked.network.output = "opposite";
  EXPECT_EQ(cv::norm(maskBy(asked), 255 - exactMask(), cv::NORM_INF), 0.0);
  asked.network.output = "person";
  expectExact(asked);
  asked.network.output = "nobody";
  EXPECT_EQ(refusal(asked).rfind("the network file " + path_ + " ", 0), 0u) << refusal(asked);
}

TEST_F(NetworkModel, greyImagesAreTakenToo) {
  OnnxNet({1, 3, kSize.height, kSize.width})
      .conv1x1("image", "person", {{100, 100, 100}}, {-240})
      .output("person", {1, 1, kSize.height, kSize.width})
      .write(path_);
  SilhouetteOptions asked = options();
  asked.network.output_values = "logits";
  EXPECT_EQ(cv::norm(maskBy(asked, 1), exactMask(), cv::NORM_INF), 0.0);
}

TEST_F(NetworkModel, masksAreCleaned) {
  writeBlueness();
  SilhouetteOptions asked = options();
  asked.min_blob_px = kPerson.area() + 1;
  EXPECT_EQ(cv::countNonZero(maskBy(asked)), 0);
}

TEST_F(NetworkModel, resetLearnsNothing) {
  writeBlueness();
  SilhouetteExtractor extractor(options());
  extractor.update(makeScene(3));
  extractor.relearn();
  const SilhouetteResult result = extractor.update(withPerson(makeScene(3)));
  EXPECT_EQ(result.state, SilhouetteState::kReady);
  EXPECT_EQ(cv::norm(result.mask, exactMask(), cv::NORM_INF), 0.0);
}

TEST_F(NetworkModel, hasNoBackgroundToSave) {
  writeBlueness();
  const SilhouetteExtractor extractor(options());
  EXPECT_EQ(errorTextOf([&] { extractor.saveBackground(path_ + ".background"); }),
            "silhouette: the background of the model network cannot be saved, allowed are gaussian "
            "and mean_shift");
}

TEST_F(NetworkModel, faultyFilesAreToldInOneSentence) {
  SilhouetteOptions asked = options();
  EXPECT_EQ(refusal(asked), "the network file " + path_ + " cannot be opened");
  std::ofstream(path_) << "no net";
  EXPECT_EQ(refusal(asked).rfind("the network file " + path_ + " cannot be loaded", 0), 0u)
      << refusal(asked);
  EXPECT_EQ(refusal(asked).find('\n'), std::string::npos);
  asked.network.file.clear();
  EXPECT_EQ(refusal(asked),
            "silhouette/network/file is empty, the model network needs the path of an ONNX file");
}

TEST_F(NetworkModel, outputsOfAnotherShapeAreTold) {
  writeClasses();
  SilhouetteOptions asked = options();
  asked.network.person_class = 3;
  EXPECT_EQ(refusal(asked), "the network file " + path_ +
                                " gives an output of 1 x 3 x 120 x 160, expected is one plane, or "
                                "several with the class 3 in the order nchw");
  asked.network.output_values = "labels";
  EXPECT_EQ(refusal(asked), "the network file " + path_ +
                                " gives an output of 1 x 3 x 120 x 160, expected is one plane of "
                                "labels in the order nchw");
}

TEST_F(NetworkModel, inputsThatTheNetDoesNotTakeAreTold) {
  writeBlueness();
  SilhouetteOptions asked = options();
  asked.network.layout = "nhwc";
  EXPECT_EQ(refusal(asked).rfind(
                "the network file " + path_ + " fails on an input of 1 x 120 x 160 x 3", 0),
            0u)
      << refusal(asked);
}

}  // namespace
}  // namespace markerless_mocap
