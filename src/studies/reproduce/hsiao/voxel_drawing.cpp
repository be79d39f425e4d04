#include "studies/reproduce/hsiao/voxel_drawing.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

constexpr double kHeight = 2.2;      // metres that a picture shows
constexpr double kElevation = 0.25;  // of the view, rad
constexpr double kMargin = 0.06;     // below the floor, of the picture
constexpr int kCaption = 18;         // px
constexpr int kShift = 4;            // fractional bits of corners

/// Brightness of a face by its axis: sides, sides, top.
constexpr double kShade[3] = {0.72, 0.86, 1.0};

}  // namespace

BodyView::BodyView(const Vector3d& middle, const Vector3d& from, cv::Size size)
    : middle_(middle), scale_((1.0 - kMargin) * size.height / kHeight), size_(size) {
  Vector3d level = middle - from;
  level.z() = 0.0;
  level.normalize();
  into_ = std::cos(kElevation) * level - std::sin(kElevation) * Vector3d::UnitZ();
  right_ = level.cross(Vector3d::UnitZ());
  up_ = right_.cross(into_);
}

cv::Point BodyView::at(const Vector3d& point) const {
  const Vector3d from = point - middle_;
  const double one = 1 << kShift;
  return {int(std::lround(one * (size_.width / 2.0 + scale_ * right_.dot(from)))),
          int(std::lround(one * ((1.0 - kMargin) * size_.height - scale_ * up_.dot(from))))};
}

cv::Scalar partColor(int part) {
  static const cv::Scalar kColors[] = {{200, 170, 60}, {60, 60, 225},  {50, 175, 50},
                                       {40, 190, 235}, {225, 110, 40}, {200, 70, 190}};
  return kColors[part % 6];
}

void drawVoxels(const BodyView& view, const VisualHull& hull, const std::vector<cv::Scalar>& colors,
                cv::Mat* picture) {
  std::vector<size_t> order(hull.voxels.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::vector<double> depth;
  for (const HullVoxel& voxel : hull.voxels)
    depth.push_back(view.depth(hull.lattice.center(voxel.index)));
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return depth[a] > depth[b]; });
  const double half = 0.5 * hull.lattice.pitch;
  for (const size_t v : order) {
    const Vector3d center = hull.lattice.center(hull.voxels[v].index);
    for (int axis = 0; axis < 3; ++axis) {
      Vector3d out = Vector3d::Zero(), a = Vector3d::Zero(), b = Vector3d::Zero();
      out[axis] = view.into()[axis] > 0 ? -half : half;
      a[(axis + 1) % 3] = b[(axis + 2) % 3] = half;
      const Vector3d face = center + out;
      const cv::Point corners[] = {view.at(face - a - b), view.at(face + a - b),
                                   view.at(face + a + b), view.at(face - a + b)};
      cv::fillConvexPoly(*picture, corners, 4, colors[v] * kShade[axis], cv::LINE_AA, kShift);
    }
  }
}

void drawCurve(const BodyView& view, const std::vector<Vector3d>& points, const cv::Scalar& color,
               int width, cv::Mat* picture) {
  for (size_t i = 1; i < points.size(); ++i)
    cv::line(*picture, view.at(points[i - 1]), view.at(points[i]), color, width, cv::LINE_AA,
             kShift);
}

cv::Mat joined(const std::vector<std::vector<cv::Mat>>& rows,
               const std::vector<std::string>& columns) {
  cv::Mat all;
  if (!columns.empty()) {
    const cv::Size size = rows.front().front().size();
    all = cv::Mat(kCaption, size.width * int(columns.size()), CV_8UC3, cv::Scalar::all(255));
    for (size_t i = 0; i < columns.size(); ++i)
      cv::putText(all, columns[i], {int(i) * size.width + 6, kCaption - 5},
                  cv::FONT_HERSHEY_SIMPLEX, 0.4, cv::Scalar::all(40), 1, cv::LINE_AA);
  }
  for (const std::vector<cv::Mat>& row : rows) {
    cv::Mat line;
    cv::hconcat(row, line);
    if (all.empty())
      all = line;
    else
      cv::vconcat(all, line, all);
  }
  return all;
}

}  // namespace markerless_mocap
