#include "ros/body_markers.h"

#include <gtest/gtest.h>

#include "body/body_fixture.h"

namespace markerless_mocap {
namespace {

using visualization_msgs::Marker;

constexpr size_t kLeftArm = size_t(PartLabel::kArm1);

const BodyModel& person() {
  static const BodyModel model = human();
  return model;
}

BodyPose standing() {
  BodyPose pose;
  pose.status = PoseStatus::kTracked;
  pose.T_world_body.translation() << 0.3, -0.2, 0.9;
  pose.angles = Eigen::VectorXd::Zero(person().angleCount());
  pose.part_seen.fill(true);
  return pose;
}

visualization_msgs::MarkerArray markersOf(const BodyPose& pose) {
  std_msgs::Header header;
  header.frame_id = "world";
  return bodyMarkers(person(), pose, header);
}

Eigen::Vector3d pointOf(const geometry_msgs::Point& p) {
  return {p.x, p.y, p.z};
}

/// Distance of a point to the nearest round cone's surface; negative inside.
double distanceTo(const LinkPoses& T_world_link, const Eigen::Vector3d& p) {
  double nearest = 1e9;
  for (const RoundCone& cone : person().shape()) {
    const Eigen::Vector3d q = T_world_link[size_t(cone.link)].inverse() * p;
    for (int i = 0; i <= 200; ++i) {
      const double t = i / 200.0;
      const double radius = (1 - t) * cone.radius_a + t * cone.radius_b;
      nearest = std::min(nearest, (q - (1 - t) * cone.a - t * cone.b).norm() - radius);
    }
  }
  return nearest;
}

TEST(BodyMarkers, EveryPartHasASurfaceThatIsTheShape) {
  const BodyPose pose = standing();
  LinkPoses T_world_link;
  person().forwardKinematics(pose.T_world_body, pose.angles, T_world_link);
  const auto markers = markersOf(pose).markers;
  ASSERT_EQ(markers.size(), size_t(kPartCount));
  for (const Marker& marker : markers) {
    EXPECT_EQ(marker.header.frame_id, "world");
    EXPECT_EQ(marker.action, Marker::ADD);
    ASSERT_FALSE(marker.points.empty());
    EXPECT_EQ(marker.points.size() % 3, 0u);
    for (size_t i = 0; i < marker.points.size(); i += 37)
      EXPECT_LT(distanceTo(T_world_link, pointOf(marker.points[i])), 0.002);
  }
}

TEST(BodyMarkers, TrianglesShowTheirFrontOutward) {
  // Signed volume by the divergence theorem: positive if all triangles wind outward.
  for (const Marker& marker : markersOf(standing()).markers) {
    double volume = 0.0;
    for (size_t i = 0; i + 2 < marker.points.size(); i += 3)
      volume += pointOf(marker.points[i])
                    .dot(pointOf(marker.points[i + 1]).cross(pointOf(marker.points[i + 2]))) /
                6.0;
    EXPECT_GT(volume, 1e-4);
    EXPECT_LT(volume, 0.1);
  }
}

TEST(BodyMarkers, UnseenPartsAndLostPosesAreDeleted) {
  BodyPose pose = standing();
  pose.part_seen[kLeftArm] = false;
  const auto seen = markersOf(pose).markers;
  for (size_t part = 0; part < size_t(kPartCount); ++part)
    EXPECT_EQ(seen[part].action, part == kLeftArm ? Marker::DELETE : Marker::ADD);
  EXPECT_TRUE(seen[kLeftArm].points.empty());
  for (const Marker& marker : markersOf(BodyPose()).markers)
    EXPECT_EQ(marker.action, Marker::DELETE);
}

TEST(PoseText, SaysInALineHowItStands) {
  BodyPose pose = standing();
  EXPECT_EQ(poseSummary(pose), "tracked");
  pose.silhouette_overlap = 0.934;
  pose.part_sigma_m = {0.005, NAN, 0.2, 0.012, NAN, NAN};
  pose.part_seen[kLeftArm] = false;
  EXPECT_EQ(poseSummary(pose), std::string("tracked, 93 % overlap, error 12 mm\nnot seen: ") +
                                   toString(PartLabel::kArm1));
  BodyPose lost;
  lost.reason = "no hull";
  EXPECT_EQ(poseSummary(lost), "lost: no hull");
}

TEST(PoseText, StandsAboveTheHeadAndStaysThereWhenThePersonIsLost) {
  std::optional<Eigen::Vector3d> head;
  BodyPose lost;
  lost.reason = "a reason that is far too long for a single line of text above the person's head";
  EXPECT_EQ(poseTextMarker(person(), lost, {}, &head).pose.position.x, 0.0);
  const auto at = poseTextMarker(person(), standing(), {}, &head).pose.position;
  EXPECT_NEAR(at.x, 0.3, 0.1);
  EXPECT_GT(at.z, 1.7);
  const auto marker = poseTextMarker(person(), lost, {}, &head);
  EXPECT_EQ(marker.pose.position.z, at.z);
  EXPECT_NE(marker.text.find('\n'), std::string::npos);
}

TEST(BodyMarkers, ColourTellsTheExpectedError) {
  BodyPose pose = standing();
  pose.part_sigma_m = {0.005, 0.2, NAN, NAN, NAN, NAN};
  const auto markers = markersOf(pose).markers;
  EXPECT_GT(markers[0].color.g, markers[0].color.r);
  EXPECT_GT(markers[1].color.r, markers[1].color.g);
  EXPECT_EQ(markers[2].color.r, markers[2].color.g);
}

}  // namespace
}  // namespace markerless_mocap
