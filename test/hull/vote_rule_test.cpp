#include "hull/voting/vote_rule.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <opencv2/core.hpp>
#include <random>

#include "hull/hull_scene.h"
#include "hull/voting/brick_mask_lookup.h"
#include "hull/voting/mask_packing.h"

namespace markerless_mocap {
namespace {

/// Rig, lattice, masks and rules by chance: cameras around, within and turned away, with and
/// without distortion, near and far; blots for masks; some cameras have none.
struct RandomVote {
  std::mt19937 random;
  CameraRig rig;
  VoxelLattice lattice;
  std::vector<cv::Mat> masks;
  std::vector<TileMask> bits;
  VoteRule rule;

  double uniform(double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  }
  int integer(int lo, int hi) { return std::uniform_int_distribution<int>(lo, hi)(random); }
  Eigen::Vector3d vector(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }

  explicit RandomVote(int seed) : random(uint32_t(seed)) {
    lattice.origin = vector(0.5);
    lattice.pitch = uniform(0.01, 0.06);
    lattice.size = {integer(1, 40), integer(1, 40), integer(1, 40)};
    const Eigen::Vector3d middle = lattice.origin + lattice.pitch * lattice.size.cast<double>() / 2;
    const int cameras = integer(2, seed % 7 == 0 ? 32 : 8);  // most rigs are small
    for (int c = 0; c < cameras; ++c) addCamera(c, middle);
    bits.resize(size_t(cameras));
    const bool plain = seed % 2 == 0;
    for (size_t c = 0; c < masks.size(); ++c) {
      bits[c].pack(masks[c]);
      rule.masks.push_back(integer(0, 7) == 0 ? nullptr : &bits[c]);
      rule.weights.push_back(plain ? 1 : uint32_t(integer(0, int(VoteRule::kMaxWeight))));
    }
    rule.limit = plain ? uint32_t(integer(1, 3)) : uint32_t(integer(1, 50));
    rule.min_views = integer(1, 4);
    rule.window = {Eigen::Vector3i::Zero(), lattice.size};
    if (seed % 3 == 0) {
      rule.window.low = {integer(-9, 9), integer(-9, 9), integer(-9, 9)};
      rule.window.high = {integer(9, 60), integer(9, 60), integer(9, 60)};
    }
  }

  void addCamera(int c, const Eigen::Vector3d& middle) {
    const double distance = integer(0, 4) == 0 ? uniform(0, 0.3) : uniform(0.8, 4);
    const Eigen::Vector3d place = middle + distance * vector(1).normalized();
    const Eigen::Vector3d target = integer(0, 5) == 0 ? place + vector(1) : middle + vector(0.3);
    const std::vector<double> distortion =
        c % 2 == 0 ? std::vector<double>{}
                   : std::vector<double>{uniform(-0.4, 0.2), uniform(0, 0.1), 0.001, -0.002};
    rig.push_back(makeCamera("c" + std::to_string(c), place, target, distortion, uniform(80, 600)));
    cv::Mat mask(120, 160, CV_8UC1, cv::Scalar(integer(0, 3) == 0 ? 0 : 255));
    for (int blot = integer(0, 12); blot > 0; --blot)
      mask(cv::Rect(integer(0, 110), integer(0, 80), integer(1, 50), integer(1, 40)))
          .setTo(integer(0, 1) * 255);
    masks.push_back(mask);
  }

