#include "studies/reproduce/hsiao/hsiao_strip.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "evaluation/body_points.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

constexpr double kAround = 1.15;  // of the person's height that an image shows

/// The model's segments, by bodyPointNames(), from end to end.
const std::vector<std::vector<std::string>>& segments() {
  static const std::vector<std::vector<std::string>> kSegments = {
      {"pelvis", "thorax", "head_top"},
      {"thorax", "l_shoulder", "l_elbow", "l_wrist", "l_hand_tip"},
      {"thorax", "r_shoulder", "r_elbow", "r_wrist", "r_hand_tip"},
      {"pelvis", "l_hip", "l_knee", "l_ankle", "l_foot_tip"},
      {"pelvis", "r_hip", "r_knee", "r_ankle", "r_foot_tip"}};
  return kSegments;
}

cv::Rect aroundPerson(const Camera& camera, const VisualHull& hull) {
  std::vector<cv::Point> pixels;
  for (const HullVoxel& voxel : hull.voxels)
    if (const auto pixel = camera.project(hull.lattice.center(voxel.index)))
      pixels.emplace_back(int(pixel->x()), int(pixel->y()));
  cv::Rect person = cv::boundingRect(pixels);
  if (person.empty()) person = {0, 0, camera.width(), camera.height()};
  const double ratio = double(kStripWidth) / kStripHeight;
  const double height = kAround * std::max<double>(person.height, person.width / ratio);
  const cv::Point2d middle(person.x + person.width / 2.0, person.y + person.height / 2.0);
  return {int(middle.x - ratio * height / 2), int(middle.y - height / 2), int(ratio * height),
          int(height)};
}

/// The part of a picture, white beyond its border, at the size of a strip's.
cv::Mat cutOut(const cv::Mat& picture, const cv::Rect& part) {
  cv::Mat out(part.size(), CV_8UC3, cv::Scalar::all(255));
  const cv::Rect inside = part & cv::Rect({0, 0}, picture.size());
  if (!inside.empty())
    picture(inside).copyTo(out(cv::Rect(inside.tl() - part.tl(), inside.size())));
  cv::resize(out, out, {kStripWidth, kStripHeight}, 0, 0, cv::INTER_LINEAR);
  return out;
}

cv::Mat inColor(const cv::Mat& image) {
  cv::Mat out = image;
  if (image.channels() == 1) cv::cvtColor(image, out, cv::COLOR_GRAY2BGR);
  return out;
}

LinkPoses linksOf(const PipelineResult& now) {
  LinkPoses T_world_link;
  now.body->model->forwardKinematics(now.pose.T_world_body, now.pose.angles, T_world_link);
  return T_world_link;
}

}  // namespace

cv::Mat personImage(const Camera& camera, const cv::Mat& image, const VisualHull& hull) {
  return cutOut(inColor(image), aroundPerson(camera, hull));
}

BodyView viewOf(const VisualHull& hull, const Camera& camera) {
  Vector3d middle = Vector3d::Zero();
  for (const HullVoxel& voxel : hull.voxels) middle += hull.lattice.center(voxel.index);
  middle /= std::max<double>(1.0, double(hull.voxels.size()));
  middle.z() = 0.0;
  return {middle, camera.position(), {kStripWidth, kStripHeight}};
}

cv::Mat hullPicture(const BodyView& view, const VisualHull& hull) {
  cv::Mat picture = view.paper();
  drawVoxels(view, hull, std::vector<cv::Scalar>(hull.voxels.size(), {215, 150, 90}), &picture);
  return picture;
}

cv::Mat partsPicture(const BodyView& view, const VisualHull& hull, const BodyParts& parts) {
  cv::Mat picture = view.paper();
  std::vector<cv::Scalar> colors;
  for (const uint8_t label : parts.labels) colors.push_back(partColor(label));
  if (colors.size() == hull.voxels.size()) drawVoxels(view, hull, colors, &picture);
  return picture;
}

cv::Mat curvesPicture(const BodyView& view, const PipelineResult& now) {
  cv::Mat picture = view.paper();
  for (int part = 0; part < kPartCount; ++part)
    drawCurve(view, now.parts.parts[size_t(part)].points, partColor(part), 3, &picture);
  if (now.pose.status == PoseStatus::kLost) return picture;
  const Eigen::Matrix3Xd points = bodyPoints(*now.body->model, linksOf(now));
  const std::vector<std::string> names = bodyPointNames();
  for (const std::vector<std::string>& segment : segments()) {
    std::vector<Vector3d> line;
    for (const std::string& name : segment)
      line.push_back(points.col(std::find(names.begin(), names.end(), name) - names.begin()));
    drawCurve(view, line, {0, 0, 0}, 1, &picture);
  }
  return picture;
}

cv::Mat bodyPicture(const Camera& camera, const cv::Mat& image, const PipelineResult& now) {
  if (now.pose.status == PoseStatus::kLost) return personImage(camera, image, now.hull);
  const size_t links = now.body->model->links().size();
  const cv::Mat picture =
      bodyOverlay(camera, inColor(image), cv::Mat(), *now.body->model, linksOf(now),
                  {{std::vector<bool>(links, true), cv::Scalar(60, 200, 250)}}, "");
  return cutOut(picture, aroundPerson(camera, now.hull));
}

std::vector<cv::Mat> stripColumn(const Camera& camera, const cv::Mat& image,
                                 const PipelineResult& now) {
  const BodyView view = viewOf(now.hull, camera);
  return {personImage(camera, image, now.hull), hullPicture(view, now.hull),
          partsPicture(view, now.hull, now.parts), curvesPicture(view, now),
          bodyPicture(camera, image, now)};
}

}  // namespace markerless_mocap
