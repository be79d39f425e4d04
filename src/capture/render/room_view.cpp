#include "capture/render/room_view.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "capture/render/floor_mirror.h"
#include "capture/scene/shadow_map.h"

namespace markerless_mocap {
namespace {

uint8_t levelOf(float fraction) {
  return uint8_t(std::clamp(255.0f * fraction + 0.5f, 0.0f, 255.0f));
}

int blocksAlong(int pixels, int block) {
  return (pixels + block - 1) / block;
}

/// Cosine of the angle at which the sun meets the room's surface, 0 on those that it does not see.
float sunOnWall(const Eigen::Vector3f& half_size, const Eigen::Vector3f& place) {
  constexpr float kOn = 1e-3f;  // metres
  const Eigen::Vector3f to_sun = (sunLamp().position - place).normalized();
  if (place.z() < kOn) return to_sun.z();
  if (place.x() < kOn - half_size.x()) return std::max(to_sun.x(), 0.0f);
  if (place.y() < kOn - half_size.y()) return std::max(to_sun.y(), 0.0f);
  return 0.0f;
}

}  // namespace

RoomView::RoomView(const Camera& camera, const SampleGrid& grid, const TexturedRoom& room,
                   const FloorMirror* mirror)
    : half_size_(room.halfSize()),
      picture_(camera.height(), camera.width(), CV_8UC3),
      positions_(camera.height(), camera.width(), CV_32FC3),
      lamps_(room.lamps()) {
  drawPicture(camera, grid, room);
  if (mirror) mirror->addRoom(picture_);
  boundBlocks(room);
}

void RoomView::drawPicture(const Camera& camera, const SampleGrid& grid, const TexturedRoom& room) {
  const Eigen::Matrix3d& R_world_camera = camera.calibration().T_world_camera.linear();
  const cv::Size size = grid.size();
  std::vector<Eigen::Vector3f> colors(size_t(size.area()));
  tbb::parallel_for(0, size.height, [&](int y) {
    for (int x = 0; x < size.width; ++x) {
      const Eigen::Vector3d ray = R_world_camera * grid.row(y)[x].cast<double>().homogeneous();
      const RoomPoint point = room.at(camera.position(), ray);
      colors[size_t(y) * size.width + x] = point.color;
      if (x % 2 == 1 && y % 2 == 1)
        positions_.at<cv::Vec3f>(y / 2, x / 2) = {point.position.x(), point.position.y(),
                                                  point.position.z()};
    }
  });
  tbb::parallel_for(0, picture_.rows, [&](int y) {
    for (int x = 0; x < picture_.cols; ++x) {
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (int v = -1; v <= 1; ++v)
        for (int u = -1; u <= 1; ++u)
          sum += float(kTent[std::abs(u) + std::abs(v)]) *
                 colors[size_t(2 * y + 1 + v) * size.width + (2 * x + 1 + u)];
      sum /= float(kTentSum);
      picture_.at<cv::Vec3b>(y, x) = {levelOf(sum.z()), levelOf(sum.y()), levelOf(sum.x())};
    }
  });
}

cv::Rect RoomView::blockRect(int block) const {
  const int columns = blocksAlong(picture_.cols, kBlock);
  return cv::Rect(block % columns * kBlock, block / columns * kBlock, kBlock, kBlock) &
         cv::Rect(cv::Point(), picture_.size());
}

void RoomView::boundBlocks(const TexturedRoom& room) {
  const int blocks = blocksAlong(picture_.cols, kBlock) * blocksAlong(picture_.rows, kBlock);
  for (const Lamp& lamp : room.lamps()) {
    std::vector<Bounds> bounds(blocks);
    for (int i = 0; i < blocks; ++i) {
      const cv::Rect rect = blockRect(i);
      for (int y = rect.y; y < rect.br().y; ++y)
        for (int x = rect.x; x < rect.br().x; ++x) {
          const Eigen::Map<const Eigen::Vector3f> place(positions_.at<cv::Vec3f>(y, x).val);
          const Eigen::Vector2f texel = shadowTexel(lamp, place);
          const bool first = y == rect.y && x == rect.x;
          bounds[i].low = first ? texel : bounds[i].low.cwiseMin(texel).eval();
          bounds[i].high = first ? texel : bounds[i].high.cwiseMax(texel).eval();
        }
    }
    bounds_.push_back(std::move(bounds));
  }
}

void RoomView::castShadows(const LitScene& scene, cv::Mat& image) const {
  if (scene.shadowStrength() == 0.0) return;
  for (int block = 0; block < int(bounds_.front().size()); ++block) {
    uint32_t lamps = 0;
    for (size_t i = 0; i < lamps_.size(); ++i) {
      const cv::Rect& rect = scene.shadowMaps()[i].rect();
      const Bounds& bounds = bounds_[i][block];
      if (bounds.low.x() < rect.br().x && bounds.high.x() > rect.x &&
          bounds.low.y() < rect.br().y && bounds.high.y() > rect.y)
        lamps |= 1u << i;
    }
    if (lamps) shadeBlock(blockRect(block), scene, lamps, image);
  }
}

void RoomView::shadeBlock(const cv::Rect& rect, const LitScene& scene, uint32_t lamps,
                          cv::Mat& image) const {
  for (int y = rect.y; y < rect.br().y; ++y)
    for (int x = rect.x; x < rect.br().x; ++x) {
      const Eigen::Map<const Eigen::Vector3f> place(positions_.at<cv::Vec3f>(y, x).val);
      float lost = 0.0f;
      for (size_t i = 0; i < lamps_.size(); ++i)
        if (lamps >> i & 1u)
          lost += lamps_[i].fraction * scene.lampOn(i) *
                  scene.shadowMaps()[i].occlusion(shadowTexel(lamps_[i], place));
      if (lost == 0.0f) continue;
      const float left = 1.0f - float(scene.shadowStrength()) * lost;
      for (uint8_t& level : image.at<cv::Vec3b>(y, x).val) level = uint8_t(level * left + 0.5f);
    }
}

/// Factor of the room's picture.
Eigen::Vector3f RoomView::lightAt(const LitScene& scene, const Eigen::Vector3f& place) const {
  const RoomLight& light = scene.light();
  const float off = (1.0f - light.main_lamp) * mainLampAt(lamps_[kMainLamp], place);
  Eigen::Vector3f factor = Eigen::Vector3f::Constant(1.0f - off);
  if (!scene.sunShadow()) return factor;
  const float hidden = scene.sunShadow()->occlusion(shadowTexel(sunLamp(), place));
  factor += sunlightAt(light, place) * (sunOnWall(half_size_, place) * (1.0f - hidden));
  return factor;
}

void RoomView::changeLight(const LitScene& scene, cv::Mat& image) const {
  if (scene.light().usual()) return;
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x) {
      const Eigen::Map<const Eigen::Vector3f> place(positions_.at<cv::Vec3f>(y, x).val);
      const Eigen::Vector3f factor = lightAt(scene, place);
      cv::Vec3b& color = image.at<cv::Vec3b>(y, x);
      for (int i = 0; i < 3; ++i)
        color[i] = uint8_t(std::min(color[i] * factor[2 - i] + 0.5f, 255.0f));
    }
}

}  // namespace markerless_mocap
