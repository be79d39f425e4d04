#include <cmath>

#include "capture/cameras/camera_rigs.h"
#include "format_fixture.h"
#include "markerless_mocap/formats/world_transform.h"

namespace markerless_mocap {
namespace {

using Format = CalibrationFormat;

constexpr double kTolerance = 1e-6;  // px and metres

struct Case {
  Format format;
  size_t lens;         ///< coefficients
  const char* output;  ///< file or folder
  bool fisheye = false;
};

std::vector<CameraCalibration> studioRig(size_t lens, bool fisheye = false) {
  std::vector<CameraCalibration> rig;
  for (const Camera& camera : makeRig({"random8", 640, 480, 0.0, 3})) {
    rig.push_back(camera.calibration());
    const double k = 0.01 * double(rig.size());
    const std::vector<double> D = {-0.2 + k, 0.05, 1e-3, -2e-3 + k * 0.1, 0.01, 0.02, 0.01, 0.003};
    rig.back().D.assign(D.begin(), D.begin() + lens);
    if (fisheye) rig.back().lens = LensType::kFisheye;
  }
  return rig;
}

/// Largest distance between the pixels of the same points, which are given in the first world.
double largestPixelDifference(const CameraCalibration& a, const CameraCalibration& b,
                              const Eigen::Isometry3d& T_b_a) {
  const Camera one(a), other(b);
  double largest = 0.0;
  int seen = 0;
  for (const Eigen::Vector3d& point : volumePoints()) {
    const auto p = one.project(point), q = other.project(T_b_a * point);
    EXPECT_EQ(bool(p), bool(q));
    if (!p || !q) continue;
    ++seen;
    largest = std::max(largest, (*p - *q).norm());
  }
  EXPECT_GT(seen, 10) << a.name;
  return largest;
}

class RoundTrip : public FormatTest, public ::testing::WithParamInterface<Case> {};

TEST_P(RoundTrip, TheCamerasComeBack) {
  const std::vector<CameraCalibration> rig = studioRig(GetParam().lens, GetParam().fisheye);
  const auto files = writeCalibration(path(GetParam().output), GetParam().format, rig);
  EXPECT_TRUE(std::filesystem::exists(files.front()));
  const CalibrationSet set = readCalibration({path(GetParam().output)});
  EXPECT_STREQ(nameOf(set.format), nameOf(GetParam().format));
  ASSERT_EQ(set.cameras.size(), rig.size());
  const WorldTransform metres{set.metres_per_unit.value_or(1.0), "z"};
  // A camchain has no world but its first camera.
  const Eigen::Isometry3d T_read_rig = GetParam().format == Format::kKalibr
                                           ? rig[0].T_world_camera.inverse()
                                           : Eigen::Isometry3d::Identity();
  for (size_t i = 0; i < rig.size(); ++i) {
    CameraCalibration read = metres.apply(set.cameras[i]);
    if (GetParam().format != Format::kMatrices) {
      EXPECT_EQ(read.width, 640);
      EXPECT_EQ(read.height, 480);
    }
    read.width = 640;
    read.height = 480;
    EXPECT_EQ(read.name,
              GetParam().format == Format::kCaliscope ? "cam_" + std::to_string(i) : rig[i].name);
    EXPECT_LT(largestPixelDifference(rig[i], read, T_read_rig), kTolerance) << rig[i].name;
    EXPECT_TRUE(read.T_world_camera.isApprox(T_read_rig * rig[i].T_world_camera, kTolerance));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Formats, RoundTrip,
    ::testing::Values(
        Case{Format::kRig, 8, "rig.yaml"}, Case{Format::kRos, 0, "ros"},
        Case{Format::kRos, 5, "ros"}, Case{Format::kRos, 8, "ros"},
        Case{Format::kKalibr, 4, "camchain.yaml"}, Case{Format::kOpenCv, 0, "cv"},
        Case{Format::kOpenCv, 5, "cv"}, Case{Format::kOpenCv, 8, "cv"},
        Case{Format::kMatrices, 0, "matrices"}, Case{Format::kQualisys, 5, "Calib.qca.txt"},
        Case{Format::kAnipose, 5, "calibration.toml"},
        Case{Format::kAnipose, 8, "calibration.toml"},
        Case{Format::kCaliscope, 5, "camera_array.toml"},
        Case{Format::kFreeMoCap, 5, "freemocap.toml"}, Case{Format::kPose2Sim, 4, "Calib.toml"},
        Case{Format::kEasyMocap, 5, "easymocap"}, Case{Format::kColmap, 0, "sparse"},
        Case{Format::kColmap, 4, "sparse"}, Case{Format::kColmap, 8, "sparse"},
        Case{Format::kRig, 4, "rig.yaml", true}, Case{Format::kRos, 4, "ros", true},
        Case{Format::kRos, 0, "ros", true}, Case{Format::kKalibr, 4, "camchain.yaml", true},
        Case{Format::kOpenCv, 4, "cv", true}, Case{Format::kAnipose, 4, "calibration.toml", true},
        Case{Format::kCaliscope, 4, "camera_array.toml", true},
        Case{Format::kFreeMoCap, 4, "freemocap.toml", true},
        Case{Format::kPose2Sim, 4, "Calib.toml", true}, Case{Format::kColmap, 4, "sparse", true}),
    [](const auto& info) {
      return nameOf(info.param.format) + std::string("_") + std::to_string(info.param.lens) +
             (info.param.fisheye ? "_fisheye" : "");
    });

class Writing : public FormatTest {};

TEST_F(Writing, AFisheyeIsRefusedWhereTheFormatHasNone) {
  for (const Format format : {Format::kMatrices, Format::kQualisys, Format::kEasyMocap}) {
    const std::string sentence =
        errorTextOf([&] { writeCalibration(path("out"), format, studioRig(4, true)); });
    EXPECT_NE(sentence.find("camera 'cam0': the lens is a fisheye, this format holds none"),
              std::string::npos)
        << sentence;
  }
}

TEST_F(Writing, ALensThatAFormatCannotHoldIsRefused) {
  const auto refused = [&](Format format, size_t lens) {
    return errorTextOf([&] { writeCalibration(path("out"), format, studioRig(lens)); });
  };
  EXPECT_EQ(refused(Format::kKalibr, 5),
            "Kalibr camchain, camera 'cam0': the lens has 5 distortion coefficients, this format "
            "holds 4");
  EXPECT_EQ(
      refused(Format::kMatrices, 4),
      "3x4 matrices, camera 'cam0': the lens has 1 distortion coefficients, this format holds "
      "0");
  EXPECT_FALSE(std::filesystem::exists(path("out")));
  auto rig = studioRig(0);
  rig[3].K(0, 1) = 0.5;
  EXPECT_EQ(
      errorTextOf([&] { writeCalibration(path("out"), Format::kColmap, rig); }),
      "COLMAP text model, camera 'cam3': the pixels have a skew of 0.5, this format holds none");
}

TEST_F(Writing, NothingIsOverwrittenUnasked) {
  const auto rig = studioRig(0);
  write("cv/cam2.xml", "mine");
  EXPECT_EQ(
      errorTextOf<std::runtime_error>([&] { writeCalibration(path("cv"), Format::kOpenCv, rig); }),
      path("cv/cam2.xml") + " exists and is not overwritten");
  EXPECT_FALSE(std::filesystem::exists(path("cv/cam0.xml")));
  EXPECT_EQ(writeCalibration(path("cv"), Format::kOpenCv, rig, true).size(), rig.size());
  EXPECT_EQ(readCalibration({path("cv")}).cameras.size(), rig.size());
}

}  // namespace
}  // namespace markerless_mocap
