#include "studies/reproduce/bakken/bakken_pictures.h"

#include <opencv2/imgproc.hpp>

#include "markerless_mocap/skeleton/pose_tree_builder.h"
#include "studies/common/bakken_variants.h"
#include "studies/reproduce/bakken/bakken_film.h"

namespace markerless_mocap {
namespace {

constexpr size_t kPictures = 4;
constexpr int kWidth = 300, kHeight = 360, kQuality = 85;
const cv::Scalar kHullColor(225, 225, 225), kWhite(255, 255, 255);

void dot(const Camera& camera, const Eigen::Vector3d& point, int radius, const cv::Scalar& color,
         cv::Mat* image) {
  if (const auto pixel = camera.project(point))
    cv::circle(*image, {int(pixel->x()), int(pixel->y())}, radius, color, cv::FILLED, cv::LINE_AA);
}

}  // namespace

const TreeColors& sideColors() {
  static const TreeColors kColors = {{{150, 150, 150},
                                      {0, 170, 220},
                                      {60, 60, 60},
                                      {0, 170, 0},
                                      {0, 0, 220},
                                      {0, 110, 0},
                                      {0, 0, 140}}};
  return kColors;
}

cv::Mat drawTree(const Camera& camera, const VisualHull& hull, const PoseTree& tree,
                 const TreeColors& nodes) {
  cv::Mat image(camera.height(), camera.width(), CV_8UC3, kWhite);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const HullVoxel& voxel : hull.voxels) {
    const Eigen::Vector3d center = hull.lattice.center(voxel.index);
    dot(camera, center, 3, kHullColor, &image);
    middle += center / double(hull.voxels.size());
  }
  const auto partOf = [&](const TreeNode& node) {
    return size_t(tree.valid() ? node.part : TreePart::kNone);
  };
  for (const TreeNode& node : tree.nodes)
    dot(camera, node.position, 2, nodes[partOf(node)], &image);
  for (const TreeExtremity& extremity : tree.extremities)
    if (extremity.node >= 0 && tree.valid())
      dot(camera, extremity.position, 5, sideColors()[partOf(tree.nodes[size_t(extremity.node)])],
          &image);
  const auto at = camera.project(middle);
  if (!at) return cv::Mat(kHeight, kWidth, CV_8UC3, kWhite);
  cv::Mat part;
  cv::getRectSubPix(image, {kWidth, kHeight}, {float(at->x()), float(at->y())}, part);
  return part;
}

Json drawTrees(const Capture& capture, int edge) {
  const JointTrack truth = labelTruth(capture);
  const CameraRig rig = rigOf(capture);
  HullCarver carver(rig, cubeAround(truth, publishedBakkenOptions(edge).hull));
  const std::string published = publishedBakkenYaml();
  PoseTreeBuilder above(optionsOf({"published", ""}, published)),
      below(optionsOf({"learned", "", {}, true}, published));
  std::vector<cv::Mat> columns;
  forEachFrame(capture, truth, [&](size_t frame, const std::vector<HullView>& views) {
    const VisualHull hull = carver.carve(views);
    const PoseTree one = above.build(hull), other = below.build(hull);
    if (frame != (columns.size() * 2 + 1) * truth.frames() / (2 * kPictures)) return;
    cv::Mat column;
    cv::vconcat(drawTree(rig[0], hull, one), drawTree(rig[0], hull, other), column);
    columns.push_back(column);
  });
  cv::Mat picture;
  cv::hconcat(columns, picture);
  return {{"jpeg", packedJpeg(picture, kQuality)}};
}

}  // namespace markerless_mocap
