#include "markerless_mocap/camera/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include "error_text_of.h"

namespace markerless_mocap {
namespace {

CameraCalibration makeCalibration(std::vector<double> D = {}) {
  CameraCalibration c;
  c.name = "left";
  c.width = 640;
  c.height = 480;
  c.K << 500, 0, 320.5, 0, 510, 241.25, 0, 0, 1;
  c.D = std::move(D);
  return c;
}

/// At (1, 2, 3), looking along the world's x axis with z up.
Eigen::Isometry3d makePose() {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  T.translation() << 1, 2, 3;
  return T;
}

const std::vector<double> kStrongBarrel{-0.37, 0.2, 0.001, -0.002, -0.07};

TEST(Camera, ProjectsAsOpenCV) {
  const std::vector<Eigen::Vector3d> points{
      {0.1, -0.2, 1.5}, {-0.6, 0.4, 2}, {0.9, 0.5, 2.2}, {-1.2, -1.1, 3}};
  // Pixels are those of cv::projectPoints.
  struct {
    std::vector<double> D;
    std::vector<Eigen::Vector2d> pixels;
  } const cases[] = {{{-0.2, 0.05, 0.002, -0.003},
                      {{353.621564, 173.636677},
                       {173.688250, 341.081990},
                       {515.931945, 352.404314},
                       {130.782469, 64.577400}}},
                     {kStrongBarrel,
                      {{353.522526, 173.850047},
                       {176.861068, 338.902373},
                       {509.821549, 348.768010},
                       {138.710596, 71.702380}}},
                     {{0.4, -0.3, 0.001, 0.002, 0.1, 0.5, -0.2, 0.05},
                      {{353.780678, 173.414083},
                       {172.809867, 341.833990},
                       {520.827374, 354.756435},
                       {127.774398, 60.926423}}}};
  for (const auto& c : cases) {
    const Camera camera(makeCalibration(c.D));
    for (size_t i = 0; i < points.size(); ++i)
      EXPECT_LT((camera.project(points[i]).value() - c.pixels[i]).norm(), 1e-5)
          << c.D.size() << " coefficients, point " << i;
  }
}

CameraCalibration makeFisheye(std::vector<double> D) {
  CameraCalibration c = makeCalibration(std::move(D));
  c.K << 300, 0, 320.5, 0, 306, 241.25, 0, 0, 1;
  c.lens = LensType::kFisheye;
  return c;
}

const std::vector<double> kFisheye{-0.03, 0.006, -0.002, 0.0003};

TEST(Camera, FisheyeProjectsAsOpenCV) {
  const Camera camera(makeFisheye(kFisheye));
  // Pixels are those of cv::fisheye::projectPoints.
  const std::pair<Eigen::Vector3d, Eigen::Vector2d> cases[] = {
      {{0.1, -0.2, 1.5}, {340.34080999, 200.77474762}},
      {{-0.6, 0.4, 2}, {234.4246352, 299.78124806}},
      {{3.0, 0.5, 1.2}, {661.67859039, 299.25036037}},
      {{-1.2, -2.1, 0.6}, {131.25014532, -96.56099061}}};
  for (const auto& [point, pixel] : cases)
    EXPECT_LT((camera.project(point).value() - pixel).norm(), 1e-5) << point.transpose();
  EXPECT_EQ(camera.project({0, 0, 2}).value(), Eigen::Vector2d(320.5, 241.25));
}

TEST(Camera, FisheyeSeesBesideAndBehindItself) {
  const Camera camera(makeFisheye({}));  // the angle is the radius
  EXPECT_NEAR(camera.project({1, 0, 0}).value().x(), 320.5 + 300 * M_PI / 2, 1e-9);
  EXPECT_NEAR(camera.project({1, 0, -1}).value().x(), 320.5 + 300 * 3 * M_PI / 4, 1e-9);
  EXPECT_FALSE(camera.project({0, 0, -1}));
  EXPECT_FALSE(camera.project({0, 0, 0}));
  // 1.2 (1 - 0.2 * 1.2^2 ...) stops to grow at 1.29.
  const Camera folded(makeFisheye({-0.2, 0, 0, 0}));
  EXPECT_TRUE(folded.project({std::sin(1.28), 0, std::cos(1.28)}));
  EXPECT_FALSE(folded.project({std::sin(1.30), 0, std::cos(1.30)}));
}

TEST(Camera, FisheyeRayGoesThroughThePointOfItsPixel) {
  CameraCalibration calibration = makeFisheye(kFisheye);
  calibration.K(0, 0) = calibration.K(1, 1) = 180;  // the corners are behind the camera
  calibration.T_world_camera = makePose();
  const Camera camera(calibration);
  double widest = 1;
  for (double u = 0; u < 640; u += 21.3)
    for (double v = 0; v < 480; v += 19.7) {
      const Eigen::Vector3d direction = camera.rayDirection({u, v});
      EXPECT_NEAR(direction.norm(), 1, 1e-12);
      widest = std::min(widest, direction.x());  // the optical axis
      const auto again = camera.project(camera.position() + 3 * direction);
      ASSERT_TRUE(again) << u << ' ' << v;
      EXPECT_LT((*again - Eigen::Vector2d(u, v)).norm(), 1e-6);
    }
  EXPECT_LT(widest, -0.3);
}

TEST(Camera, LocalViewShowsSizesAsTheFisheyeDoes) {
  CameraCalibration calibration = makeFisheye(kFisheye);
  calibration.T_world_camera = makePose();
  const Camera camera(calibration);
  for (const double angle : {0.0, 0.6, 1.3, 1.8}) {
    const Eigen::Vector3d in_camera =
        2.0 * Eigen::Vector3d(0.6 * std::sin(angle), 0.8 * std::sin(angle), std::cos(angle));
    const Eigen::Vector3d point = calibration.T_world_camera * in_camera;
    const LocalView view = camera.localView(point);
    EXPECT_NEAR(view.R_world_view.col(2).dot(point - camera.position()), 2.0, 1e-9);
    // The area of a small square that faces the camera.
    const Eigen::Vector3d right = 1e-4 * view.R_world_view.col(0);
    const Eigen::Vector3d down = 1e-4 * view.R_world_view.col(1);
    const Eigen::Vector2d u = *camera.project(point + right) - *camera.project(point - right);
    const Eigen::Vector2d v = *camera.project(point + down) - *camera.project(point - down);
    const double area = u.x() * v.y() - u.y() * v.x();
    EXPECT_NEAR(area / (1e-8 * view.fx * view.fy), 1.0, 1e-3) << angle;
    EXPECT_NEAR(camera.pixelsPerMetre(in_camera), 0.25 * (view.fx + view.fy), 1e-9) << angle;
  }
}

TEST(Camera, FisheyesOfNoLensAreRefused) {
  CameraCalibration c = makeFisheye({0.1, 0, 0, 0, 0});
  EXPECT_EQ(errorTextOf([&] { c.validate(); }),
            "camera 'left': D has 5 distortion coefficients, allowed are 0 or 4 of a fisheye");
  c = makeFisheye({-40, 0, 0, 0});
  EXPECT_EQ(
      errorTextOf([&] { c.validate(); }).rfind("camera 'left': the distortion D is not of", 0), 0u);
}

TEST(Camera, DistortionsOfNoLensAreRefused) {
  for (const std::vector<double>& D : {std::vector<double>{1e6, -1e9, 0, 0, 1e6},
                                       {1e6, 0, 0, 0},
                                       {-1e6, 0, 0, 0},
                                       {-8, 0, 0, 0},
                                       {0, 0, 1e6, 0},
                                       {0, 0, 0, 0, 0, -40, 0, 0},
                                       {1e300, -1e300, 1e300, 1e300}}) {
    const std::string sentence = errorTextOf([&] { makeCalibration(D).validate(); });
    EXPECT_EQ(sentence.rfind("camera 'left': the distortion D is not of a lens: it can be removed "
                             "in ",
                             0),
              0u)
        << sentence;
    EXPECT_NE(sentence.find("% of the image, allowed are 40 % or more"), std::string::npos);
  }
}

TEST(Camera, DistortionsOfWideLensesThatFoldInTheCornersAreAllowed) {
  CameraCalibration wide = makeCalibration({-0.3, 0, 0, 0});  // folds at 0.7 of the focal length
  EXPECT_NO_THROW(wide.validate());
  wide.D = {0.4, -0.3, 0.001, 0.002, 0.1, 0.5, -0.2, 0.05};
  EXPECT_NO_THROW(wide.validate());
}

TEST(Camera, SizesAndPlacesOfNoCameraAreRefused) {
  CameraCalibration c = makeCalibration();
  c.width = 65537;
  EXPECT_EQ(errorTextOf([&] { c.validate(); }),
            "camera 'left': image size is 65537 x 480, allowed are up to 65536 pixels in a row or "
            "column");
  c = makeCalibration();
  c.K(0, 2) = 1e300;
  EXPECT_EQ(errorTextOf([&] { c.validate(); }),
            "camera 'left': K holds a value above 10 million pixels");
  c = makeCalibration();
  c.T_world_camera.translation().y() = -1e300;
  EXPECT_EQ(errorTextOf([&] { c.validate(); }),
            "camera 'left': the position is farther than 10 km from the origin of the world");
}

TEST(Camera, ViewsOfNoLensAreRefused) {
  const auto refusalOf = [](int row, int column, double value, LensType lens) {
    CameraCalibration c = makeCalibration();
    c.lens = lens;
    c.K(row, column) = value;
    return errorTextOf([&] { c.validate(); });
  };
  const auto poly = LensType::kPolynomial, fisheye = LensType::kFisheye;
  const std::string far = refusalOf(0, 2, 1e6, poly);
  EXPECT_NE(far.find("camera 'left': by K, with the focal lengths "), std::string::npos) << far;
  EXPECT_NE(far.find(" and the principal point 1e+06, "), std::string::npos) << far;
  EXPECT_NE(
      far.find(", a corner of the image is 90 degrees off the axis of the lens, allowed are 80"),
      std::string::npos)
      << far;
  EXPECT_NE(refusalOf(1, 2, -1e4, poly), "");
  EXPECT_NE(refusalOf(0, 0, 1.0, poly), "");
  EXPECT_NE(refusalOf(0, 1, 1e5, poly), "");
  EXPECT_NE(refusalOf(0, 2, 1e4, fisheye).find("allowed are 240"), std::string::npos);
  // Cut out of the corner of a larger image.
  EXPECT_EQ(refusalOf(0, 2, 2.0 * 640, poly), "");
  EXPECT_EQ(refusalOf(0, 2, 2.0 * 640, fisheye), "");
  CameraCalibration tele = makeCalibration();
  tele.K(0, 0) = tele.K(1, 1) = 1e5;
  EXPECT_EQ(errorTextOf([&] { tele.validate(); }), "");
  tele.K(0, 0) = tele.K(1, 1) = 1e6;
  EXPECT_EQ(errorTextOf([&] { tele.validate(); }),
            "camera 'left': the focal lengths in K, 1e+06, 1e+06 pixels, are more than 200 times "
            "the size of the image");
}

TEST(Camera, PoseTakesCameraToWorld) {
  CameraCalibration calibration = makeCalibration();
  calibration.T_world_camera = makePose();
  const Camera camera(calibration);
  // 2 m ahead, 0.4 m to the right (world -y), 0.2 m up.
  const Eigen::Vector2d pixel = camera.project({3, 1.6, 3.2}).value();
  EXPECT_NEAR(pixel.x(), 320.5 + 500 * 0.2, 1e-9);
  EXPECT_NEAR(pixel.y(), 241.25 - 510 * 0.1, 1e-9);
  EXPECT_EQ(camera.position(), Eigen::Vector3d(1, 2, 3));
}

TEST(Camera, NothingBehindIsSeen) {
  const Camera camera(makeCalibration());
  EXPECT_FALSE(camera.project({0, 0, -1}));
  EXPECT_FALSE(camera.project({0.1, 0, 0}));
  EXPECT_FALSE(camera.project({std::nan(""), 0, 1}));
}

TEST(Camera, InsideEndsHalfAPixelBeyondTheOuterCentres) {
  const Camera camera(makeCalibration());
  const auto inside = [&](double u, double v) {
    return camera.projectInside({(u - 320.5) / 500, (v - 241.25) / 510, 1}).has_value();
  };
  EXPECT_TRUE(inside(-0.49, 10));
  EXPECT_FALSE(inside(-0.51, 10));
  EXPECT_TRUE(inside(639.49, 479.49));
  EXPECT_FALSE(inside(639.51, 10));
  EXPECT_FALSE(inside(10, 479.51));
}

TEST(Camera, FoldedBackPointsAreNotSeen) {
  const Camera camera(makeCalibration(kStrongBarrel));
  // r (1 - 0.37 r^2 + 0.2 r^4 - 0.07 r^6) stops to grow at r = 1.204.
  double last = 0, farthest = 0;
  for (double r = 0.01; r < 10; r += 0.01) {
    const auto pixel = camera.project({0, r, 1});
    if (!pixel) break;
    EXPECT_GT(pixel->y(), last) << r;
    last = pixel->y();
    farthest = r;
  }
  EXPECT_GT(farthest, 1.19);
  EXPECT_LT(farthest, 1.21);
  // The bare polynomial would put this point into the image.
  EXPECT_FALSE(camera.projectInside({1.55, 0, 1}));
}

TEST(Camera, UndistortedCameraSeesAlmostSideways) {
  EXPECT_TRUE(Camera(makeCalibration()).project({50, 0, 1}));
}

TEST(Camera, RayGoesThroughThePointOfItsPixel) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(0, 639), v(0, 479);
  for (const std::vector<double>& D :
       {std::vector<double>{}, kStrongBarrel,
        std::vector<double>{0.4, -0.3, 0.001, 0.002, 0.1, 0.5, -0.2, 0.05}}) {
    CameraCalibration calibration = makeCalibration(D);
    calibration.T_world_camera = makePose();
    const Camera camera(calibration);
    for (int i = 0; i < 100; ++i) {
      const Eigen::Vector2d pixel(u(random), v(random));
      const Eigen::Vector3d direction = camera.rayDirection(pixel);
      EXPECT_NEAR(direction.norm(), 1, 1e-12);
      const auto again = camera.project(camera.position() + 3 * direction);
      ASSERT_TRUE(again);
      EXPECT_LT((*again - pixel).norm(), 1e-6);
    }
  }
}

TEST(DecomposeProjection, RecoversIntrinsicsAndPoseFromAnyMultiple) {
  CameraCalibration truth = makeCalibration();
  truth.K(0, 1) = 1.5;
  truth.T_world_camera = makePose() * Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized());
  Eigen::Matrix<double, 3, 4> P = truth.K * truth.T_world_camera.inverse().matrix().topRows<3>();
  for (const double factor : {1.0, -3.7, 1e-4}) {
    const CameraCalibration found = decomposeProjection(factor * P);
    EXPECT_TRUE(found.K.isApprox(truth.K, 1e-9)) << found.K;
    EXPECT_TRUE(found.T_world_camera.isApprox(truth.T_world_camera, 1e-9));
    EXPECT_EQ(found.K(2, 2), 1);
    EXPECT_EQ(found.K(1, 0), 0);
  }
}

