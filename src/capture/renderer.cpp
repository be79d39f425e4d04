#include "markerless_mocap/capture/renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "capture/room.h"
#include "capture/round_cone_ray.h"

namespace markerless_mocap {
namespace {

/// Towards the lamp; the rest of the light comes from everywhere.
const Eigen::Vector3d kLight = Eigen::Vector3d(0.3, 0.2, 1.0).normalized();
constexpr double kAmbient = 0.55;

cv::Vec3b toBgr(const Eigen::Vector3d& rgb) {
  const auto level = [](double v) { return uint8_t(std::lround(255.0 * std::clamp(v, 0.0, 1.0))); };
  return {level(rgb.z()), level(rgb.y()), level(rgb.x())};
}

cv::Vec3b shaded(const Eigen::Vector3f& rgb, const Eigen::Vector3d& normal) {
  const double light = kAmbient + (1.0 - kAmbient) * 0.5 * (1.0 + normal.dot(kLight));
  return toBgr(rgb.cast<double>() * light);
}

}  // namespace

std::vector<SolidCone> posedShape(const BodyModel& model, const LinkPoses& T_world_link) {
  std::vector<SolidCone> cones;
  for (const RoundCone& cone : model.shape()) {
    const Eigen::Isometry3d& T_world = T_world_link[cone.link];
    cones.push_back({T_world * cone.a, T_world * cone.b, cone.radius_a, cone.radius_b, cone.rgb});
  }
  return cones;
}

ViewRenderer::ViewRenderer(Camera camera)
    : camera_(std::move(camera)), background_(camera_.height(), camera_.width(), CV_8UC3) {
  rays_.reserve(size_t(camera_.width()) * camera_.height());
  const Eigen::Vector3d eye = camera_.position(), room = roomAround(eye);
  for (int y = 0; y < camera_.height(); ++y)
    for (int x = 0; x < camera_.width(); ++x) {
      const Eigen::Vector3d ray = camera_.rayDirection({double(x), double(y)});
      rays_.push_back(ray.cast<float>());
      background_.at<cv::Vec3b>(y, x) = toBgr(roomColor(eye, ray, room));
    }
}

cv::Rect ViewRenderer::boundingBox(const SolidCone& cone) const {
  const cv::Rect image(0, 0, camera_.width(), camera_.height());
  const Eigen::Vector3d low = (cone.a.array() - cone.radius_a).min(cone.b.array() - cone.radius_b);
  const Eigen::Vector3d high = (cone.a.array() + cone.radius_a).max(cone.b.array() + cone.radius_b);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Eigen::Vector2d first(kInfinity, kInfinity), last(-kInfinity, -kInfinity);
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d point(corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                                corner & 4 ? high.z() : low.z());
    const auto pixel = camera_.project(point);
    if (!pixel) return image;
    first = first.cwiseMin(*pixel);
    last = last.cwiseMax(*pixel);
  }
  // Distortion bends the box's edges by less than this share of its size.
  const Eigen::Vector2d margin = 0.05 * (last - first) + Eigen::Vector2d(2.0, 2.0);
  const auto clipped = [](double v, int size) { return int(std::clamp(v, -1.0, double(size))); };
  const cv::Point from(clipped(first.x() - margin.x(), image.width),
                       clipped(first.y() - margin.y(), image.height));
  const cv::Point to(clipped(last.x() + margin.x(), image.width),
                     clipped(last.y() + margin.y(), image.height));
  return cv::Rect(from, to) & image;
}

void ViewRenderer::draw(const SolidCone& cone, RenderedView& view) const {
  const RoundConeCaster caster(cone, camera_.position());
  const cv::Rect box = boundingBox(cone);
  for (int y = box.y; y < box.y + box.height; ++y)
    for (int x = box.x; x < box.x + box.width; ++x) {
      const auto hit = caster.cast(rays_[size_t(y) * camera_.width() + x].cast<double>());
      float& depth = view.depth.at<float>(y, x);
      if (!hit || hit->distance >= depth) continue;
      depth = float(hit->distance);
      view.mask.at<uint8_t>(y, x) = 255;
      view.image.at<cv::Vec3b>(y, x) = shaded(cone.rgb, hit->normal);
    }
}

RenderedView ViewRenderer::render(const std::vector<SolidCone>& cones) const {
  RenderedView view;
  view.image = background_.clone();
  view.mask = cv::Mat::zeros(background_.size(), CV_8UC1);
  view.depth =
      cv::Mat(background_.size(), CV_32FC1, cv::Scalar(std::numeric_limits<float>::infinity()));
  for (const SolidCone& cone : cones) draw(cone, view);
  return view;
}

}  // namespace markerless_mocap
