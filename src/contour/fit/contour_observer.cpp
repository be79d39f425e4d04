#include <tbb/parallel_for.h>
#include <Eigen/Geometry>
#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "contour/fit/contour_observation.h"
#include "contour/fit/outline.h"
#include "contour/fit/prepared_views.h"
#include "contour/fit/ray_table.h"
#include "contour/fit/signed_distance.h"
#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Samples across the box of a view: every second pixel up to VGA, fewer of larger images.
constexpr int kSamplesAcross = 330;

// Margin around the box of the person, as a fraction of the image width. It provides the gradient
// of the distance to a body near the person.
constexpr double kMargin = 0.04;

// Image width divided by the radius of the disk that normals are computed in.
constexpr int kWidthPerNormalRadius = 160;

bool fits(const cv::Mat& mask, const Camera& camera) {
  return mask.type() == CV_8UC1 && mask.cols == camera.width() && mask.rows == camera.height();
}

void checkMasks(const std::vector<cv::Mat>& masks, const CameraRig& rig) {
  if (masks.size() != rig.size())
    throw std::invalid_argument("contour: " + std::to_string(masks.size()) +
                                " masks were given, the rig has " + std::to_string(rig.size()) +
                                " cameras");
  for (size_t i = 0; i < masks.size(); ++i)
    if (!masks[i].empty() && !fits(masks[i], rig[i]))
      throw std::invalid_argument(
          "contour: the mask of camera '" + rig[i].name() +
          "' must have one channel of 8 bits and the size of the camera's image");
}

/// The mask's pixel of the first sample of a row of the view.
const uchar* firstSample(const cv::Mat& mask, const ContourView& view, int row) {
  return mask.ptr<uchar>((view.corner.y + row) * view.step, view.corner.x * view.step);
}

void measureDistances(const cv::Mat& mask, const cv::Rect& box, ContourView& view) {
  view.step = std::max(1, (mask.cols + kSamplesAcross - 1) / kSamplesAcross);
  const int margin = int(kMargin * mask.cols);
  const cv::Rect wide =
      cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin) &
      cv::Rect(0, 0, mask.cols, mask.rows);
  // The samples of all views lie at multiples of the step.
  view.corner = wide.tl() / view.step;
  const cv::Point end = (wide.br() - cv::Point(1, 1)) / view.step;
  view.person.create(end.y - view.corner.y + 1, end.x - view.corner.x + 1, CV_8UC1);
  for (int y = 0; y < view.person.rows; ++y) {
    const uchar* from = firstSample(mask, view, y);
    uchar* to = view.person.ptr<uchar>(y);
    for (ptrdiff_t x = 0; x < view.person.cols; ++x) to[x] = from[x * view.step] ? 255 : 0;
  }
  view.distance = signedDistance(view.person);
  if (view.step > 1) view.distance *= view.step;
}

/// Marks unknown samples; the body may be there.
void findUnknown(const cv::Mat& mask, ContourView& view) {
  cv::Mat known(view.person.size(), CV_8UC1, cv::Scalar(255));
  bool all_known = true;
  for (int y = 0; y < known.rows; ++y) {
    const uchar* from = firstSample(mask, view, y);
    uchar* to = known.ptr<uchar>(y);
    for (ptrdiff_t x = 0; x < known.cols; ++x)
      if (from[x * view.step] == kUnknownPixel) {
        to[x] = 0;
        all_known = false;
      }
  }
  if (!all_known) view.known = known;
}

OutlinedView viewOf(const cv::Mat& mask) {
  OutlinedView out;
  if (mask.empty()) return out;
  const cv::Rect box = shownBox(mask);
  out.view.status = ViewStatus::kEmpty;
  if (box.area() == 0) return out;
  findCracks(mask, box, out.cracks);
  out.view.status = ViewStatus::kFull;
  if (out.cracks.empty()) return out;
  out.view.status = ViewStatus::kUsable;
  measureDistances(mask, box, out.view);
  findUnknown(mask, out.view);
  return out;
}

