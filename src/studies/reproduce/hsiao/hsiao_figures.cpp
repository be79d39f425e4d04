#include "studies/reproduce/hsiao/hsiao_figures.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "segmentation/eigenmap.h"
#include "segmentation/spline_propagation.h"
#include "segmentation/voxel_graph.h"
#include "studies/reproduce/hsiao/embedding_drawing.h"
#include "studies/reproduce/hsiao/hsiao_strip.h"
#include "studies/reproduce/hsiao/plane_figure.h"

namespace markerless_mocap {
namespace {

constexpr int kModes = 6, kLimbs = 5, kQuality = 88;
const Overrides kQuickFit = {{"pose_fitting/hsiao/particles_per_parameter", "0.5"},
                             {"pose_fitting/hsiao/iterations_per_parameter", "0.5"},
                             {"pose_fitting/hsiao/fine_tune_iterations", "1"}};

std::vector<cv::Scalar> colorsOf(const std::vector<int>& branch) {
  std::vector<cv::Scalar> colors;
  for (const int b : branch) colors.push_back(branchColor(b));
  return colors;
}

cv::Mat larger(const cv::Mat& picture) {
  cv::Mat out;
  cv::resize(picture, out, {kPanel * kStripWidth / kStripHeight, kPanel}, 0, 0, cv::INTER_CUBIC);
  cv::copyMakeBorder(out, out, 0, 0, (kPanel - out.cols) / 2,
                     kPanel - out.cols - (kPanel - out.cols) / 2, cv::BORDER_CONSTANT,
                     cv::Scalar::all(255));
  return out;
}

// ---- the image

struct PlaneVariant {
  const char* name;
  SplineTermination stop;
  PixelGraphOptions weights;
};

/// Weight 2 as in the thesis.
const PlaneVariant kPlaneVariants[] = {
    {"original", SplineTermination::kOutliers, {}},
    {"modified", SplineTermination::kOrigin, {false, 2.0}},
    {"modified, colours", SplineTermination::kOrigin, {true, 2.0}}};

cv::Mat planePicture(const cv::Mat& image, const PixelGraph& plane, const Eigenmap& map,
                     const std::vector<int>& branch, const std::string& name) {
  Eigen::MatrixXd places(Eigen::Index(plane.pixel.size()), 2);
  std::vector<cv::Scalar> painted;
  for (size_t node = 0; node < plane.pixel.size(); ++node) {
    places.row(Eigen::Index(node)) << plane.pixel[node].x, -plane.pixel[node].y;
    painted.emplace_back(image.at<cv::Vec3b>(plane.pixel[node]));
  }
  return panelRow(
      {drawPoints(places, 1.0, painted), drawEmbedding(map.vectors, 0, branch),
       drawEmbedding(map.vectors, 3, branch), drawPoints(places, 1.0, colorsOf(branch))},
      {"test image", "dimensions 1-3", "dimensions 4-6", "branches, " + name});
}

// ---- hulls

struct HullVariant {
  const char* name;
  Overrides changes;
};
const HullVariant kOriginal = {"original",
                               {{"body_segmentation/walk_stop", "outliers"},
                                {"body_segmentation/shrink_weight", "0"},
                                {"body_segmentation/use_color_votes", "false"}}};
const HullVariant kModified = {"modified", {}};

/// Embedding and branches of a hull, as in Figures 3-10 and 3-15.
cv::Mat embeddingPicture(const VisualHull& hull, const BodyView& view, const HullVariant& variant) {
  const SegmentationOptions options = publishedHsiao(1.75, variant.changes).segmentation;
  const VoxelGraph voxels = buildVoxelGraph(hull, edgeWeightsOf(options));
  const Eigenmap map = laplacianEigenmap(voxels.graph, kModes);
  const SplineTermination stop =
      options.walk_stop == "outliers" ? SplineTermination::kOutliers : SplineTermination::kOrigin;
  const std::vector<int> branch = branchOfNodes(
      splinePropagationBranches(map, stop, kLimbs, options.spline_walk), voxels.graph.nodeCount());
  std::vector<cv::Scalar> colors(hull.voxels.size(), branchColor(0));
  for (size_t node = 0; node < branch.size(); ++node)
    colors[voxels.hull_voxel[node]] = branchColor(branch[node]);
  cv::Mat space = view.paper();
  drawVoxels(view, hull, colors, &space);
  return panelRow(
      {drawEmbedding(map.vectors, 0, branch), drawEmbedding(map.vectors, 3, branch), larger(space)},
      {std::string(variant.name) + ", dimensions 1-3", "dimensions 4-6", "branches"});
}

VisualHull hullOf(const HsiaoFilm& film, const PipelineResult& now,
                  const std::vector<size_t>& cameras) {
  CameraRig rig;
  std::vector<HullView> views;
  for (const size_t c : cameras) {
    rig.push_back(film.rig()[c]);
    views.push_back({now.masks[c], film.frameSet().frames[c].image});
  }
  return HullCarver(rig, film.options().hull).carve(views);
}

/// Figure 3-8 e: what four cameras add.
cv::Mat superposition(const BodyView& view, const VisualHull& four, const VisualHull& eight) {
  std::vector<cv::Scalar> colors;
  for (const HullVoxel& voxel : four.voxels) {
    const bool both = std::binary_search(
        eight.voxels.begin(), eight.voxels.end(), voxel,
        [](const HullVoxel& a, const HullVoxel& b) { return a.index < b.index; });
    colors.push_back(both ? cv::Scalar(60, 215, 245) : cv::Scalar(225, 110, 40));
  }
  cv::Mat picture = view.paper();
  drawVoxels(view, four, colors, &picture);
  return picture;
}

std::vector<cv::Mat> imagesOf(const HsiaoFilm& film, const PipelineResult& now) {
  std::vector<cv::Mat> images;
  for (size_t c = 0; c < film.rig().size(); ++c)
    images.push_back(personImage(film.rig()[c], film.frameSet().frames[c].image, now.hull));
  return images;
}

Json curveJson(const PartCurve& curve) {
  Json out{
      {"s", curve.site_values}, {"x", Json::array()}, {"y", Json::array()}, {"z", Json::array()}};
  for (const Eigen::Vector3d& point : curve.points) {
    out["x"].push_back(point.x());
    out["y"].push_back(point.y());
    out["z"].push_back(point.z());
  }
  return out;
}

Json figuresOf(const HsiaoFilm& film, const PipelineResult& now) {
  const Camera& camera = film.rig().front();
  const BodyView view = viewOf(now.hull, camera);
  const VisualHull four = hullOf(film, now, {0, 2, 4, 6});
  const auto jpeg = [](const cv::Mat& picture) { return packedJpeg(picture, kQuality); };
  return {{"3-7", jpeg(joined({imagesOf(film, now)}, {}))},
          {"3-7 hull", jpeg(joined({{hullPicture(view, now.hull),
                                     hullPicture(viewOf(now.hull, film.rig()[2]), now.hull)}},
                                   {"along camera 0", "along camera 2"}))},
          {"3-8", jpeg(joined({{hullPicture(view, now.hull), hullPicture(view, four),
                                superposition(view, four, now.hull)}},
                              {"eight cameras", "four cameras", "blue: only four"}))},
          {"3-10", jpeg(embeddingPicture(now.hull, view, kOriginal))},
          {"3-15", jpeg(embeddingPicture(now.hull, view, kModified))}};
}

int partsSeen(const BodyParts& parts) {
  return int(std::count_if(parts.parts.begin(), parts.parts.end(),
                           [](const PartCurve& part) { return part.seen; }));
}

/// Figure 3-16: "3-16", a picture, and "site_values", the curves of the torso and of an arm.
Json skeletonFigure(const HsiaoFilm& film, const PipelineResult& now) {
  const Camera& camera = film.rig().front();
  const BodyView view = viewOf(now.hull, camera);
  PipelineResult only_parts;
  only_parts.parts = now.parts;
  const PartCurve& first_arm = now.parts.part(PartLabel::kArm1);
  const PartCurve& arm = first_arm.seen ? first_arm : now.parts.part(PartLabel::kArm2);
  const cv::Mat picture =
      joined({{personImage(camera, film.frameSet().frames.front().image, now.hull),
               partsPicture(view, now.hull, now.parts), curvesPicture(view, only_parts)}},
             {"image", "parts", "curves"});
  return {{"3-16", packedJpeg(picture, kQuality)},
          {"site_values",
           {{"torso", curveJson(now.parts.part(PartLabel::kTorso))}, {"arm", curveJson(arm)}}}};
}

}  // namespace

Json planeFigures() {
  const cv::Mat image = testImage();
  const cv::Point top_of_head(44, 7);
  Json out = Json::object();
  for (const PlaneVariant& variant : kPlaneVariants) {
    const PixelGraph plane = pixelGraph(image, variant.weights);
    const Eigenmap map = laplacianEigenmap(plane.graph, kModes);
    SplineWalkOptions walk;
    walk.stop_radius = 0.3;
    const std::vector<int> branch = branchOfNodes(
        splinePropagationBranches(map, variant.stop, kLimbs, walk), plane.pixel.size());
    out[variant.name] = packedJpeg(planePicture(image, plane, map, branch, variant.name), kQuality);
    for (size_t node = 0; node < plane.pixel.size(); ++node)
      if (plane.pixel[node] == top_of_head) out["head"][variant.name] = branch[node] > 0;
  }
  return out;
}

Json hullFigures(const Capture& capture) {
  const HsiaoTruth truth = hsiaoTruth(capture);
  HsiaoFilm film(capture, truth, kQuickFit);
  double litres_8 = 0.0, litres_4 = 0.0;
  size_t frames = 0;
  int most_parts = 0;
  Json out, skeleton;
  while (const auto now = film.next()) {
    litres_8 += now->hull.litres();
    litres_4 += hullOf(film, *now, {0, 2, 4, 6}).litres();
    if (frames++ == truth.points.frames() / 2) out = figuresOf(film, *now);
    if (partsSeen(now->parts) <= most_parts) continue;
    most_parts = partsSeen(now->parts);
    skeleton = skeletonFigure(film, *now);
  }
  out.update(skeleton);
  out["litres_8"] = litres_8 / double(frames);
  out["litres_4"] = litres_4 / double(frames);
  return out;
}

Json laboratoryFigure(const Capture& capture) {
  const HsiaoTruth truth = hsiaoTruth(capture);
  HsiaoFilm film(capture, truth, kQuickFit);
  double litres = 0.0;
  size_t frames = 0;
  Json out;
  while (const auto now = film.next()) {
    litres += now->hull.litres();
    if (frames++ != truth.points.frames() / 2) continue;
    std::vector<cv::Mat> row = imagesOf(film, *now);
    row.push_back(hullPicture(viewOf(now->hull, film.rig().front()), now->hull));
    row.push_back(hullPicture(viewOf(now->hull, film.rig()[1]), now->hull));
    out["images"] = packedJpeg(joined({row}, {}), kQuality);
  }
  out["litres"] = litres / double(frames);
  return out;
}

Json hullVolume(const Capture& capture) {
  const HsiaoTruth truth = hsiaoTruth(capture);
  HsiaoFilm film(capture, truth, kQuickFit);
  double litres = 0.0;
  size_t frames = 0;
  for (; const auto now = film.next(); ++frames) litres += now->hull.litres();
  return {{"litres", litres / double(frames)}};
}

}  // namespace markerless_mocap
