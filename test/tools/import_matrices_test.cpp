#include <gtest/gtest.h>
#include <rosbag/view.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <tf2_msgs/TFMessage.h>

#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "tools/common/recording.h"
#include "tools/import/camera_files.h"
#include "tools/import/import_recording.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

class ImportMatrices : public ToolTest {
 protected:
  ImportMatrices() {
    input_.matrices = path("cam%02d.xml");
    input_.images = path("cam%02d_*.png");
    input_.masks = path("silh_cam%02d_*.pbm");
    options_.output = path("out.bag");
    options_.fps = 10.0;
  }

  static Eigen::Matrix<double, 3, 4> projectionOf(const CameraCalibration& camera) {
    const Eigen::Isometry3d T_camera_world = camera.T_world_camera.inverse();
    return camera.K * T_camera_world.matrix().topRows<3>();
  }

  /// Two instants of four cameras, as a tag around twelve numbers; K in pixels.
  void writeRecording() const {
    const auto ring = ringOfFour();
    for (size_t i = 0; i < ring.size(); ++i) {
      std::ostringstream matrix;
      matrix.precision(12);
      matrix << "<?xml version=\"1.0\"?>\n<camera>\n" << projectionOf(ring[i]) << "\n</camera>\n";
      const std::string number = "0" + std::to_string(i);
      writeText("cam" + number + ".xml", matrix.str());
      for (int k = 0; k < 2; ++k) {
        const std::string frame_set = "_000" + std::to_string(k);
        cv::imwrite(path("cam" + number + frame_set + ".png"), smallImage(k == 1));
        cv::imwrite(path("silh_cam" + number + frame_set + ".pbm"), smallMask());
      }
    }
  }

  ImportResult import() const { return importMatrices(input_, options_, nullptr, false); }

  MatricesInput input_;
  ImportOptions options_;
};

TEST_F(ImportMatrices, RecordingComesBackAsItWas) {
  writeRecording();
  EXPECT_EQ(import().frame_sets, 2);
  RecordingOptions reading;
  reading.use_masks = true;
  Recording recording(options_.output, reading);
  const auto ring = ringOfFour();
  ASSERT_EQ(recording.rig().size(), ring.size());
  for (size_t i = 0; i < ring.size(); ++i) {
    const CameraCalibration& read = recording.rig()[i].calibration();
    EXPECT_EQ(read.name, ring[i].name);
    EXPECT_TRUE(read.K.isApprox(ring[i].K, 1e-6)) << read.K;
    EXPECT_TRUE(read.T_world_camera.isApprox(ring[i].T_world_camera, 1e-6));
  }
  std::vector<FrameSet> frame_sets;
  while (auto frame_set = recording.next()) frame_sets.push_back(std::move(*frame_set));
  ASSERT_EQ(frame_sets.size(), 2u);
  EXPECT_EQ(frame_sets[0].stamp_ns, 1000000000);
  EXPECT_EQ(frame_sets[1].stamp_ns, 1100000000);
  EXPECT_EQ(cv::norm(frame_sets[1].frames[2].image, smallImage(true), cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(frame_sets[1].frames[2].mask, smallMask(), cv::NORM_INF), 0.0);
}

TEST_F(ImportMatrices, TopicsAndFramesAreThePackagesOwn) {
  writeRecording();
  import();
  rosbag::Bag bag(options_.output);
  rosbag::View infos(bag, rosbag::TopicQuery("/cam1/camera_info"));
  ASSERT_EQ(infos.size(), 2u);
  const auto info = infos.begin()->instantiate<sensor_msgs::CameraInfo>();
  EXPECT_EQ(info->header.frame_id, "cam1_optical");
  EXPECT_EQ(info->distortion_model, "plumb_bob");
  EXPECT_EQ(info->width, 80u);
  rosbag::View images(bag, rosbag::TopicQuery("/cam1/image_raw"));
  EXPECT_EQ(images.begin()->instantiate<sensor_msgs::Image>()->encoding, "bgr8");
  rosbag::View transforms(bag, rosbag::TopicQuery("/tf_static"));
  ASSERT_EQ(transforms.size(), 1u);
  const auto tf = transforms.begin()->instantiate<tf2_msgs::TFMessage>();
  ASSERT_EQ(tf->transforms.size(), 4u);
  EXPECT_EQ(tf->transforms[1].header.frame_id, "world");
  EXPECT_EQ(tf->transforms[1].child_frame_id, "cam1_optical");
}

TEST_F(ImportMatrices, MillimetresBecomeMetres) {
  writeRecording();
  options_.world.scale_to_metres = 0.001;
  const ImportResult result = import();
  EXPECT_NEAR(result.cameras[0].T_world_camera.translation().z(), 0.001, 1e-6);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_NE(result.warnings[0].find("is the unit right"), std::string::npos);
}

TEST_F(ImportMatrices, MissingImageOfOneCameraIsToldAndLeavesNoBag) {
  writeRecording();
  std::filesystem::remove(path("cam02_0001.png"));
  EXPECT_EQ(errorTextOf<std::exception>([&] { import(); }),
            "cam2 has 1 images or masks, cam0 has 2");
  EXPECT_FALSE(std::filesystem::exists(options_.output));
}

TEST_F(ImportMatrices, ImageOfAnotherSizeLeavesNoBag) {
  writeRecording();
  cv::imwrite(path("cam03_0001.png"), cv::Mat::zeros(20, 20, CV_8UC3));
  EXPECT_EQ(errorTextOf<std::exception>([&] { import(); }),
            "an image or mask of cam3 is 20 x 20 pixels, the first one was 80 x 60");
  EXPECT_FALSE(std::filesystem::exists(options_.output));
  EXPECT_FALSE(hasUnfinished());
}

TEST_F(ImportMatrices, PatternWithoutNumberOrFilesIsTold) {
  input_.matrices = path("cam.xml");
  EXPECT_NE(errorTextOf<std::exception>([&] { import(); }).find("has no %d"), std::string::npos);
  input_.matrices = path("cam%d.xml");
  EXPECT_EQ(errorTextOf<std::exception>([&] { import(); }), "no file matches " + input_.matrices);
}

TEST(WorldTransform, UpAxisGoesToZWithoutMirroring) {
  for (const char* up : {"x", "-x", "y", "-y", "z", "-z"}) {
    const WorldTransform change{1.0, up};
    const Eigen::Matrix3d R = change.rotation();
    const Eigen::Vector3d axis =
        (up[0] == '-' ? -1.0 : 1.0) * Eigen::Vector3d::Unit(std::string(up).back() - 'x');
    EXPECT_TRUE((R * axis).isApprox(Eigen::Vector3d::UnitZ(), 1e-12)) << up;
    EXPECT_NEAR(R.determinant(), 1.0, 1e-12) << up;
  }
  EXPECT_EQ(errorTextOf<std::exception>([] {
              WorldTransform{1.0, "up"}.validate();
            }),
            "up is \"up\", allowed is one of x, -x, y, -y, z, -z");
}

}  // namespace
}  // namespace markerless_mocap