TEST(DecomposeProjection, CameraProjectsAsTheMatrix) {
  Eigen::Matrix<double, 3, 4> P;
  P << 700, -300, -30, 900, 120, 110, -760, 2000, 0.74, 0.66, -0.08, 4.6;
  CameraCalibration calibration = decomposeProjection(P);
  calibration.width = calibration.height = 1000;
  const Camera camera(calibration);
  const Eigen::Vector3d point(0.3, -0.4, 1.1);
  const Eigen::Vector3d h = P * point.homogeneous();
  EXPECT_LT((camera.project(point).value() - h.hnormalized()).norm(), 1e-9);
}

TEST(DecomposeProjection, BadMatricesAreRefused) {
  Eigen::Matrix<double, 3, 4> P = Eigen::Matrix<double, 3, 4>::Identity();
  P(2, 2) = 0;
  EXPECT_THROW(decomposeProjection(P), std::invalid_argument);
  P(2, 2) = std::nan("");
  EXPECT_THROW(decomposeProjection(P), std::invalid_argument);
}

/// The sentence that a calibration changed by `spoil` is refused with.
template <class Spoil>
std::string refusal(Spoil spoil) {
  CameraCalibration calibration = makeCalibration();
  spoil(calibration);
  return errorTextOf([&] { Camera camera(calibration); });
}

