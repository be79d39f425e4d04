#include "fleischmann/fleischmann_fitness.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <random>

#include "appearance_scene.h"
#include "error_text_of.h"
#include "fleischmann/fitness/edge_map.h"
#include "fleischmann/fitness/edge_samples.h"

namespace markerless_mocap {
namespace {

struct Figure {
  CameraRig rig = ringOfFour();
  FleischmannBodyModel body_model{sampleBody()};
  FleischmannBodyShape body{sampleBody(), body_model};
  FleischmannFitness fitness;

  explicit Figure(const FleischmannImageOptions& options = {})
      : fitness(rig, body_model, body, options) {}

  /// What four cameras see of a grey person before a brighter wall. The person is the model itself:
  /// these tests are about the terms' values, not about how well a pose is found.
  std::vector<FleischmannView> viewsOf(const FleischmannVector& pose) const {
    FleischmannFitness painter(rig, body_model, body, FleischmannImageOptions());
    std::vector<FleischmannView> views;
    for (int i = 0; i < 4; ++i) {
      FleischmannView view;
      view.silhouette = painter.drawing(pose.data(), i);
      view.image = cv::Mat(view.silhouette.size(), CV_8UC1, cv::Scalar(160));
      view.image.setTo(70, view.silhouette);
      views.push_back(view);
    }
    return views;
  }
};

TEST(FleischmannFitness, aPersonWhoLooksLikeTheModelIsSeenAsIs) {
  Figure figure;
  EXPECT_EQ(figure.fitness.observe(figure.viewsOf(stride())), 4);
  const FitnessTerms own = figure.fitness.fitness(stride().data(), EdgeSelection());
  EXPECT_DOUBLE_EQ(own.silhouette, 1.0);
  // Some edges run inside the grey silhouette, where there is nothing to see.
  EXPECT_GT(own.edge, 0.4);
  EXPECT_LE(own.edge, 1.0);
  for (const int d : {3, 4, 5, int(kLeftKnee), int(kRightShoulder)}) {
    FleischmannVector off = stride();
    off[d] += d < 6 ? 0.05 : 0.4;
    const FitnessTerms there = figure.fitness.fitness(off.data(), EdgeSelection());
    EXPECT_LT(there.silhouette, 0.995) << d;
    EXPECT_LT(there.edge, own.edge) << d;
  }
}

// Eq. 5.2 to 5.5 over all pixels, one by one.
TEST(FleischmannFitness, silhouetteTermIsThatOfTheEquations) {
  Figure figure;
  FleischmannVector pose = stride();
  const std::vector<FleischmannView> views = figure.viewsOf(pose);
  figure.fitness.observe(views);
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 5; ++trial) {
    for (int d = 0; d < kFleischmannParameterCount; ++d) pose[d] += 0.05 * normal(random);
    double expected = 0.0;
    for (int i = 0; i < 4; ++i) {
      const cv::Mat drawn = figure.fitness.drawing(pose.data(), i), &seen = views[i].silhouette;
      double R = 0, B = 0, Y = 0;
      for (int y = 0; y < drawn.rows; ++y)
        for (int x = 0; x < drawn.cols; ++x) {
          const bool observed = seen.at<uint8_t>(y, x), model = drawn.at<uint8_t>(y, x);
          R += observed && !model;
          B += model && !observed;
          Y += model && observed;
        }
      expected += 0.5 * Y / (B + Y) + 0.5 * Y / (R + Y);
    }
    EXPECT_DOUBLE_EQ(figure.fitness.fitness(pose.data(), EdgeSelection()).silhouette, expected / 4);
  }
}

TEST(FleischmannFitness, viewsWithoutAPersonDoNotCount) {
  Figure figure;
  std::vector<FleischmannView> views = figure.viewsOf(stride());
  views[1].silhouette.setTo(0);
  views[2] = FleischmannView();
  EXPECT_EQ(figure.fitness.observe(views), 2);
  EXPECT_DOUBLE_EQ(figure.fitness.fitness(stride().data(), EdgeSelection()).silhouette, 1.0);
  for (FleischmannView& view : views) view = FleischmannView();
  EXPECT_EQ(figure.fitness.observe(views), 0);
  const FitnessTerms none = figure.fitness.fitness(stride().data(), EdgeSelection());
  EXPECT_EQ(none.silhouette, 0.0);
  EXPECT_EQ(none.edge, 0.0);
}

// Part of a person and of the wall beside him is unknown. As the person's or as the wall's, these
// pixels would lower the fitness of the true pose.
TEST(FleischmannFitness, unknownPixelsDoNotCount) {
  for (const int downsampling : {1, 2}) {
    FleischmannImageOptions options;
    options.downsampling = downsampling;
    Figure figure(options);
    std::vector<FleischmannView> views = figure.viewsOf(stride());
    figure.fitness.observe(views);
    const double known = figure.fitness.fitness(stride().data(), EdgeSelection()).silhouette;
    for (FleischmannView& view : views) {
      const cv::Rect person = cv::boundingRect(view.silhouette);
      const cv::Rect half(0, 0, view.silhouette.cols, person.y + person.height / 2);
      view.silhouette(half).setTo(128);
      ASSERT_GT(cv::countNonZero(view.silhouette == 128), 2 * person.area() / 2);
    }
    ASSERT_EQ(figure.fitness.observe(views), 4);
    EXPECT_NEAR(figure.fitness.fitness(stride().data(), EdgeSelection()).silhouette, known, 0.01);
    FleischmannVector off = stride();
    off[int(kLeftKnee)] += 0.4;
    EXPECT_LT(figure.fitness.fitness(off.data(), EdgeSelection()).silhouette, known - 0.01);
  }
}

// An arm that is raised sticks out; one that is not in the silhouettes has none of them.
TEST(FleischmannFitness, evidenceTellsWhatSilhouettesShowOfALimb) {
  Figure figure;
  FleischmannVector raised = stride();
  raised[kLeftShoulder] = 1.5;
  const ConeSet arm = coneBit(kLeftUpperArmCone) | coneBit(kLeftLowerArmCone);
  figure.fitness.observe(figure.viewsOf(raised));
  ConeVisibility seen = figure.fitness.evidence(raised.data(), arm);
  EXPECT_EQ(seen.inside, seen.alone);
  EXPECT_GT(double(seen.alone), 0.7 * double(seen.drawn));
  EXPECT_LT(seen.alone, seen.drawn);
  figure.fitness.observe(figure.viewsOf(stride()));
  seen = figure.fitness.evidence(raised.data(), arm);
  EXPECT_LT(double(seen.inside), 0.2 * double(seen.alone));
  figure.fitness.observe(std::vector<FleischmannView>(4));
  EXPECT_EQ(figure.fitness.evidence(raised.data(), arm).drawn, 0);
}

TEST(FleischmannFitness, aBodyOutOfSightIsWorthNothing) {
  Figure figure;
  figure.fitness.observe(figure.viewsOf(stride()));
  for (const double place : {30.0, 1e12, double(NAN)}) {
    FleischmannVector far = stride();
    far[kPelvisPosition] = place;
    const FitnessTerms fitness = figure.fitness.fitness(far.data(), EdgeSelection());
    EXPECT_EQ(fitness.silhouette, 0.0);
    EXPECT_EQ(fitness.edge, 0.0);
  }
}

TEST(FleischmannFitness, silhouettesAloneSufficeWithoutImages) {
  Figure figure;
  std::vector<FleischmannView> views = figure.viewsOf(stride());
  for (FleischmannView& view : views) view.image = cv::Mat();
  EXPECT_EQ(figure.fitness.observe(views), 4);
  const FitnessTerms fitness = figure.fitness.fitness(stride().data(), EdgeSelection());
  EXPECT_DOUBLE_EQ(fitness.silhouette, 1.0);
  EXPECT_EQ(fitness.edge, 0.0);
}

TEST(FleischmannFitness, halfTheResolutionGivesNearlyTheSame) {
  FleischmannImageOptions half;
  half.downsampling = 2;
  Figure whole, small(half);
  const std::vector<FleischmannView> views = whole.viewsOf(stride());
  whole.fitness.observe(views);
  small.fitness.observe(views);
  FleischmannVector off = stride();
  for (const double shift : {0.0, 0.02, 0.1}) {
    off[kPelvisPosition] = stride()[kPelvisPosition] + shift;
    EXPECT_NEAR(small.fitness.fitness(off.data(), EdgeSelection()).silhouette,
                whole.fitness.fitness(off.data(), EdgeSelection()).silhouette, 0.03);
  }
  EXPECT_EQ(small.fitness.drawing(off.data(), 0).size(), cv::Size(322, 242));
}

TEST(FleischmannFitness, sentencesNameTheCameraAndWhatIsWrong) {
  Figure figure;
  std::vector<FleischmannView> views = figure.viewsOf(stride());
  views[0].silhouette = cv::Mat::zeros(10, 10, CV_8UC1);
  EXPECT_EQ(errorTextOf([&] { figure.fitness.observe(views); }),
            "camera 'cam': the silhouette must be mono8 and of the size of the camera's image");
  views.pop_back();
  EXPECT_EQ(errorTextOf([&] { figure.fitness.observe(views); }),
            "3 views were given, the rig has 4 cameras");
}

// Five of ten points of each line lie on a bright half; the torso has a third line.
TEST(EdgeSamples, areTheMeanUnderTheChosenLines) {
  cv::Mat map = cv::Mat::zeros(100, 100, CV_8UC1);
  map(cv::Rect(0, 0, 100, 50)).setTo(200);
  ConeCorners corners{};
  for (const int cone : {int(kTorsoCone), int(kLeftCalfCone), int(kHeadCone)}) {
    corners.seen[cone] = 1;
    const float x[4] = {20, 20, 40, 40}, y[4] = {89.5f, 9.5f, 9.5f, 89.5f};
    for (int k = 0; k < 4; ++k) {
      corners.x[k][cone] = x[k];
      corners.y[k][cone] = y[k];
    }
  }
  const auto sample = [&](ConeSet cones, bool top) {
    return sampleEdges(corners, map, {cones, top}, 10);
  };
  EXPECT_EQ(sample(coneBit(kLeftCalfCone), true).points, 20);
  EXPECT_EQ(sample(coneBit(kLeftCalfCone), true).sum, 10 * 200);
  EXPECT_EQ(sample(kTorsoOnly, true).points, 30);
  EXPECT_EQ(sample(kTorsoOnly, true).sum, 20 * 200);
  EXPECT_EQ(sample(kTorsoOnly, false).sum, 10 * 200);
  EXPECT_EQ(sample(kAllButHead, true).points, 50);
  EXPECT_EQ(sample(0, true).points, 0);
  for (int k = 0; k < 4; ++k) corners.y[k][kLeftCalfCone] -= 50.0f;  // five points leave above
  EXPECT_EQ(sample(coneBit(kLeftCalfCone), true).points, 10);
  EXPECT_EQ(sample(coneBit(kLeftCalfCone), true).sum, 10 * 200);
}

TEST(EdgeMap, isHighestOnTheOutlineAndFadesAway) {
  cv::Mat image(120, 160, CV_8UC1, cv::Scalar(50)), silhouette = cv::Mat::zeros(120, 160, CV_8UC1);
  const cv::Rect box(60, 30, 40, 60);
  image(box).setTo(150);
  silhouette(box).setTo(255);
  image(cv::Rect(5, 5, 10, 10)).setTo(200);  // not the person
  const cv::Mat map = edgeMap(image, silhouette, {60.0, 6, 3.0});
  EXPECT_EQ(map.at<uint8_t>(60, 80), 0);
  EXPECT_EQ(map.at<uint8_t>(10, 5), 0);
  double highest;
  cv::minMaxLoc(map, nullptr, &highest);
  EXPECT_EQ(highest, 255.0);
  EXPECT_GT(map.at<uint8_t>(60, 60), 200);
  EXPECT_GT(map.at<uint8_t>(60, 60), map.at<uint8_t>(60, 56));
  EXPECT_GT(map.at<uint8_t>(60, 56), map.at<uint8_t>(60, 52));
  // Both rows of pixels beside the step are edges, so the blurred profile is that of two lines:
  // exp(-d^2 / 18) at distances d and d + 1.
  const auto body_model = [](double d) {
    return std::exp(-d * d / 18) + std::exp(-(d + 1) * (d + 1) / 18);
  };
  EXPECT_NEAR(map.at<uint8_t>(60, 63) / double(map.at<uint8_t>(60, 60)),
              body_model(3) / body_model(0), 0.02);
  cv::Mat colored;
  cv::cvtColor(image, colored, cv::COLOR_GRAY2BGR);
  EXPECT_EQ(cv::countNonZero(edgeMap(colored, silhouette, {60.0, 6, 3.0}) != map), 0);
}

TEST(EdgeMap, isEmptyWhereNothingStandsOut) {
  const cv::Mat image(60, 80, CV_8UC1, cv::Scalar(90));
  cv::Mat silhouette = cv::Mat::zeros(60, 80, CV_8UC1);
  EXPECT_EQ(cv::countNonZero(edgeMap(image, silhouette, {})), 0);
  silhouette(cv::Rect(20, 20, 10, 10)).setTo(255);
  EXPECT_EQ(cv::countNonZero(edgeMap(image, silhouette, {})), 0);
  EXPECT_EQ(
      errorTextOf([&] { edgeMap(image, cv::Mat(), {}); }),
      "edges need an 8-bit image of one or three channels and a mono8 silhouette of the same size");
}

TEST(FleischmannImageOptions, areCheckedByName) {
  FleischmannImageOptions options;
  options.downsampling = 0;
  EXPECT_NE(errorTextOf([&] { options.validate(); }).find("pose_fitting/fleischmann/downsampling"),
            std::string::npos);
}

// A map that is white only where another cone covers: points that are hidden are not asked.
TEST(EdgeSamples, leaveOutWhatAnotherConeHides) {
  Figure figure;
  const ViewCamera view(figure.rig[0], 1);
  FleischmannFrames frames;
  FleischmannWorldCones cones;
  ConeCorners corners;
  const FleischmannVector pose = stride();
  figure.body_model.frames(pose.data(), frames);
  ConePlacer(figure.body).place(frames, cones);
  view.outlines(cones, corners);
  const HiddenPoints hidden(corners, cones, view.position());
  const EdgeSelection all;
  const cv::Mat white(view.height(), view.width(), CV_8UC1, cv::Scalar(255));
  const EdgeSum every = sampleEdges(corners, white, all, 10);
  const EdgeSum seen = sampleEdges(corners, white, all, 10, &hidden);
  EXPECT_EQ(every.points, (2 * 9 + 1) * 10);
  EXPECT_LT(seen.points, every.points);
  EXPECT_GT(seen.points, every.points / 3);
  EXPECT_EQ(seen.sum, 255 * seen.points);
  // The middle of the torso hides what is behind it, and nothing of what is before it.
  float x = 0, y = 0;
  for (int k = 0; k < 4; ++k) {
    x += corners.x[k][kTorsoCone] / 4;
    y += corners.y[k][kTorsoCone] / 4;
  }
  FleischmannWorldCones far = cones, near = cones;
  for (int axis = 0; axis < 3; ++axis)
    for (ConeVectors* ends : {&far.a, &far.b, &near.a, &near.b}) {
      const bool away = ends == &far.a || ends == &far.b;
      float& place = (*ends)[axis][kLeftCalfCone];
      place = view.position()[axis] + (away ? 2.0f : 0.5f) * (place - view.position()[axis]);
    }
  const EdgeLine point{{x, x}, {y, y}, {0.5f, 0.5f}, 1};
  EXPECT_TRUE(HiddenPoints(corners, far, view.position()).on(point, kLeftCalfCone)[0]);
  EXPECT_FALSE(HiddenPoints(corners, near, view.position()).on(point, kLeftCalfCone)[0]);
  // Of a line across the picture, what lies inside the torso's outline is hidden.
  const EdgeLine across{{0.0f, float(view.width())}, {y, y}, {0.5f, 0.5f}, 200};
  const HiddenPoints::Points covered =
      HiddenPoints(corners, far, view.position()).on(across, kLeftCalfCone);
  std::vector<cv::Point2f> torso;
  for (int k = 0; k < 4; ++k)
    torso.emplace_back(corners.x[k][kTorsoCone], corners.y[k][kTorsoCone]);
  for (int i = 0; i < across.samples; ++i) {
    const cv::Point2f p(across.at(i) * float(view.width()), y);
    if (cv::pointPolygonTest(torso, p, false) > 0) {
      EXPECT_TRUE(covered[size_t(i)]) << i;
    }
  }
  EXPECT_LT(covered.count(), size_t(across.samples / 2));
}

TEST(FleischmannFitness, coveredEdgesCanBeLeftOutAndTheSilhouetteWeighed) {
  FleischmannImageOptions options;
  options.hide_covered_edges = true;
  options.silhouette_weight = 0.0;
  Figure plain, figure(options);
  const std::vector<FleischmannView> views = plain.viewsOf(stride());
  plain.fitness.observe(views);
  figure.fitness.observe(views);
  // Without hidden edges, fewer run where a grey silhouette shows nothing.
  EXPECT_GT(figure.fitness.fitness(stride().data(), EdgeSelection()).edge,
            plain.fitness.fitness(stride().data(), EdgeSelection()).edge);
  FleischmannVector thin = stride();  // an arm before the trunk: all that is drawn is in it
  thin[kLeftShoulder] = 0.0;
  const FitnessTerms weighed = figure.fitness.fitness(thin.data(), EdgeSelection());
  EXPECT_NE(weighed.silhouette, plain.fitness.fitness(thin.data(), EdgeSelection()).silhouette);
  const auto outlines = figure.fitness.outlines(stride().data(), 0);
  ASSERT_EQ(outlines.size(), size_t(kFleischmannConeCount));
  EXPECT_EQ(outlines[kTorsoCone].size(), 4u);
}

}  // namespace
}  // namespace markerless_mocap
