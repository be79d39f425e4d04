#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "error_text_of.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// A folder of its own for each test, removed afterwards.
class ToolTest : public ::testing::Test {
 protected:
  ToolTest() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              (std::string("mocap_") + info->test_suite_name() + "_" + info->name() + "_" +
               std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  ~ToolTest() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void writeText(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(path(name)) << text;
  }
  std::string bytesOf(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }
  /// The first half of a file, as a full disk leaves it.
  void cutInHalf(const std::string& name) const {
    std::filesystem::resize_file(folder_ / name, std::filesystem::file_size(folder_ / name) / 2);
  }

  /// Whether a file is left that a writer had not completed.
  bool hasUnfinished() const {
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      if (entry.path().extension() == ".active") return true;
    return false;
  }

  std::filesystem::path folder_;
};

/// Four cameras of 80 x 60 pixels on a ring of 3 m at 1 m height that look at its middle.
inline std::vector<CameraCalibration> ringOfFour() {
  std::vector<CameraCalibration> ring;
  for (int i = 0; i < 4; ++i) {
    const double angle = M_PI_2 * i + 0.3;
    CameraCalibration camera;
    camera.name = "cam" + std::to_string(i);
    camera.width = 80;
    camera.height = 60;
    camera.K << 70, 0, 39.5, 0, 72, 29.5, 0, 0, 1;
    const Eigen::Vector3d forward(-std::cos(angle), -std::sin(angle), 0.0);
    const Eigen::Vector3d down(0, 0, -1);
    camera.T_world_camera.linear() << down.cross(forward), down, forward;
    camera.T_world_camera.translation() = Eigen::Vector3d(0, 0, 1) - 3.0 * forward;
    ring.push_back(camera);
  }
  return ring;
}

/// Grey with a bright upright box in its middle when somebody is there.
inline cv::Mat smallImage(bool somebody) {
  cv::Mat image(60, 80, CV_8UC3, cv::Scalar(80, 80, 80));
  if (somebody) image(cv::Rect(34, 10, 12, 40)).setTo(cv::Scalar(30, 200, 240));
  return image;
}

inline cv::Mat smallMask() {
  cv::Mat mask = cv::Mat::zeros(60, 80, CV_8UC1);
  mask(cv::Rect(34, 10, 12, 40)).setTo(255);
  return mask;
}

}  // namespace markerless_mocap
