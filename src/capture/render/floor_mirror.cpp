#include "capture/render/floor_mirror.h"

#include <tbb/parallel_for.h>

#include <cmath>

#include "capture/render/pixel_blend.h"

namespace markerless_mocap {
namespace {

cv::Vec3b levelsOf(const Eigen::Vector3f& color) {
  const auto level = [](float fraction) { return cv::saturate_cast<uint8_t>(255.0f * fraction); };
  return {level(color.z()), level(color.y()), level(color.x())};
}

/// \param cosine of the angle between ray and normal
float schlick(float at_right_angles, float cosine) {
  return at_right_angles + (1.0f - at_right_angles) * std::pow(1.0f - cosine, 5.0f);
}

}  // namespace

FloorMirror::FloorMirror(const Camera& camera, const SampleGrid& grid, const TexturedRoom& room,
                         double reflection)
    : reflected_(cv::Mat::zeros(camera.height(), camera.width(), CV_32FC1)),
      room_(cv::Mat::zeros(camera.height(), camera.width(), CV_8UC3)) {
  constexpr float kFloor = 1e-4f;  // metres
  const Eigen::Matrix3d& R_world_camera = camera.calibration().T_world_camera.linear();
  tbb::parallel_for(0, room_.rows, [&](int y) {
    for (int x = 0; x < room_.cols; ++x) {
      Eigen::Vector3d ray =
          R_world_camera * grid.row(2 * y + 1)[2 * x + 1].cast<double>().homogeneous();
      const Eigen::Vector3d place = room.at(camera.position(), ray).position.cast<double>();
      if (place.z() > kFloor) continue;
      const float cosine = float(-ray.z() / ray.norm());
      ray.z() = -ray.z();
      reflected_.at<float>(y, x) = schlick(float(reflection), cosine);
      room_.at<cv::Vec3b>(y, x) = levelsOf(room.at({place.x(), place.y(), 0.0}, ray).color);
    }
  });
}

void FloorMirror::addRoom(cv::Mat& picture) const {
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) {
      const float part = reflected_.at<float>(y, x);
      cv::Vec3b& color = picture.at<cv::Vec3b>(y, x);
      for (int i = 0; i < 3; ++i)
        color[i] =
            cv::saturate_cast<uint8_t>(color[i] + part * (room_.at<cv::Vec3b>(y, x)[i] - color[i]));
    }
}

void FloorMirror::addObjects(const SampleGrid& grid, const LitScene& scene, cv::Mat& image) const {
  const SampleBuffer buffer = rasterize(grid, scene, true);
  forEachPixel(buffer, [&](int x, int y) {
    const float part = reflected_.at<float>(y, x);
    if (part == 0.0f) return;
    const PixelBlend blend(buffer, x, y);
    cv::Vec3b& color = image.at<cv::Vec3b>(y, x);
    for (int i = 0; i < 3; ++i) {
      const int room = blend.covered * room_.at<cv::Vec3b>(y, x)[i];
      color[i] =
          cv::saturate_cast<uint8_t>(color[i] + part * float(blend.sum[i] - room) / kTentSum);
    }
  });
}

}  // namespace markerless_mocap