  /// The definition.
  bool isForeground(uint32_t voxel) const {
    const Eigen::Vector3i at = lattice.coordinates(voxel);
    if (!rule.window.contains(at, (at.array() + 1).matrix())) return false;
    int views = 0;
    uint32_t against = 0;
    for (size_t c = 0; c < rig.size(); ++c) {
      if (rule.masks[c] == nullptr) continue;
      const auto pixel = rig[c].projectInside(lattice.center(voxel));
      if (!pixel) continue;
      ++views;
      const int x = int(std::floor(pixel->x() + 0.5)), y = int(std::floor(pixel->y() + 0.5));
      if (masks[c].at<uint8_t>(y, x) == 0) against += rule.weights[c];
    }
    return views >= rule.min_views && against < rule.limit;
  }
};

bool has(const BrickVolume& volume, const Eigen::Vector3i& at) {
  const Eigen::Vector3i brick = at / kBrickSide;
  return volume.word(volume.brickAt(brick.x(), brick.y(), brick.z())) >>
             (at.x() % 4 + 4 * (at.y() % 4) + 16 * (at.z() % 4)) &
         1;
}

TEST(Vote, IsTheLoopOverAllVoxelsAndCameras) {
  size_t standing = 0, fallen = 0;
  for (int seed = 0; seed < 120; ++seed) {
    const RandomVote v(seed);
    const ProjectionTable table(v.rig, v.lattice);
    BrickVolume volume(v.lattice);
    for (int z = 0; z < volume.size().z(); ++z) volume.set(0, 0, z, 5);  // what is there goes
    vote(table, v.rule, &volume);
    size_t counted = 0, wrong = 0;
    for (uint32_t i = 0; i < v.lattice.count(); ++i) {
      const bool expected = v.isForeground(i);
      wrong += has(volume, v.lattice.coordinates(i)) != expected;
      counted += expected;
    }
    ASSERT_EQ(wrong, 0u) << "seed " << seed;
    size_t listed = 0;
    volume.forEachBrick([&](int, int, int, size_t brick) {
      listed += size_t(__builtin_popcountll(volume.word(brick)));
    });
    ASSERT_EQ(listed, counted) << "seed " << seed;
    standing += counted;
    fallen += v.lattice.count() - counted;
  }
  EXPECT_GT(standing, 50000u) << "the votes test nothing";
  EXPECT_GT(fallen, 50000u) << "the votes test nothing";
}

TEST(Vote, DoesNotDependOnTheNumberOfThreads) {
  const RandomVote v(5);
  const ProjectionTable table(v.rig, v.lattice);
  BrickVolume one(v.lattice), many(v.lattice);
  vote(table, v.rule, &many);
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  vote(ProjectionTable(v.rig, v.lattice), v.rule, &one);
  for (size_t brick = 0; brick < one.count(); ++brick) ASSERT_EQ(one.word(brick), many.word(brick));
}

TEST(ProjectionTable, OfEightCamerasAt128KeepsWithin100Megabytes) {
  CameraRig rig;
  for (int c = 0; c < 8; ++c)
    rig.push_back(makeCamera("c" + std::to_string(c),
                             {3 * std::cos(0.785 * c), 3 * std::sin(0.785 * c), 1}, {0, 0, 1}));
  VoxelLattice lattice;
  lattice.origin = {-1, -1, 0};
  lattice.pitch = 2.0 / 128;
  lattice.size = {128, 128, 128};
  const size_t bytes = ProjectionTable(rig, lattice).bytes();
  EXPECT_LT(bytes, 100e6);
  EXPECT_GT(bytes, size_t(lattice.count()) * rig.size()) << "one byte per voxel and camera";
}

TEST(ProjectionTable, SeesNothingBehindTheCameraOrBesideItsImage) {
  VoxelLattice lattice;
  lattice.origin = {-0.2, -0.2, -0.2};
  lattice.pitch = 0.05;
  lattice.size = {8, 8, 8};
  const CameraRig rig = {makeCamera("away", {0, -1, 0}, {0, -5, 0}),
                         makeCamera("beside", {0, -1, 0}, {2, -1, 0}),
                         makeCamera("at", {0, -1, 0}, {0, 5, 0})};
  const ProjectionTable table(rig, lattice);
  for (size_t brick = 0; brick < table.level(0).sees_some.size(); ++brick) {
    EXPECT_EQ(table.level(0).sees_some[brick], 4u);
    EXPECT_EQ(table.seen(brick, 0), 0u);
    EXPECT_EQ(table.seen(brick, 1), 0u);
    EXPECT_EQ(table.seen(brick, 2), kAllVoxels);
  }
}

/// Noise of any size, not only whole tiles.
cv::Mat noise(int width, int height, uint32_t seed) {
  std::mt19937 random(seed);
  cv::Mat mask(height, width, CV_8UC1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      mask.at<uint8_t>(y, x) = random() % 3 == 0 ? uint8_t(random()) : 0;
  return mask;
}

TEST(TileMask, HoldsEveryPixelAndCountsTiles) {
  for (const cv::Size size : {cv::Size(640, 480), cv::Size(161, 121), cv::Size(40, 8),
                              cv::Size(7, 3), cv::Size(99, 64)}) {
    cv::Mat mask = noise(size.width, size.height, 7);
    mask(cv::Rect(0, 0, (size.width + 1) / 2, (size.height + 1) / 2)).setTo(1);
    mask(cv::Rect(size.width / 2, size.height / 2, (size.width + 1) / 2, (size.height + 1) / 2))
        .setTo(9);
    TileMask bits;
    bits.pack(mask);
    EXPECT_EQ(int(bits.setPixels()), cv::countNonZero(mask));
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) ASSERT_EQ(bits.at(x, y), mask.at<uint8_t>(y, x) != 0);
    const int columns = (size.width + 7) / 8, rows = (size.height + 7) / 8;
    const TileBox box{uint16_t(columns / 3), uint16_t(rows / 3), uint16_t(columns), uint16_t(rows)};
    uint32_t any = 0, all = 0;
    for (int row = box.y0; row < box.y1; ++row)
      for (int column = box.x0; column < box.x1; ++column) {
        const cv::Mat tile =
            mask(cv::Rect(0, 0, size.width, size.height) & cv::Rect(8 * column, 8 * row, 8, 8));
        any += cv::countNonZero(tile) > 0;
        all += cv::countNonZero(tile) == int(tile.total());
      }
    EXPECT_EQ(bits.count(box).any, any);
    EXPECT_EQ(bits.count(box).all, all);
  }
}

TEST(TileMask, VectorsPackAsTheLoop) {
  const cv::Mat mask = noise(203, 8, 3);
  std::vector<uint64_t> fast(26), plain(26);
  packTileRow(mask.data, mask.step, mask.cols, 8, fast.data(), 1);
  packTileRowPlainly(mask.data, mask.step, mask.cols, 8, plain.data(), 1);
  EXPECT_EQ(fast, plain);
}

TEST(LeafTest, VectorsTestAsTheLoop) {
  TileMask bits;
  bits.pack(noise(160, 120, 11));
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    uint8_t codes[64];
    for (uint8_t& code : codes) code = uint8_t(random());
    const uint64_t in_first = uint64_t(random()) << 32 | random();
    const PixelWindow windows[] = {{in_first, uint16_t(random() % 160), uint16_t(random() % 120)},
                                   {~in_first, uint16_t(random() % 160), uint16_t(random() % 120)}};
    ASSERT_EQ(setInWindows(bits, windows, windows + 2, codes),
              setInWindowsPlainly(bits, windows, windows + 2, codes));
  }
}

}  // namespace
}  // namespace markerless_mocap
