#include "markerless_mocap/hull/hull_carver.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/core.hpp>
#include <random>

#include "hull/hull_scene.h"

namespace markerless_mocap {
namespace {

TEST(HullCarver, SphereHasItsVolume) {
  for (const std::vector<double>& D :
       {std::vector<double>{}, std::vector<double>{-0.37, 0.2, 0.001, -0.002, -0.07}}) {
    const CameraRig rig = makeRig(24, D);
    const VisualHull hull = HullCarver(rig, makeOptions()).carve(renderViews(rig, {Sphere()}));
    ASSERT_EQ(hull.status, HullStatus::kOk) << hull.reason;
    EXPECT_EQ(hull.reason, "");
    const double litres = 4.0 / 3 * M_PI * 4 * 4 * 4;
    EXPECT_NEAR(hull.litres(), litres, 0.05 * litres) << D.size();
    for (const HullVoxel& voxel : hull.voxels)
      ASSERT_LT(hull.lattice.center(voxel.index).norm(), 0.4 + 0.04);
  }
}

/// The definition, voxel by voxel and camera by camera.
std::vector<uint32_t> foregroundByDefinition(const CameraRig& rig, const HullOptions& o,
                                             const std::vector<HullView>& views) {
  std::vector<uint32_t> foreground;
  const VoxelLattice lattice = o.lattice();
  for (uint32_t v = 0; v < lattice.count(); ++v) {
    int seen = 0, votes = 0;
    for (size_t c = 0; c < rig.size(); ++c) {
      if (views[c].mask.empty()) continue;
      const auto pixel = rig[c].projectInside(lattice.center(v));
      if (!pixel) continue;
      ++seen;
      votes +=
          views[c].mask.at<uint8_t>(int(std::lround(pixel->y())), int(std::lround(pixel->x()))) > 0;
    }
    if (seen >= o.min_views && votes >= seen - o.missing_votes_allowed) foreground.push_back(v);
  }
  return foreground;
}

/// Components by growing each from a seed; sorted, the largest (first of equals) first.
std::vector<std::vector<uint32_t>> componentsByGrowing(const VoxelLattice& lattice,
                                                       std::vector<uint32_t> left) {
  std::vector<std::vector<uint32_t>> components;
  while (!left.empty()) {
    std::vector<uint32_t> grown{left.front()};
    left.erase(left.begin());
    for (size_t i = 0; i < grown.size(); ++i) {
      const Eigen::Vector3i a = lattice.coordinates(grown[i]);
      const auto touches = [&](uint32_t v) {
        return (lattice.coordinates(v) - a).cwiseAbs().maxCoeff() <= 1;
      };
      const auto rest =
          std::stable_partition(left.begin(), left.end(), [&](uint32_t v) { return !touches(v); });
      grown.insert(grown.end(), rest, left.end());
      left.erase(rest, left.end());
    }
    std::sort(grown.begin(), grown.end());
    components.push_back(grown);
  }
  std::stable_sort(components.begin(), components.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return components;
}

/// Cameras around and inside of a small volume, with random blots for masks; some are missing.
struct RandomScene {
  CameraRig rig;
  HullOptions options;
  std::vector<HullView> views;

  explicit RandomScene(int seed) {
    std::mt19937 random(seed);
    const auto uniform = [&](double lo, double hi) {
      return std::uniform_real_distribution<double>(lo, hi)(random);
    };
    const auto vector = [&](double size) {
      return Eigen::Vector3d(uniform(-size, size), uniform(-size, size), uniform(-size, size));
    };
    options.volume = "explicit";
    options.volume_min.setConstant(-0.12);
    options.volume_max.setConstant(0.12);
    options.pitch = 0.02;
    options.min_component_litres = 0;
    options.min_views = 2 + seed % 2;
    options.missing_votes_allowed = seed % 3 == 0 ? 1 : 0;
    options.bridging_votes = 0;
    options.leave_out_bad_cameras = false;
    const int cameras = 4 + seed % 5;
    for (int c = 0; c < cameras; ++c) {
      const double distance = c == 0 ? 0.1 : uniform(0.3, 2);
      rig.push_back(makeCamera("c" + std::to_string(c), distance * vector(1).normalized(),
                               vector(0.05), {-0.3, 0.1, 0.001, 0.002}, uniform(100, 600)));
      HullView view;
      if (c != 2) {
        view.mask = cv::Mat(120, 160, CV_8UC1, cv::Scalar(255));
        for (int blot = 0; blot < 20; ++blot)
          view.mask(cv::Rect(int(uniform(0, 120)), int(uniform(0, 80)), 30, 30)).setTo(0);
      }
      views.push_back(view);
    }
  }
};

TEST(HullCarver, AgreesWithItsDefinitionOnRandomRigsAndMasks) {
  size_t voxels = 0, several = 0;
  for (int seed = 0; seed < 30; ++seed) {
    const RandomScene s(seed);
    const VisualHull hull = HullCarver(s.rig, s.options).carve(s.views);
    const auto components =
        componentsByGrowing(hull.lattice, foregroundByDefinition(s.rig, s.options, s.views));
    ASSERT_EQ(hull.components.size(), components.size()) << seed;
    std::vector<double> litres;
    for (const HullComponent& component : hull.components) litres.push_back(component.litres);
    std::sort(litres.rbegin(), litres.rend());
    for (size_t i = 0; i < components.size(); ++i)
      EXPECT_NEAR(litres[i], double(components[i].size()) * 0.008, 1e-9);
    if (components.empty()) {
      EXPECT_TRUE(hull.voxels.empty());
    } else {
      EXPECT_NE(std::find(components.begin(), components.end(), indices(hull)), components.end());
      EXPECT_NEAR(hull.litres(), hull.components[0].litres, 1e-9);
    }
    voxels += hull.voxels.size();
    several += components.size() > 1;
  }
  EXPECT_GT(voxels, 1000u) << "the scenes test nothing";
  EXPECT_GT(several, 3u) << "the scenes test nothing";
}

TEST(HullCarver, CameraThatDoesNotSeeAVoxelHasNoVote) {
  CameraRig rig = makeRig(6);
  const std::vector<HullView> six = renderViews(rig, {Sphere()});
  const std::vector<uint32_t> expected = indices(HullCarver(rig, makeOptions()).carve(six));
  ASSERT_FALSE(expected.empty());
  const Eigen::Vector3d away[] = {{-5, 0, 0},   // the volume lies behind this camera
                                  {-2, 5, 0}};  // and outside the image of this one
  for (const Eigen::Vector3d& target : away) {
    CameraRig seven = rig;
    seven.push_back(makeCamera("idle", {-2, 0, 0}, target));
    std::vector<HullView> views = six;
    views.push_back({cv::Mat::zeros(120, 160, CV_8UC1), {}});
    const VisualHull hull = HullCarver(seven, makeOptions()).carve(views);
    EXPECT_EQ(indices(hull), expected) << target.transpose();
    EXPECT_EQ(hull.voxels[0].views, 6);
  }
}

TEST(HullCarver, MissingCameraIsAsIfItWereNotInTheRig) {
  CameraRig rig = makeRig(6);
  std::vector<HullView> views = renderViews(rig, {Sphere()});
  HullCarver carver(rig, makeOptions());
  views[3] = {};
  const std::vector<uint32_t> without = indices(carver.carve(views));
  rig.erase(rig.begin() + 3);
  views.erase(views.begin() + 3);
  EXPECT_EQ(without, indices(HullCarver(rig, makeOptions()).carve(views)));
}

/// All fields of the voxels, components and cameras.
std::vector<double> everythingOf(const VisualHull& hull) {
  std::vector<double> all;
  for (const HullVoxel& voxel : hull.voxels) {
    all.insert(all.end(), {double(voxel.index), double(voxel.views)});
    all.insert(all.end(), voxel.rgb.begin(), voxel.rgb.end());
    all.insert(all.end(), voxel.color_votes.votes.begin(), voxel.color_votes.votes.end());
    all.insert(all.end(), voxel.color_votes.possible.begin(), voxel.color_votes.possible.end());
  }
  for (const HullComponent& c : hull.components)
    all.insert(all.end(), {c.litres, c.mean_views, double(c.poorly_seen), double(c.suspect_ghost)});
  for (const LeftOutCamera& camera : hull.cameras_left_out) all.push_back(camera.name.back());
  return all;
}

/// Two balls, images of noise, and one camera whose mask is wrong.
std::vector<HullView> troubledViews(const CameraRig& rig) {
  std::vector<HullView> views =
      renderViews(rig, {Sphere{{0.2, 0, 0}, 0.3}, Sphere{{-0.35, 0.2, 0.1}, 0.12}});
  cv::RNG random(3);
  for (HullView& view : views) {
    view.image = cv::Mat(120, 160, CV_8UC3);
    random.fill(view.image, cv::RNG::UNIFORM, 0, 255);
  }
  views[2].mask = 255 - views[2].mask;
  return views;
}

TEST(HullCarver, NothingDependsOnTheNumberOfThreads) {
  const CameraRig rig = makeRig(7);
  const std::vector<HullView> views = troubledViews(rig);
  const auto carved = [&](size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return everythingOf(HullCarver(rig, makeOptions()).carve(views));
  };
  const std::vector<double> one = carved(1);
  ASSERT_GT(one.size(), 1000u);
  EXPECT_EQ(carved(4), one);
}

TEST(HullCarver, DraftThatIsCompletedLateIsTheHullOfItsFrameSet) {
  const CameraRig rig = makeRig(7);
  HullCarver whole(rig, makeOptions()), in_parts(rig, makeOptions());
  std::vector<HullView> moved = troubledViews(rig);
  for (HullView& view : moved) view.image = 255 - view.image;
  const std::vector<double> first = everythingOf(whole.carve(troubledViews(rig)));
  const std::vector<double> second = everythingOf(whole.carve(moved));
  ASSERT_NE(first, second);
  const HullDraft draft = in_parts.draft(troubledViews(rig));
  EXPECT_TRUE(draft.hull.voxels.empty());
  const HullDraft next = in_parts.draft(moved);
  EXPECT_EQ(everythingOf(in_parts.complete(draft)), first);
  EXPECT_EQ(everythingOf(in_parts.complete(next)), second);
}

TEST(HullCarver, NothingDependsOnTheOrderOfCameras) {
  CameraRig rig = makeRig(7);
  std::vector<HullView> views = troubledViews(rig);
  const VisualHull expected = HullCarver(rig, makeOptions()).carve(views);
  ASSERT_EQ(expected.cameras_left_out.size(), 1u);
  std::vector<int> order(rig.size());
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(1);
  for (int trial = 0; trial < 8; ++trial) {
    std::shuffle(order.begin(), order.end(), random);
    CameraRig mixed;
    std::vector<HullView> mixed_views;
    for (const int c : order) {
      mixed.push_back(rig[c]);
      mixed_views.push_back(views[c]);
    }
    EXPECT_EQ(everythingOf(HullCarver(mixed, makeOptions()).carve(mixed_views)),
              everythingOf(expected));
  }
}

TEST(HullCarver, TwoAndThirtyTwoCamerasWork) {
  for (const int cameras : {2, 32}) {
    const CameraRig rig = makeRig(cameras);
    const VisualHull hull = HullCarver(rig, makeOptions()).carve(renderViews(rig, {Sphere()}));
    EXPECT_EQ(hull.status, HullStatus::kOk);
    EXPECT_EQ(hull.voxels[hull.voxels.size() / 2].views, cameras);
  }
}

TEST(HullCarver, MissingVotesAllowedForgivesOneBadMask) {
  const CameraRig rig = makeRig(8);
  std::vector<HullView> views = renderViews(rig, {Sphere()});
  views[5].mask.setTo(0);
  HullOptions options = makeOptions();
  options.leave_out_bad_cameras = false;
  EXPECT_EQ(HullCarver(rig, options).carve(views).status, HullStatus::kNobody);
  options.missing_votes_allowed = 1;
  EXPECT_EQ(HullCarver(rig, options).carve(views).status, HullStatus::kOk);
}

TEST(HullCarver, MaskThatIsARegionOfAnImageIsRead) {
  const CameraRig rig = makeRig(4);
  std::vector<HullView> views = renderViews(rig, {Sphere()});
  HullCarver carver(rig, makeOptions());
  const std::vector<uint32_t> expected = indices(carver.carve(views));
  cv::Mat large(200, 300, CV_8UC1, cv::Scalar(255));
  views[2].mask.copyTo(large(cv::Rect(11, 7, 160, 120)));
  views[2].mask = large(cv::Rect(11, 7, 160, 120));
  EXPECT_EQ(indices(carver.carve(views)), expected);
}

}  // namespace
}  // namespace markerless_mocap
