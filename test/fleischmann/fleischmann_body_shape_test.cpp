#include "fleischmann/model/fleischmann_body_shape.h"

#include <gtest/gtest.h>

#include "appearance_scene.h"
#include "error_text_of.h"
#include "fleischmann/fitness/fleischmann_cone_outlines.h"

namespace markerless_mocap {
namespace {

struct Figure {
  FleischmannBodyModel body_model{sampleBody()};
  FleischmannBodyShape body{sampleBody(), body_model};
};

TEST(FleischmannBodyShape, conesAreWhereTheirLimbsAre) {
  const Figure figure;
  const auto& cones = figure.body.cones();
  const BodyProportions p = BodyProportions::fromStature(1.75);
  EXPECT_NEAR((cones[kLeftThighCone].b - cones[kLeftThighCone].a).norm(), p.thigh, 1e-6);
  EXPECT_NEAR((cones[kRightCalfCone].b - cones[kRightCalfCone].a).norm(), 1.2 * p.shank, 1e-6);
  EXPECT_NEAR((cones[kLeftLowerArmCone].b - cones[kLeftLowerArmCone].a).norm(), 1.2 * p.forearm,
              1e-6);
  for (const FleischmannCone& cone : cones) {
    EXPECT_NEAR(cone.u.dot(cone.b - cone.a), 0.0, 1e-9);
    EXPECT_NEAR(cone.v.dot(cone.b - cone.a), 0.0, 1e-9);
    EXPECT_NEAR(cone.u.dot(cone.v), 0.0, 1e-9);
    EXPECT_GT(cone.taper, 0.5);
    EXPECT_LT(cone.taper, 1.5);
  }
  const FleischmannCone& torso = cones[kTorsoCone];
  EXPECT_GT(torso.v.norm(), 1.3 * torso.u.norm());  // wider than deep
  EXPECT_NEAR(cones[kLeftThighCone].u.norm(), cones[kLeftThighCone].v.norm(), 1e-6);
  EXPECT_LT(cones[kLeftCalfCone].taper, 1.0);
}

TEST(FleischmannBodyShape, resizesEachConeByItself) {
  const Figure figure;
  std::array<FleischmannConeScale, kFleischmannConeCount> sizes;
  sizes[kTorsoCone] = {1.1, 0.9, 1.2};
  const FleischmannBodyShape body = figure.body.scaled(sizes);
  const FleischmannCone &before = figure.body.cones()[kTorsoCone],
                        &after = body.cones()[kTorsoCone];
  EXPECT_NEAR(after.v.norm(), 1.1 * before.v.norm(), 1e-12);
  EXPECT_NEAR(after.u.norm(), 0.9 * before.u.norm(), 1e-12);
  EXPECT_NEAR(after.taper, 1.2 * before.taper, 1e-12);
  EXPECT_EQ(body.cones()[kHeadCone].u, figure.body.cones()[kHeadCone].u);
  sizes[kHeadCone].width = 0.0;
  EXPECT_EQ(errorTextOf([&] { figure.body.scaled(sizes); }),
            "scale factors of cone 9 must be greater than 0");
}

// Every point of a cone's surface projects to the inner side of the two lines, and some to each
// line: they are its contour.
TEST(ConeOutlines, linesTouchTheProjectedSurface) {
  const Figure figure;
  const Camera camera = ringCamera(0.7);
  const ViewCamera view(camera, 1);
  FleischmannFrames frames;
  figure.body_model.frames(stride().data(), frames);
  FleischmannWorldCones cones;
  ConePlacer(figure.body).place(frames, cones);
  ConeCorners corners;
  view.outlines(cones, corners);
  for (int i = 0; i < kFleischmannConeCount; ++i) {
    ASSERT_TRUE(corners.seen[i]) << i;
    const FleischmannCone& cone = figure.body.cones()[i];
    const auto corner = [&](int k) { return Eigen::Vector2d(corners.x[k][i], corners.y[k][i]); };
    const Eigen::Vector2d from[2] = {corner(0), corner(3)}, to[2] = {corner(1), corner(2)};
    for (int side = 0; side < 2; ++side) {
      const Eigen::Vector2d along = (to[side] - from[side]).normalized();
      const Eigen::Vector2d normal(-along.y(), along.x());
      const double inward = normal.dot(from[1 - side] - from[side]) > 0 ? 1.0 : -1.0;
      double least = HUGE_VAL;
      for (int a = 0; a < 720; ++a)
        for (int h = 0; h <= 4; ++h) {
          const double t = a * M_PI / 360, scale = 1 + h / 4.0 * (cone.taper - 1);
          const Eigen::Vector3d local = cone.a + h / 4.0 * (cone.b - cone.a) +
                                        scale * (std::cos(t) * cone.u + std::sin(t) * cone.v);
          const auto pixel =
              camera.project(frames.p[cone.segment] + frames.R[cone.segment] * local);
          ASSERT_TRUE(pixel);
          least = std::min(least, inward * normal.dot(*pixel - from[side]));
        }
      EXPECT_NEAR(least, 0.0, 0.01) << "cone " << i << " side " << side;
    }
  }
}

TEST(ConeOutlines, cornersGoThroughTheFullLensModel) {
  const Figure figure;
  const std::vector<double> D = {-0.2, 0.05, 0.002, -0.001, 0.01};
  const Camera plain = ringCamera(0.7), lens = ringCamera(0.7, 644, 484, D);
  FleischmannFrames frames;
  figure.body_model.frames(stride().data(), frames);
  FleischmannWorldCones cones;
  ConePlacer(figure.body).place(frames, cones);
  ConeCorners straight, bent;
  ViewCamera(plain, 1).outlines(cones, straight);
  ViewCamera(lens, 1).outlines(cones, bent);
  for (int i = 0; i < kFleischmannConeCount; ++i)
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector3d ray = plain.rayDirection({straight.x[k][i], straight.y[k][i]});
      const auto pixel = lens.project(lens.position() + 3.0 * ray);
      ASSERT_TRUE(pixel);
      EXPECT_NEAR(pixel->x(), bent.x[k][i], 0.01);
      EXPECT_NEAR(pixel->y(), bent.y[k][i], 0.01);
    }
}

TEST(ConeOutlines, halfAnImageHasItsPixelCentresBetweenThoseOfTheWhole) {
  const Figure figure;
  const Camera camera = ringCamera(0.7);
  FleischmannFrames frames;
  figure.body_model.frames(stride().data(), frames);
  FleischmannWorldCones cones;
  ConePlacer(figure.body).place(frames, cones);
  ConeCorners whole, half;
  ViewCamera(camera, 1).outlines(cones, whole);
  ViewCamera(camera, 2).outlines(cones, half);
  EXPECT_NEAR(half.x[0][0], (whole.x[0][0] - 0.5) / 2, 1e-3);
  EXPECT_NEAR(half.y[0][0], (whole.y[0][0] - 0.5) / 2, 1e-3);
  EXPECT_EQ(ViewCamera(camera, 2).width(), 322);
  EXPECT_EQ(errorTextOf([&] { ViewCamera(camera, 1000); }),
            "camera 'cam': an image of 644 x 484 cannot be downsampled by 1000");
}

TEST(ConeOutlines, whatIsBehindOrSeenAlongItsAxisHasNone) {
  const Figure figure;
  FleischmannFrames frames;
  FleischmannVector v = stride();
  v.segment<3>(kPelvisPosition) << 8.0, 8.0, 0.9;  // behind the camera
  figure.body_model.frames(v.data(), frames);
  FleischmannWorldCones cones;
  ConePlacer(figure.body).place(frames, cones);
  ConeCorners corners;
  ViewCamera(ringCamera(M_PI / 4), 1).outlines(cones, corners);
  for (int i = 0; i < kFleischmannConeCount; ++i) EXPECT_FALSE(corners.seen[i]);
  // From straight above, the cones of an upright body hide their own sides or show them whole.
  CameraCalibration above = ringCamera(0).calibration();
  above.T_world_camera.linear() << 0, -1, 0, -1, 0, 0, 0, 0, -1;
  above.T_world_camera.translation() << 0, 0, 5;
  figure.body_model.frames(FleischmannVector::Zero().eval().data(), frames);
  ConePlacer(figure.body).place(frames, cones);
  ViewCamera(Camera(above), 1).outlines(cones, corners);
  EXPECT_FALSE(corners.seen[kHeadCone]);
}

TEST(LimbCollision, findsCrossedLegsAndLetsWalkingPass) {
  const Figure figure;
  FleischmannBodyOptions half;
  half.collision_fraction = 0.5;
  const LimbCollision collide(figure.body, half);
  const auto collides = [&](const FleischmannVector& v) {
    FleischmannFrames frames;
    figure.body_model.frames(v.data(), frames);
    return collide(frames);
  };
  EXPECT_FALSE(collides(FleischmannVector::Zero()));
  EXPECT_FALSE(collides(stride()));
  FleischmannVector crossed = FleischmannVector::Zero();
  crossed[kLeftHip] = -0.25;
  crossed[kRightHip] = -0.25;
  EXPECT_TRUE(collides(crossed));
  FleischmannVector arm = FleischmannVector::Zero();
  arm[kLeftShoulder + 2] = -1.5;  // twisted inwards, bent into the belly
  arm[kLeftElbow] = 1.5;
  EXPECT_TRUE(collides(arm));
  FleischmannFrames frames;
  figure.body_model.frames(crossed.data(), frames);
  half.collision_fraction = 0.0;
  EXPECT_FALSE(LimbCollision(figure.body, half)(frames));
}

TEST(LimbCollision, ofAllPairsFindsWhatTheLimbsOfWalkersDoNot) {
  const Figure figure;
  FleischmannBodyOptions walking, all;
  all.collision_pairs = "all";
  const auto collides = [&](const FleischmannBodyOptions& options, const FleischmannVector& v) {
    FleischmannFrames frames;
    figure.body_model.frames(v.data(), frames);
    return LimbCollision(figure.body, options)(frames);
  };
  FleischmannVector apart = FleischmannVector::Zero();  // the arms do not touch the thighs
  apart[kLeftShoulder] = apart[kRightShoulder] = 0.3;
  EXPECT_FALSE(collides(all, apart));
  EXPECT_FALSE(collides(all, stride()));
  FleischmannVector raised = apart;  // the upper arm through the head
  raised[kLeftShoulder] = 3.1;
  raised[kLeftClavicle + 1] = 0.8;
  raised[kHeadTurn] = -0.8;
  raised[kSpine + 1] = 0.7;
  FleischmannVector crouched = apart;  // a forearm through the calf
  crouched[kLeftHip + 1] = 1.9;
  crouched[kLeftKnee] = 1.9;
  crouched[kSpine] = 1.0;
  crouched[kLeftShoulder] = 0.0;
  crouched[kLeftShoulder + 1] = 0.35;
  EXPECT_TRUE(collides(all, raised));
  EXPECT_TRUE(collides(all, crouched));
  // Legs that are crossed behind each other meet first at the thighs.
  bool thighs_alone = false;
  for (double angle = 0.0; angle > -0.4; angle -= 0.01) {
    FleischmannVector crossed = apart;
    crossed[kLeftHip] = crossed[kRightHip] = angle;
    crossed[kLeftHip + 1] = 0.15;
    crossed[kLeftKnee] = crossed[kRightKnee] = 0.4;
    thighs_alone = thighs_alone || (collides(all, crossed) && !collides(walking, crossed));
  }
  EXPECT_TRUE(thighs_alone);
}

// Fleischmann 2012, 5.1.2.
TEST(FleischmannBodyShape, thighsCanBeThickerAndLowerLimbsLonger) {
  const Figure figure;
  FleischmannBodyOptions shorts;
  shorts.thigh_width = 1.2;
  shorts.lower_limb_length = 1.0;
  const FleischmannBodyShape changed(sampleBody(), figure.body_model, shorts);
  for (int i = 0; i < kFleischmannConeCount; ++i) {
    const FleischmannCone &a = figure.body.cones()[i], &b = changed.cones()[i];
    const bool thigh = i == kLeftThighCone || i == kRightThighCone;
    const bool lower = i == kLeftCalfCone || i == kRightCalfCone || i == kLeftLowerArmCone ||
                       i == kRightLowerArmCone;
    EXPECT_NEAR(b.u.norm() / a.u.norm(), thigh ? 1.2 : 1.0, 1e-9) << i;
    EXPECT_NEAR((a.b - a.a).norm() / (b.b - b.a).norm(), lower ? 1.2 : 1.0, 1e-9) << i;
  }
}

}  // namespace
}  // namespace markerless_mocap