TEST(CameraCalibration, RefusalsNameCameraAndFault) {
  using C = CameraCalibration;
  EXPECT_EQ(refusal([](C&) {}), "");
  EXPECT_EQ(refusal([](C& c) { c.width = 0; }),
            "camera 'left': image size is 0 x 480, it must be at least 1 x 1");
  EXPECT_EQ(refusal([](C& c) { c.K.setZero(); }),
            "camera 'left': K is all zero, so the camera is not calibrated");
  EXPECT_EQ(refusal([](C& c) { c.K(0, 2) = std::nan(""); }),
            "camera 'left': K holds a value that is not finite");
  EXPECT_EQ(refusal([](C& c) { c.K(1, 1) = -500; }),
            "camera 'left': the focal lengths in K must be positive");
  EXPECT_EQ(refusal([](C& c) {
              c.D = {0, 0, 0};
            }),
            "camera 'left': D has 3 distortion coefficients, allowed are 0, 4, 5 or 8");
  EXPECT_EQ(refusal([](C& c) {
              c.D = {0, 0, 0, std::numeric_limits<double>::infinity()};
            }),
            "camera 'left': D holds a value that is not finite");
  EXPECT_EQ(refusal([](C& c) { c.T_world_camera.linear() *= 1.01; }),
            "camera 'left': the pose is not a rigid transform (rotation and translation)");
  EXPECT_EQ(refusal([](C& c) { c.T_world_camera.linear().col(0) *= -1; }),
            "camera 'left': the pose is not a rigid transform (rotation and translation)");
}

}  // namespace
}  // namespace markerless_mocap
