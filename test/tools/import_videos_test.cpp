#include <gtest/gtest.h>

#include <Eigen/Core>

#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/videoio.hpp>

#include "markerless_mocap/camera/rig_file.h"
#include "tools/common/recording.h"
#include "tools/import/camera_files.h"
#include "tools/import/import_recording.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

class ImportVideos : public ToolTest {
 protected:
  ImportVideos() {
    input_.folder = folder_.string();
    input_.background = "background.avi";
    input_.background_frames = 2;
    options_.output = path("out.bag");
    options_.world = {0.001, "-z"};
  }

  /// In millimetres with z pointing down, as the ring would be measured in such a world.
  static CameraCalibration measured(CameraCalibration camera) {
    camera.D = {-0.3, 0.1, 0.001, -0.001, 0.02};
    const Eigen::Matrix3d flip = WorldTransform{1.0, "-z"}.rotation().transpose();
    camera.T_world_camera.linear() = flip * camera.T_world_camera.linear();
    camera.T_world_camera.translation() = 1000.0 * (flip * camera.T_world_camera.translation());
    return camera;
  }

  static void writeCalibration(const std::string& file, const CameraCalibration& camera) {
    const Eigen::Isometry3d T_camera_world = camera.T_world_camera.inverse();
    cv::Mat K, R, rotation, t;
    cv::eigen2cv(camera.K, K);
    cv::eigen2cv(Eigen::Matrix3d(T_camera_world.linear()), R);
    cv::eigen2cv(Eigen::Vector3d(T_camera_world.translation()), t);
    cv::Rodrigues(R, rotation);
    cv::FileStorage storage(file, cv::FileStorage::WRITE);
    storage << "CameraMatrix" << K << "DistortionCoeffs" << cv::Mat(camera.D) << "Rotation"
            << rotation << "Translation" << t;
  }

  static void writeVideo(const std::string& file, int frames, bool somebody) {
    cv::VideoWriter video(file, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 20.0, {80, 60});
    for (int k = 0; k < frames; ++k) video.write(smallImage(somebody));
  }

  void writeRecording() const {
    for (const CameraCalibration& camera : ringOfFour()) {
      std::filesystem::create_directories(folder_ / camera.name);
      writeVideo(path(camera.name + "/video.avi"), 3, true);
      writeVideo(path(camera.name + "/background.avi"), 4, false);
      writeCalibration(path(camera.name + "/config.xml"), measured(camera));
    }
  }

  ImportResult import() const { return importVideos(input_, options_, nullptr, false); }

  VideosInput input_;
  ImportOptions options_;
};

TEST_F(ImportVideos, CalibrationComesBackInMetresWithZUp) {
  writeRecording();
  import();
  Recording recording(options_.output, {});
  const auto ring = ringOfFour();
  ASSERT_EQ(recording.rig().size(), ring.size());
  for (size_t i = 0; i < ring.size(); ++i) {
    const CameraCalibration& read = recording.rig()[i].calibration();
    EXPECT_TRUE(read.K.isApprox(ring[i].K, 1e-9));
    EXPECT_EQ(read.D, measured(ring[i]).D);
    EXPECT_TRUE(read.T_world_camera.isApprox(ring[i].T_world_camera, 1e-9));
  }
}

TEST_F(ImportVideos, RigFileStandsForTheCalibrations) {
  writeRecording();
  auto ring = ringOfFour();
  ring[1].K(0, 0) = 71.5;
  writeRig(path("rig.yaml"), ring);
  input_.rig = path("rig.yaml");
  const ImportResult result = import();
  EXPECT_EQ(rigText(result.cameras), rigText(ring));
  ring[2].width = 90;
  writeRig(path("rig.yaml"), ring);
  EXPECT_EQ(errorTextOf<std::exception>([&] { import(); }),
            "the video of cam2 is 80 x 60 pixels, the rig " + input_.rig + " has 90 x 60");
  ring.resize(2);
  writeRig(path("rig.yaml"), ring);
  EXPECT_EQ(errorTextOf<std::exception>([&] { import(); }),
            "camera cam2 is not in the rig " + input_.rig);
}

TEST_F(ImportVideos, BackgroundComesFirstAtTheVideosPace) {
  writeRecording();
  const ImportResult result = import();
  EXPECT_EQ(result.frame_sets, 2 + 3);
  EXPECT_EQ(result.fps, 20.0);
  EXPECT_TRUE(result.warnings.empty());
  Recording recording(options_.output, {});
  std::vector<int64_t> stamps;
  std::vector<bool> somebody;
  while (const auto frame_set = recording.next()) {
    stamps.push_back(frame_set->stamp_ns);
    somebody.push_back(frame_set->frames[0].image.at<cv::Vec3b>(30, 40)[2] > 160);
  }
  EXPECT_EQ(stamps,
            (std::vector<int64_t>{1000000000, 1050000000, 1100000000, 1150000000, 1200000000}));
  EXPECT_EQ(somebody, (std::vector<bool>{false, false, true, true, true}));
}

TEST_F(ImportVideos, JpegIsReadBack) {
  writeRecording();
  options_.jpeg_quality = 90;
  import();
  Recording recording(options_.output, {});
  EXPECT_EQ(recording.cameras()[0].image_topic, "/cam0/image_raw/compressed");
  int images = 0;
  while (const auto frame_set = recording.next()) images += frame_set->frames[3].image.cols == 80;
  EXPECT_EQ(images, 5);
}

TEST_F(ImportVideos, ShorterVideoIsRemarkedOn) {
  writeRecording();
  writeVideo(path("cam2/video.avi"), 2, true);
  const ImportResult result = import();
  EXPECT_EQ(result.frame_sets, 2 + 2);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_EQ(result.warnings[0].substr(0, 34), "the video of cam2 has 2 frames, th");
}

TEST_F(ImportVideos, MissingPiecesAreToldAndLeaveNoBag) {
  EXPECT_EQ(errorTextOf<std::exception>([&] { import(); }),
            "no folder in " + input_.folder + " has a video video.avi");
  writeRecording();
  input_.background_frames = 9;
  EXPECT_EQ(errorTextOf<std::exception>([&] { import(); }),
            "the background video of cam0 ends 5 frames too early: reduce the number of background "
            "frames");
  std::filesystem::remove(path("cam1/config.xml"));
  EXPECT_EQ(errorTextOf<std::exception>([&] { import(); }),
            "cannot read " + path("cam1/config.xml") + ": there is no such file");
  std::filesystem::remove(path("cam1/background.avi"));
  EXPECT_EQ(errorTextOf<std::exception>([&] { import(); }),
            "there is no video " + path("cam1/background.avi"));
  EXPECT_FALSE(std::filesystem::exists(options_.output));
}

}  // namespace
}  // namespace markerless_mocap
