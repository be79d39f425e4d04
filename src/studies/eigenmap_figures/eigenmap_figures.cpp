#include "studies/eigenmap_figures/eigenmap_figures.h"

#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <opencv2/imgcodecs.hpp>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "markerless_mocap/segmentation/body_segmenter.h"
#include "ros/hull_conversions.h"
#include "segmentation/eigenmap.h"
#include "segmentation/eigenmap_alignment.h"
#include "segmentation/spline_propagation.h"
#include "segmentation/voxel_graph.h"
#include "studies/eigenmap_figures/eigenmap_drawing.h"
#include "studies/eigenmap_figures/eigenmap_test_image.h"
#include "tools/common/bag_io.h"

namespace markerless_mocap {
namespace {

constexpr int kModes = 6, kLimbs = 5;
constexpr double kPlaneShrink = 4.0, kPlaneRadius = 0.3, kHullShrink = 100.0;

struct Variant {
  const char* name;
  SplineTermination stop;
  bool color;
  bool shrink;
};
constexpr Variant kPlaneVariants[] = {{"plain", SplineTermination::kOutliers, false, false},
                                      {"shrunk", SplineTermination::kOrigin, false, true},
                                      {"color", SplineTermination::kOrigin, true, true}};
constexpr Variant kHullVariants[] = {{"sundaresan", SplineTermination::kOutliers, false, false},
                                     {"modified", SplineTermination::kOrigin, true, true}};

std::vector<cv::Scalar> colorsOf(const std::vector<int>& branch) {
  std::vector<cv::Scalar> colors;
  for (const int b : branch) colors.push_back(branchColor(b));
  return colors;
}

std::string write(const std::string& folder, const std::string& name, const cv::Mat& picture) {
  const std::string file = (std::filesystem::path(folder) / (name + ".png")).string();
  if (!cv::imwrite(file, picture)) throw std::runtime_error("cannot write " + file);
  return file;
}

std::string drawPlane(const std::string& folder, const Variant& variant) {
  const cv::Mat image = testImage();
  const PixelGraph plane = pixelGraph(image, {variant.color, variant.shrink ? kPlaneShrink : 0.0});
  const Eigenmap map = laplacianEigenmap(plane.graph, kModes);
  const std::vector<int> branch = branchOfNodes(
      splinePropagationBranches(map, variant.stop, kLimbs, kPlaneRadius), plane.pixel.size());
  Eigen::MatrixXd places(Eigen::Index(plane.pixel.size()), 2);
  std::vector<cv::Scalar> painted;
  for (size_t node = 0; node < plane.pixel.size(); ++node) {
    places.row(Eigen::Index(node)) << plane.pixel[node].x, -plane.pixel[node].y;
    painted.emplace_back(image.at<cv::Vec3b>(plane.pixel[node]));
  }
  return write(
      folder, std::string("plane_") + variant.name,
      panelRow({drawPoints(places, 1.0, painted), drawEmbedding(map.vectors, 0, branch),
                drawEmbedding(map.vectors, 3, branch), drawPoints(places, 1.0, colorsOf(branch))},
               {"test image", "dimensions 1-3", "dimensions 4-6",
                std::string("branches, ") + variant.name}));
}

/// Voxels in a horizontal view along an axis (0: x, 1: y), the nearest on top.
cv::Mat drawVoxels(const VoxelGraph& voxels, const std::vector<int>& branch, int along) {
  std::vector<size_t> order(voxels.centers.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return voxels.centers[a][along] < voxels.centers[b][along];
  });
  Eigen::MatrixXd places(Eigen::Index(order.size()), 2);
  std::vector<cv::Scalar> colors;
  for (size_t i = 0; i < order.size(); ++i) {
    const Eigen::Vector3d& center = voxels.centers[order[i]];
    places.row(Eigen::Index(i)) << (along == 0 ? center.y() : -center.x()), center.z();
    colors.push_back(branchColor(branch[order[i]]));
  }
  return drawPoints(places, 0.7 * voxels.pitch, colors);
}

cv::Mat drawHull(const VoxelGraph& voxels, const Eigenmap& map, const std::vector<int>& branch,
                 const std::string& name) {
  return panelRow({drawEmbedding(map.vectors, 0, branch), drawEmbedding(map.vectors, 3, branch),
                   drawVoxels(voxels, branch, 0), drawVoxels(voxels, branch, 1)},
                  {"dimensions 1-3", "dimensions 4-6", name + ", along x", "along y"});
}

/// Data of one hull, used to align the eigenmap of the next one.
struct Embedded {
  VoxelGraph voxels;
  Eigenmap map;
};

Embedded embed(const VisualHull& hull, const Variant& variant,
               const std::optional<Embedded>& previous) {
  Embedded now{buildVoxelGraph(hull, variant.color, variant.shrink ? kHullShrink : 0.0), {}};
  now.map = laplacianEigenmap(now.voxels.graph, kModes);
  if (previous) alignEigenmap(previous->voxels.graph, previous->map, now.voxels.graph, &now.map);
  return now;
}

/// Parts of the merge tree; the torso is 0.
std::vector<int> mergeTreeParts(const VisualHull& hull, const VoxelGraph& voxels) {
  const BodyParts parts = BodySegmenter(SegmentationOptions()).segment(hull);
  std::vector<int> part;
  for (const uint32_t voxel : voxels.hull_voxel) part.push_back(parts.labels[voxel]);
  return part;
}

std::vector<std::string> drawHulls(const std::string& folder,
                                   const std::vector<VisualHull>& hulls) {
  std::vector<std::string> files;
  for (const Variant& variant : kHullVariants) {
    std::optional<Embedded> last;
    for (size_t i = 0; i < hulls.size(); ++i) {
      last = embed(hulls[i], variant, last);
      const auto draw = [&](const std::string& name, const std::vector<int>& branch) {
        files.push_back(write(folder, "hull_" + name + "_" + std::to_string(i),
                              drawHull(last->voxels, last->map, branch, name)));
      };
      draw(variant.name, branchOfNodes(splinePropagationBranches(last->map, variant.stop, kLimbs),
                                       last->voxels.graph.nodeCount()));
      if (!variant.shrink) draw("merge_tree", mergeTreeParts(hulls[i], last->voxels));
    }
  }
  return files;
}

}  // namespace

