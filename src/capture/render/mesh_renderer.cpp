#include "capture/render/mesh_renderer.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <stdexcept>

#include "capture/render/floor_mirror.h"
#include "capture/render/pixel_blend.h"
#include "capture/render/room_view.h"
#include "capture/render/sample_grid.h"
#include "capture/render/triangle_rasterizer.h"

namespace markerless_mocap {
namespace {

/// Colour of a pixel: its nine samples blended over the background.
void blend(const SampleBuffer& buffer, int x, int y, cv::Vec3b& color) {
  const PixelBlend objects(buffer, x, y);
  if (objects.covered == 0) return;
  for (int i = 0; i < 3; ++i)
    color[i] = uint8_t((objects.sum[i] + (kTentSum - objects.covered) * color[i] + kTentSum / 2) /
                       kTentSum);
}

void drawObjects(const SampleGrid& grid, const SampleBuffer& buffer, RenderedView& view) {
  forEachPixel(buffer, [&](int x, int y) {
    blend(buffer, x, y, view.image.at<cv::Vec3b>(y, x));
    const Sample& center = buffer.row(2 * y + 1)[2 * x + 1];
    if (center.kind == Sample::kNothing) return;
    const Eigen::Vector2f& plane = grid.row(2 * y + 1)[2 * x + 1];
    view.depth.at<float>(y, x) = center.depth * std::sqrt(1.0f + plane.squaredNorm());
    if (center.kind == Sample::kPerson) view.mask.at<uint8_t>(y, x) = 255;
  });
}

}  // namespace

MeshRenderer::MeshRenderer(Camera camera, const TexturedRoom& room, double floor_reflection)
    : camera_(std::move(camera)),
      grid_(std::make_shared<SampleGrid>(camera_)),
      mirror_(floor_reflection > 0.0
                  ? std::make_shared<FloorMirror>(camera_, *grid_, room, floor_reflection)
                  : nullptr),
      room_view_(std::make_shared<RoomView>(camera_, *grid_, room, mirror_.get())) {}

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
  room_view_->changeLight(scene, view.image);
  if (mirror_) mirror_->addObjects(*grid_, scene, view.image);
  drawObjects(*grid_, rasterize(*grid_, scene), view);
  return view;
}

std::vector<MeshRenderer> makeRenderers(const CameraRig& rig, const TexturedRoom& room,
                                        double floor_reflection) {
  std::vector<std::optional<MeshRenderer>> made(rig.size());
  tbb::parallel_for(size_t(0), rig.size(),
                    [&](size_t i) { made[i].emplace(rig[i], room, floor_reflection); });
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