/// Returns false where the contour has no direction.
bool castRay(const cv::Mat& mask, const Camera& camera, const RayTable& rays, const Crack& crack,
             ContourRay& ray) {
  const int radius = std::clamp(mask.cols / kWidthPerNormalRadius, 2, kMaxNormalRadius);
  const Vector2d out = outwardNormal(mask, crack, radius);
  if (!(out.squaredNorm() > 0)) return false;
  const Vector2d pixel = crack.pixel(), along = 0.5 * Vector2d(-out.y(), out.x()).normalized();
  const Vector3d ahead = rays.direction(pixel + along), behind = rays.direction(pixel - along);
  // The tangent plane of the surface contains the camera centre and the contour at this point. Its
  // normal follows from the image normal, turned by a right angle, and the direction of the ray. It
  // points away from the person.
  const Vector3d direction = (ahead + behind).normalized();
  const Vector3d normal = ahead.cross(behind).normalized(), side = direction.cross(normal);
  ray.normal = normal.cast<float>();
  ray.side = side.cast<float>();
  ray.normal_of_ray = float(normal.dot(camera.position()));
  ray.side_of_ray = float(side.dot(camera.position()));
  ray.pixel = pixel.cast<float>();
  return true;
}

/// Index i of `count` indices that are evenly distributed over `total`.
size_t spread(size_t i, size_t count, size_t total) {
  return (2 * i + 1) * total / (2 * count);
}

}  // namespace

const char* toString(ViewStatus status) {
  constexpr const char* kNames[] = {"missing", "empty", "full", "usable", "contradicted"};
  return kNames[size_t(status)];
}

int ContourObservation::usableViews() const {
  return int(std::count_if(views.begin(), views.end(), [](const ContourView& view) {
    return view.status == ViewStatus::kUsable;
  }));
}

ContourObserver::ContourObserver(const CameraRig& rig, const ContourOptions& options)
    : rig_(rig), rays_(options.rays) {
  options.validate();
  if (rig.empty()) throw std::invalid_argument("contour: the rig has no cameras");
  for (const Camera& camera : rig_) pixel_rays_.emplace_back(camera);
  prepared_ = std::make_unique<PreparedViews>(rig.size());
}

ContourObserver::~ContourObserver() = default;

void ContourObserver::check(const std::vector<cv::Mat>& masks) const {
  checkMasks(masks, rig_);
}

void ContourObserver::prepare(size_t camera, const cv::Mat& mask) const {
  if (camera >= rig_.size() || !fits(mask, rig_[camera]) || hasUnknownPixels(mask)) return;
  prepared_->put(camera, mask, std::make_shared<const OutlinedView>(viewOf(mask)));
}

ContourObservation ContourObserver::observe(const std::vector<cv::Mat>& masks) const {
  return observe(masks, rays_);
}

ContourObservation ContourObserver::observeRoughly(const std::vector<cv::Mat>& masks) const {
  return observe(masks, rays_ / 3);
}

ContourObservation ContourObserver::observe(const std::vector<cv::Mat>& masks,
                                            int rays_wanted) const {
  check(masks);
  ContourObservation seen;
  seen.views.resize(rig_.size());
  std::vector<std::shared_ptr<const OutlinedView>> outlined(rig_.size());
  tbb::parallel_for(size_t(0), rig_.size(), [&](size_t i) {
    outlined[i] = prepared_->find(i, masks[i]);
    if (!outlined[i]) outlined[i] = std::make_shared<const OutlinedView>(viewOf(masks[i]));
    seen.views[i] = outlined[i]->view;
  });
  std::vector<size_t> ends;  // per camera: end of its cracks in the list of all
  for (size_t i = 0; i < outlined.size(); ++i)
    ends.push_back((i ? ends.back() : 0) + outlined[i]->cracks.size());
  const size_t total = ends.back(), count = std::min(size_t(rays_wanted), total);
  std::vector<ContourRay> rays(count);
  tbb::parallel_for(tbb::blocked_range<size_t>(0, count, 64), [&](const auto& some) {
    for (size_t i = some.begin(); i < some.end(); ++i) {
      const size_t at = spread(i, count, total);
      const size_t camera = size_t(std::upper_bound(ends.begin(), ends.end(), at) - ends.begin());
      const std::vector<Crack>& cracks = outlined[camera]->cracks;
      const Crack& crack = cracks[at - (ends[camera] - cracks.size())];
      const bool cast = castRay(masks[camera], rig_[camera], pixel_rays_[camera], crack, rays[i]);
      rays[i].camera = cast ? int(camera) : -1;
    }
  });
  for (const ContourRay& ray : rays)
    if (ray.camera >= 0) seen.rays.push_back(ray);
  return seen;
}

}  // namespace markerless_mocap