std::vector<VisualHull> hullsOf(const EigenmapFigureOptions& what) {
  rosbag::Bag bag;
  openForReading(what.input, bag);
  const VoxelGrid grid =
      firstMessage<VoxelGrid>(bag, std::filesystem::path(what.topic).parent_path() / "grid");
  std::vector<VisualHull> hulls;
  std::optional<ros::Time> first;
  for (const rosbag::MessageInstance& entry : rosbag::View(bag, rosbag::TopicQuery(what.topic))) {
    const auto cloud = entry.instantiate<sensor_msgs::PointCloud2>();
    if (!cloud || int(hulls.size()) == what.frame_sets) continue;
    if (!first) first = cloud->header.stamp;
    if ((cloud->header.stamp - *first).toSec() < what.at) continue;
    VisualHull hull = hullFromMessage(*cloud, grid);
    if (!hull.voxels.empty()) hulls.push_back(std::move(hull));
  }
  if (hulls.empty())
    throw std::runtime_error("the bag has no hull with voxels on " + what.topic +
                             (what.at > 0 ? " from that time on" : ""));
  return hulls;
}

std::vector<std::string> drawEigenmapFigures(const EigenmapFigureOptions& what) {
  std::error_code error;
  std::filesystem::create_directories(what.folder, error);
  if (error) throw std::runtime_error("cannot make the folder " + what.folder);
  std::vector<std::string> files;
  for (const Variant& variant : kPlaneVariants) files.push_back(drawPlane(what.folder, variant));
  if (what.input.empty()) return files;
  for (std::string& file : drawHulls(what.folder, hullsOf(what))) files.push_back(std::move(file));
  return files;
}

}  // namespace markerless_mocap
