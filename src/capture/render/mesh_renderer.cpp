#include "capture/render/mesh_renderer.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <stdexcept>

#include "capture/render/room_view.h"
#include "capture/render/sample_grid.h"
#include "capture/render/triangle_rasterizer.h"

namespace markerless_mocap {
namespace {

/// Colour of a pixel: its nine samples blended over the background.
void blend(const SampleBuffer& buffer, int x, int y, cv::Vec3b& color) {
  int covered = 0, sum[3] = {};
  for (int v = -1; v <= 1; ++v) {
    const Sample* const samples = buffer.row(2 * y + 1 + v) + 2 * x + 1;
    for (int u = -1; u <= 1; ++u) {
      if (samples[u].kind == Sample::kNothing) continue;
      const int fraction = kTent[std::abs(u) + std::abs(v)];
      covered += fraction;
      for (int i = 0; i < 3; ++i) sum[i] += fraction * samples[u].bgr[i];
    }
  }
  if (covered == 0) return;
  for (int i = 0; i < 3; ++i)
    color[i] = uint8_t((sum[i] + (kTentSum - covered) * color[i] + kTentSum / 2) / kTentSum);
}

void drawObjects(const SampleGrid& grid, const SampleBuffer& buffer, RenderedView& view) {
  for (int y = buffer.rect.y / 2; 2 * y + 2 < buffer.rect.br().y; ++y)
    for (int x = buffer.rect.x / 2; 2 * x + 2 < buffer.rect.br().x; ++x) {
      blend(buffer, x, y, view.image.at<cv::Vec3b>(y, x));
      const Sample& center = buffer.row(2 * y + 1)[2 * x + 1];
      if (center.kind == Sample::kNothing) continue;
      const Eigen::Vector2f& plane = grid.row(2 * y + 1)[2 * x + 1];
      view.depth.at<float>(y, x) = center.depth * std::sqrt(1.0f + plane.squaredNorm());
      if (center.kind == Sample::kPerson) view.mask.at<uint8_t>(y, x) = 255;
    }
}

}  // namespace

MeshRenderer::MeshRenderer(Camera camera, const TexturedRoom& room)
    : camera_(std::move(camera)),
      grid_(std::make_shared<SampleGrid>(camera_)),
      room_view_(std::make_shared<RoomView>(camera_, *grid_, room)) {}

const cv::Mat& MeshRenderer::background() const {
  return room_view_->picture();
}

RenderedView MeshRenderer::render(const LitScene& scene) const {
  const cv::Size size = background().size();
  RenderedView view;
  view.image = background().clone();
  view.mask = cv::Mat::zeros(size, CV_8UC1);
  view.depth = cv::Mat(size, CV_32FC1, cv::Scalar(std::numeric_limits<float>::infinity()));
  room_view_->castShadows(scene, view.image);
  const SampleBuffer buffer = rasterize(*grid_, scene);
  if (!buffer.rect.empty()) drawObjects(*grid_, buffer, view);
  return view;
}

std::vector<MeshRenderer> makeRenderers(const CameraRig& rig, const TexturedRoom& room) {
  std::vector<std::optional<MeshRenderer>> made(rig.size());
  tbb::parallel_for(size_t(0), rig.size(), [&](size_t i) { made[i].emplace(rig[i], room); });
  std::vector<MeshRenderer> renderers;
  for (auto& renderer : made) renderers.push_back(std::move(*renderer));
  return renderers;
}

RenderedView motionBlurred(const std::vector<RenderedView>& shots) {
  if (shots.empty()) throw std::invalid_argument("motion blur of no picture at all");
  const RenderedView& middle = shots[shots.size() / 2];
  cv::Mat sum = cv::Mat::zeros(middle.image.size(), CV_32FC3);
  for (const RenderedView& shot : shots) {
    if (shot.image.size() != middle.image.size())
      throw std::invalid_argument("motion blur of pictures of different sizes");
    cv::accumulate(shot.image, sum);
  }
  RenderedView blurred = middle;
  blurred.image = cv::Mat();
  sum.convertTo(blurred.image, CV_8U, 1.0 / double(shots.size()));
  return blurred;
}

}  // namespace markerless_mocap
