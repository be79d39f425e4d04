#include <gtest/gtest.h>

#include <stdexcept>

#include "hull/hull_scene.h"

namespace markerless_mocap {
namespace {

VisualHull carve(const std::vector<HullView>& views, const HullOptions& options = makeOptions()) {
  return HullCarver(makeRig(int(views.size())), options).carve(views);
}

void expectUnusable(const VisualHull& hull, HullStatus status, const std::string& reason) {
  EXPECT_EQ(hull.status, status) << toString(hull.status);
  EXPECT_EQ(hull.reason, reason);
  EXPECT_TRUE(hull.voxels.empty());
}

TEST(HullStatus, NoCameras) {
  std::vector<HullView> views(4);
  expectUnusable(carve(views), HullStatus::kNoCameras, "0 of 4 cameras are present, 2 are needed");
  views[1].mask = cv::Mat(120, 160, CV_8UC1, cv::Scalar(255));
  expectUnusable(carve(views), HullStatus::kNoCameras, "1 of 4 cameras are present, 2 are needed");
}

TEST(HullStatus, AllMasksEmpty) {
  expectUnusable(carve(renderViews(makeRig(4), {})), HullStatus::kEmptyMasks,
                 "the masks of all 4 cameras are empty: nobody is there, or somebody has stood "
                 "still since the background was learned and has to move to be seen");
}

TEST(HullStatus, EmptyMasksAreNamedWhereCamerasAreNotLeftOut) {
  std::vector<HullView> views = renderViews(makeRig(4), {Sphere()});
  views[2].mask.setTo(0);
  HullOptions options = makeOptions();
  options.leave_out_bad_cameras = false;
  expectUnusable(carve(views, options), HullStatus::kNobody,
                 "the silhouettes meet nowhere in the volume; the mask of 'cam2' is empty");
}

TEST(HullStatus, FullMaskNamesTheCameras) {
  std::vector<HullView> views = renderViews(makeRig(4), {Sphere()});
  views[0].mask.setTo(255);
  views[3].mask.setTo(255);
  views[3].mask.rowRange(0, 5).setTo(0);
  expectUnusable(
      carve(views), HullStatus::kFullMask,
      "the mask of 'cam0', 'cam3' is full: no person can be separated from the background");
}

TEST(HullStatus, UnknownPixelsMayBePerson) {
  std::vector<HullView> views = renderViews(makeRig(8), {Sphere()});
  const size_t exact = carve(views).voxels.size();
  cv::Mat& mask = views[0].mask;
  mask.setTo(128, mask);
  const VisualHull hull = carve(views);
  EXPECT_EQ(hull.status, HullStatus::kOk) << hull.reason;
  EXPECT_EQ(hull.voxels.size(), exact);
  EXPECT_TRUE(hull.cameras_left_out.empty());
}

TEST(HullStatus, MasksThatAreMostlyUnknownDoNotVote) {
  std::vector<HullView> views = renderViews(makeRig(8), {Sphere()}), without = views;
  for (const size_t c : {1, 4}) {
    cv::Mat& mask = views[c].mask;
    mask(cv::Rect(0, 0, 80, 120)).setTo(128);
    without[c].mask.release();
  }
  const VisualHull hull = carve(views), expected = carve(without);
  ASSERT_EQ(hull.status, HullStatus::kOk) << hull.reason;
  EXPECT_EQ(hull.voxels.size(), expected.voxels.size());
  ASSERT_EQ(hull.cameras_left_out.size(), 2u);
  EXPECT_EQ(hull.cameras_left_out[1].name, "cam4");
  EXPECT_EQ(hull.cameras_left_out[1].reason, "the background of 50 % of its image is not known");
}

TEST(HullStatus, TooFewViewsThatAreKnownAreNoHull) {
  std::vector<HullView> views = renderViews(makeRig(4), {Sphere()});
  for (HullView& view : views) view.mask.rowRange(0, 60).setTo(128);
  const VisualHull hull = carve(views);
  expectUnusable(hull, HullStatus::kNoCameras, "0 of 4 cameras are present, 2 are needed");
  EXPECT_EQ(hull.cameras_left_out.size(), 4u);
}

TEST(HullStatus, SmallComponentIsNobody) {
  HullOptions options = makeOptions();
  options.min_component_litres = 400;
  const VisualHull hull = carve(renderViews(makeRig(12), {Sphere()}), options);
  EXPECT_EQ(hull.status, HullStatus::kNobody);
  EXPECT_NE(hull.reason.find("litres, a body has at least 400.0"), std::string::npos)
      << hull.reason;
  ASSERT_EQ(hull.components.size(), 1u);
}

TEST(HullStatus, TwoBodiesAreToldWithTheirVolumes) {
  const std::vector<HullView> views =
      renderViews(makeRig(16), {Sphere{{-0.3, 0, 0}, 0.25}, Sphere{{0.3, 0, 0}, 0.22}});
  const VisualHull hull = carve(views);
  EXPECT_EQ(hull.status, HullStatus::kSeveralBodies);
  EXPECT_EQ(hull.reason.find("there are several bodies: components of "), 0u) << hull.reason;
  EXPECT_TRUE(hull.voxels.empty());
  EXPECT_GE(hull.components.at(1).litres, 15);
}

/// Three spheres on top of each other, 1.16 m in all.
std::vector<Sphere> columnAt(double x) {
  return {Sphere{{x, 0, -0.38}, 0.2}, Sphere{{x, 0, 0}, 0.2}, Sphere{{x, 0, 0.38}, 0.2}};
}

TEST(HullStatus, TheOnlyUprightBodyIsThePerson) {
  std::vector<Sphere> all = columnAt(-0.3);
  all.push_back(Sphere{{0.3, 0, -0.25}, 0.25});
  const VisualHull hull = carve(renderViews(makeRig(16), all));
  ASSERT_EQ(hull.status, HullStatus::kOk) << hull.reason;
  EXPECT_GT(hull.components.at(1).litres, 15);
  EXPECT_NEAR(hull.components[0].height_m, 1.16, 0.08);
  EXPECT_LT(hull.lattice.center(hull.voxels[0].index).x(), 0.0);
}

TEST(HullStatus, OfTwoUprightBodiesNoneIsChosen) {
  std::vector<Sphere> all = columnAt(-0.3);
  for (const Sphere& sphere : columnAt(0.3)) all.push_back(sphere);
  EXPECT_EQ(carve(renderViews(makeRig(16), all)).status, HullStatus::kSeveralBodies);
}

/// A sphere that is surely a person, and one of which the background is unknown.
std::vector<HullView> viewsOfUnknown(const Sphere& sure, const Sphere& unknown) {
  const CameraRig rig = makeRig(16);
  std::vector<HullView> views = renderViews(rig, {sure});
  for (size_t c = 0; c < rig.size(); ++c) {
    const cv::Mat beside = renderMask(rig[c], {unknown}) & (views[c].mask == 0);
    views[c].mask.setTo(128, beside);
  }
  return views;
}

TEST(HullStatus, UnknownPlacesAreNoSecondBody) {
  const Sphere person{{0.3, 0, 0}, 0.22}, place{{-0.3, 0, 0}, 0.25};
  const VisualHull hull = carve(viewsOfUnknown(person, place));
  ASSERT_EQ(hull.status, HullStatus::kOk) << hull.reason;
  EXPECT_GT(hull.lattice.center(hull.voxels[0].index).x(), 0.0);
  EXPECT_FALSE(hull.components.at(0).unsure);
  EXPECT_TRUE(hull.components.at(1).unsure);
  EXPECT_GT(hull.components[1].litres, hull.components[0].litres);
}

TEST(HullStatus, SmallSureThingsCastNoDoubtOnAnUnknownBody) {
  const Sphere thing{{0.42, 0, 0}, 0.13}, person{{-0.2, 0, 0}, 0.3};
  const VisualHull hull = carve(viewsOfUnknown(thing, person));
  ASSERT_EQ(hull.status, HullStatus::kOk) << hull.reason;
  EXPECT_LT(hull.lattice.center(hull.voxels[0].index).x(), 0.0);
  EXPECT_FALSE(hull.components.at(0).unsure);
}

/// Two balls and a third that joins them, of 12 cameras; two silhouettes have a gap at the third.
TEST(HullStatus, WhoWasThereStaysThePersonWhenAnotherBodyComes) {
  const CameraRig rig = makeRig(16);
  HullCarver carver(rig, makeOptions());
  const Sphere other{{-0.3, 0, 0}, 0.25};
  const VisualHull alone = carver.carve(renderViews(rig, {Sphere{{0.3, 0, 0}, 0.22}}));
  const VisualHull both = carver.carve(renderViews(rig, {other, Sphere{{0.33, 0, 0}, 0.22}}));
  ASSERT_EQ(both.status, HullStatus::kOk) << both.reason;
  EXPECT_NEAR(both.litres(), alone.litres(), 0.1 * alone.litres());
  EXPECT_GE(both.components.size(), 2u);
  // After an empty room nobody is known.
  EXPECT_EQ(carver.carve(renderViews(rig, {})).status, HullStatus::kEmptyMasks);
  EXPECT_EQ(carver.carve(renderViews(rig, {other, Sphere{{0.33, 0, 0}, 0.22}})).status,
            HullStatus::kSeveralBodies);
}

TEST(HullStatus, BodiesThatPartAreBothThePersonSoNoneIs) {
  const CameraRig rig = makeRig(16);
  HullCarver carver(rig, makeOptions());
  EXPECT_EQ(carver.carve(renderViews(rig, {Sphere{{-0.2, 0, 0}, 0.25}, Sphere{{0.2, 0, 0}, 0.25}}))
                .status,
            HullStatus::kOk);
  EXPECT_EQ(carver.carve(renderViews(rig, {Sphere{{-0.3, 0, 0}, 0.22}, Sphere{{0.3, 0, 0}, 0.22}}))
                .status,
            HullStatus::kSeveralBodies);
}

std::vector<HullView> viewsWithAGap(const CameraRig& rig) {
  const std::vector<Sphere> ends = {Sphere{{-0.3, 0, 0}, 0.2}, Sphere{{0.3, 0, 0}, 0.2}};
  std::vector<HullView> views = renderViews(rig, {ends[0], ends[1], Sphere{{0, 0, 0}, 0.2}});
  for (const size_t c : {4, 7}) views[c].mask = renderMask(rig[c], ends);
  return views;
}

TEST(HullBridging, GapInTwoSilhouettesDoesNotCutTheBody) {
  const CameraRig rig = makeRig(12);
  HullOptions options = makeOptions();
  options.bridging_votes = 0;
  const VisualHull cut = HullCarver(rig, options).carve(viewsWithAGap(rig));
  ASSERT_GE(cut.components.size(), 2u);
  options.bridging_votes = 2;
  const VisualHull whole = HullCarver(rig, options).carve(viewsWithAGap(rig));
  EXPECT_EQ(whole.status, HullStatus::kOk);
  EXPECT_EQ(whole.components.size(), 1u);
  const VisualHull truth =
      HullCarver(rig, options)
          .carve(renderViews(
              rig, {Sphere{{-0.3, 0, 0}, 0.2}, Sphere{{0.3, 0, 0}, 0.2}, Sphere{{0, 0, 0}, 0.2}}));
  EXPECT_GT(whole.litres(), cut.components[0].litres + cut.components[1].litres);
  EXPECT_LE(whole.litres(), 1.1 * truth.litres());
}

TEST(HullBridging, BodiesWithNothingBetweenThemStayTwo) {
  const CameraRig rig = makeRig(16);
  HullOptions options = makeOptions();
  options.min_component_litres = 10;
  const VisualHull hull =
      HullCarver(rig, options)
          .carve(renderViews(rig, {Sphere{{-0.35, 0, 0}, 0.18}, Sphere{{0.35, 0, 0}, 0.18}}));
  EXPECT_EQ(hull.status, HullStatus::kSeveralBodies);
}

TEST(HullStatus, BodyWithAThingBesideItIsOneBody) {
  const VisualHull hull =
      carve(renderViews(makeRig(16), {Sphere{{-0.25, 0, 0}, 0.3}, Sphere{{0.35, 0, 0}, 0.12}}));
  ASSERT_EQ(hull.status, HullStatus::kOk) << hull.reason;
  EXPECT_EQ(hull.components.size(), 2u);
  EXPECT_NEAR(hull.litres(), hull.components[0].litres, 1e-9);
}

/// The sentence that building or carving is refused with.
template <class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

TEST(HullRefusals, Rigs) {
  const auto refused = [](const CameraRig& rig, const HullOptions& options = makeOptions()) {
    return refusal([&] { HullCarver(rig, options); });
  };
  EXPECT_EQ(refused({}), "a rig has 0 cameras, allowed are 2 to 32");
  EXPECT_EQ(refused(makeRig(33)), "a rig has 33 cameras, allowed are 2 to 32");
  CameraRig twins = makeRig(3);
  twins[2] = twins[0];
  EXPECT_EQ(refused(twins), "two cameras of the rig are named 'cam0'");
  HullOptions options = makeOptions();
  options.min_views = 5;
  EXPECT_EQ(refused(makeRig(4), options),
            "visual_hull/min_views is 5, allowed is at most the number of cameras, 4");
  options = makeOptions();
  options.volume_min.x() = 50;
  options.volume_max.x() = 51;
  EXPECT_EQ(refused(makeRig(4), options),
            "no voxel of the volume is seen by 2 cameras: check volume_min, volume_max and the "
            "cameras' poses");
}

TEST(HullRefusals, Options) {
  const auto refused = [](auto change) {
    HullOptions options;
    change(options);
    return refusal([&] { options.validate(); });
  };
  EXPECT_EQ(refused([](HullOptions&) {}), "");
  EXPECT_EQ(refused([](HullOptions& o) {
              o = makeOptions();
              o.volume_max.z() = -0.6;
            }),
            "visual_hull/volume_min is not below volume_max along z");
  EXPECT_EQ(refused([](HullOptions& o) { o.missing_votes_allowed = 2; }),
            "visual_hull/missing_votes_allowed is 2, allowed is less than min_views, which is 2");
  EXPECT_EQ(
      refused([](HullOptions& o) {
        o.volume = "explicit";
        o.volume_min.setConstant(-5);
        o.volume_max.setConstant(5);
        o.pitch = 0.02;
      }),
      "visual_hull has 125 million voxels, allowed are 64 million: make the volume smaller or "
      "the pitch larger");
  EXPECT_NE(refused([](HullOptions& o) { o.pitch = 0; }), "");
}

TEST(HullRefusals, Views) {
  HullCarver carver(makeRig(2), makeOptions());
  std::vector<HullView> views = renderViews(makeRig(2), {Sphere()});
  const auto refused = [&](const std::vector<HullView>& v) {
    return refusal([&] { carver.carve(v); });
  };
  EXPECT_EQ(refused({views[0]}), "the hull got 1 views for a rig of 2 cameras");
  std::vector<HullView> bad = views;
  bad[1].mask = cv::Mat::zeros(60, 80, CV_8UC1);
  EXPECT_EQ(refused(bad),
            "mask of camera 'cam1' is 80 x 60 pixels, its calibration says 160 x 120");
  bad[1].mask = cv::Mat::zeros(120, 160, CV_8UC3);
  EXPECT_EQ(refused(bad), "mask of camera 'cam1' must be 8 bit grey");
  bad = views;
  bad[0].image = cv::Mat::zeros(120, 160, CV_32FC1);
  EXPECT_EQ(refused(bad), "image of camera 'cam0' must be 8 bit grey or BGR");
}

// Whoever gives a box means it; whoever leaves it in a file and asks for auto does not.
TEST(HullOptions, TheVolumeIsAutomaticUnlessABoxIsGiven) {
  const auto volumeOf = [](const std::string& yaml) {
    return loadOptions<HullOptions>(YAML::Load(yaml)).volume;
  };
  const std::string box = "volume_min: [-1, -1, 0], volume_max: [1, 1, 2]";
  EXPECT_EQ(volumeOf("{}"), "auto");
  EXPECT_EQ(volumeOf("{" + box + "}"), "explicit");
  EXPECT_EQ(volumeOf("{volume: auto, " + box + "}"), "auto");
  EXPECT_EQ(refusal([&] { volumeOf("{volume: explicit}"); }),
            "visual_hull/volume_min is not below volume_max along x");
}

TEST(HullOptions, LatticeCoversTheVolumeWithoutAnExtraLayer) {
  HullOptions options;
  options.volume_min = {-1.5, -1.5, 0};
  options.volume_max = {1.5, 1.5, 2.2};
  options.pitch = 0.03;
  // 3 / 0.03 is 100 layers; 2.2 / 0.03 is 73.3, so 74.
  EXPECT_EQ(options.lattice().size, Eigen::Vector3i(100, 100, 74));
  EXPECT_EQ(options.lattice().origin, options.volume_min);
}

}  // namespace
}  // namespace markerless_mocap
