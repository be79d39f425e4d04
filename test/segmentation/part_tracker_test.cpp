#include "markerless_mocap/segmentation/part_tracker.h"

#include <gtest/gtest.h>

#include "markerless_mocap/segmentation/body_segmenter.h"
#include "voxel_figure.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kMs = 1'000'000;  // ns
constexpr double kFree = 0.1;       // radians from hanging
constexpr double kTouching = 0.05;

/// A person filmed frame by frame.
class Film {
 public:
  BodyParts add(const VisualHull& hull, int64_t ms_later = 33) {
    stamp_ += ms_later * kMs;
    return segmenter_.segment(hull, stamp_, &memory_);
  }
  BodyParts alone(const VisualHull& hull) const { return segmenter_.segment(hull); }

 private:
  BodySegmenter segmenter_{SegmentationOptions()};
  PartTracker memory_;
  int64_t stamp_ = 1000 * kMs;
};

/// The fraction of a true arm's voxels, or of a true trunk's, that have a label.
double fractionLabelled(const VoxelFigure& figure, PartLabel part, const BodyParts& parts,
                        PartLabel label) {
  const std::vector<PartLabel> truth = figure.parts();
  double all = 0.0, labelled = 0.0;
  for (size_t v = 0; v < truth.size(); ++v) {
    if (truth[v] != part) continue;
    ++all;
    labelled += parts.labels[v] == uint8_t(label);
  }
  return labelled / all;
}

/// The right hand (x > 0) behind at one height, the left one in front at another: which of them is
/// farther along the direction that arms are numbered by is up to the heights.
VoxelFigure handsAt(double right, double left) {
  VoxelFigure figure;
  figure.capsule({0.28, 0, 1.35}, {0.3, -0.5, right}, 0.04, PartLabel::kArm1);
  figure.capsule({-0.28, 0, 1.35}, {-0.3, 0.5, left}, 0.04, PartLabel::kArm2);
  paintTrunkAndLegs(&figure);
  return figure;
}

TEST(PartTracker, KeepsTheNumbersOfArmsThatRiseAboveEachOther) {
  Film film;
  const VoxelFigure before = handsAt(1.25, 1.17), after = handsAt(1.17, 1.25);
  const BodyParts first = film.add(before.hull());
  ASSERT_EQ(first.status, SegmentationStatus::kOk) << first.reason;
  ASSERT_GT(fractionLabelled(before, PartLabel::kArm1, first, PartLabel::kArm1), 0.7);
  EXPECT_GT(fractionLabelled(after, PartLabel::kArm1, film.alone(after.hull()), PartLabel::kArm2),
            0.7)
      << "without a memory the higher one is the first";
  const BodyParts second = film.add(after.hull());
  EXPECT_GT(fractionLabelled(after, PartLabel::kArm1, second, PartLabel::kArm1), 0.7);
  const PartCurve& curve = second.part(PartLabel::kArm1);
  ASSERT_TRUE(curve.seen);
  EXPECT_LT(curve.points.back().y(), -0.3) << "curves are numbered as labels are";
}

TEST(PartTracker, CarriesArmsOverThatTouchTheBody) {
  Film film;
  const VoxelFigure touching = standingFigure(kTouching);
  const BodyParts before = film.add(standingFigure(kFree).hull());
  ASSERT_EQ(before.status, SegmentationStatus::kOk) << before.reason;
  EXPECT_FALSE(before.part(PartLabel::kArm1).carried);
  const BodyParts parts = film.add(touching.hull());
  EXPECT_GT(fractionLabelled(touching, PartLabel::kArm1, parts, PartLabel::kArm1), 0.7);
  EXPECT_GT(fractionLabelled(touching, PartLabel::kArm2, parts, PartLabel::kArm2), 0.7);
  EXPECT_GT(fractionLabelled(touching, PartLabel::kTorso, parts, PartLabel::kTorso), 0.8);
  EXPECT_TRUE(parts.part(PartLabel::kArm1).carried);
  EXPECT_FALSE(parts.part(PartLabel::kLeg1).carried);
}

TEST(PartTracker, LeavesStatusAndCurvesToTheFrameAlone) {
  Film film;
  film.add(standingFigure(kFree).hull());
  const VisualHull touching = standingFigure(kTouching).hull();
  const BodyParts parts = film.add(touching);
  EXPECT_EQ(parts.status, film.alone(touching).status);
  EXPECT_FALSE(parts.part(PartLabel::kArm1).seen);
  EXPECT_EQ(parts.reason,
            film.alone(touching).reason + "; arm 1, arm 2 carried over from the frames before");
}

TEST(PartTracker, MovesAlongWithThePerson) {
  Film film;
  film.add(standingFigure(kFree).hull());
  const VoxelFigure touching = standingFigure(kTouching);
  VisualHull away = touching.hull();
  away.lattice.origin += Eigen::Vector3d(0.31, -0.2, 0.05);
  const BodyParts parts = film.add(away);
  EXPECT_GT(fractionLabelled(touching, PartLabel::kArm1, parts, PartLabel::kArm1), 0.7);
}

TEST(PartTracker, ForgetsLimbsThatStayUnseen) {
  Film film;
  film.add(standingFigure(kFree).hull());
  const VisualHull touching = standingFigure(kTouching).hull();
  for (int64_t unseen = 70; unseen <= 350; unseen += 70)
    EXPECT_TRUE(film.add(touching, 70).part(PartLabel::kArm1).carried) << unseen;
  EXPECT_FALSE(film.add(touching, 70).part(PartLabel::kArm1).carried);
}

TEST(PartTracker, ForgetsAllAfterAGapAndWhenStampsGoBack) {
  for (const int64_t later : {300, 0, -33}) {
    Film film;
    film.add(standingFigure(kFree).hull());
    const VisualHull touching = standingFigure(kTouching).hull();
    const BodyParts parts = film.add(touching, later);
    EXPECT_FALSE(parts.part(PartLabel::kArm1).carried) << later;
    EXPECT_EQ(parts.labels, film.alone(touching).labels) << later;
  }
}

TEST(PartTracker, KnowsNothingOfLimbsItHasNeverSeen) {
  Film film;
  const VisualHull touching = standingFigure(kTouching).hull();
  for (int frame = 0; frame < 2; ++frame)
    EXPECT_EQ(film.add(touching).labels, film.alone(touching).labels);
}

}  // namespace
}  // namespace markerless_mocap
