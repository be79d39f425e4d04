#include "fleischmann/fleischmann_fitness.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "fleischmann/fitness/edge_map.h"
#include "fleischmann/fitness/edge_samples.h"
#include "fleischmann/fitness/fleischmann_cone_outlines.h"
#include "fleischmann/fitness/quad_canvas.h"
#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {

namespace {
constexpr ConeSet kAllCones = (1u << kFleischmannConeCount) - 1;
}

struct FleischmannFitness::View {
  ViewCamera camera;
  std::string name;
  cv::Size full;  ///< size of the images from the camera
  BitImage silhouette{};
  BitImage unknown{};  ///< only with has_unknown
  int64_t area = 0;
  cv::Mat edges{};
  bool shows_person = false, has_edges = false, has_unknown = false;

  void take(const FleischmannView& seen, const FleischmannImageOptions& options);
  /// Of a drawing and the silhouette; pixels whose background is unknown do not count.
  Overlap overlap(const QuadCanvas& canvas) const {
    Overlap known = canvas.overlap(silhouette);
    if (has_unknown) known.drawn -= canvas.overlap(unknown).shared;
    return known;
  }
};

struct FleischmannFitness::Cones {
  ConePlacer placer;
};

/// Canvas of one thread.
struct FleischmannFitness::Scratch {
  FleischmannFrames frames;
  FleischmannWorldCones cones;
  ConeCorners corners;
  std::array<Quad, kFleischmannConeCount> quads;
  int quad_count = 0;
  QuadCanvas canvas;

  void drawQuads(int width, int height, ConeSet cones = kAllCones) {
    quad_count = 0;
    for (int i = 0; i < kFleischmannConeCount; ++i) {
      if (!corners.seen[i] || !(cones & coneBit(FleischmannConeId(i)))) continue;
      Quad& quad = quads[quad_count++];
      for (int k = 0; k < 4; ++k) {
        quad.x[k] = corners.x[k][i];
        quad.y[k] = corners.y[k][i];
      }
    }
    if (canvas.image().width() != width || canvas.image().height() != height)
      canvas = QuadCanvas(width, height);
    canvas.draw(quads.data(), quad_count);
  }
};

namespace {

void requireFit(const FleischmannView& view, const std::string& name, const cv::Size& size) {
  if (view.silhouette.type() != CV_8UC1 || view.silhouette.size() != size)
    throw std::invalid_argument(
        "camera '" + name +
        "': the silhouette must be mono8 and of the size of the camera's image");
  if (!view.image.empty() && view.image.size() != size)
    throw std::invalid_argument("camera '" + name +
                                "': the image must have the size of the silhouette");
}

/// A pixel of the reduced mask is set if at least half of its original pixels are.
cv::Mat reducedMask(const cv::Mat& mask, const cv::Size& size, int downsampling) {
  cv::Mat small;
  const cv::Rect used(0, 0, size.width * downsampling, size.height * downsampling);
  cv::resize(mask(used) != 0, small, size, 0, 0, cv::INTER_AREA);
  return small >= 127;
}

cv::Mat reducedImage(const cv::Mat& image, const cv::Size& size, int downsampling) {
  cv::Mat small;
  const cv::Rect used(0, 0, size.width * downsampling, size.height * downsampling);
  cv::resize(image(used), small, size, 0, 0, cv::INTER_AREA);
  return small;
}

}  // namespace

void FleischmannFitness::View::take(const FleischmannView& seen,
                                    const FleischmannImageOptions& options) {
  const cv::Size size(camera.width(), camera.height());
  shows_person = has_edges = false;
  edges = cv::Mat::zeros(size, CV_8UC1);
  if (seen.silhouette.empty()) return;
  const bool whole = options.downsampling == 1;
  const auto reduced = [&](const cv::Mat& mask) {
    return whole ? mask : reducedMask(mask, size, options.downsampling);
  };
  const cv::Mat nonzero = reduced(seen.silhouette);
  silhouette = BitImage(nonzero);
  has_unknown = hasUnknownPixels(seen.silhouette);
  if (has_unknown) {
    silhouette = BitImage(reduced(personPixels(seen.silhouette)));
    unknown = BitImage(reduced(seen.silhouette == kUnknownPixel));
  }
  area = silhouette.count();
  shows_person = area >= options.min_silhouette_pixels;
  if (!shows_person || seen.image.empty()) return;
  const cv::Mat image = whole ? seen.image : reducedImage(seen.image, size, options.downsampling);
  edges = edgeMap(image, nonzero,
                  {options.edge_threshold, options.edge_dilation, options.edge_blur_sigma});
  has_edges = true;
}

FleischmannFitness::FleischmannFitness(const CameraRig& rig, const FleischmannBodyModel& body_model,
                                       const FleischmannBodyShape& body,
                                       const FleischmannImageOptions& options)
    : body_model_(body_model), options_(options), cones_(new Cones{ConePlacer(body)}) {
  options.validate();
  for (const Camera& camera : rig) {
    const ViewCamera view(camera, options.downsampling);
    views_.push_back({view, camera.name(), cv::Size(camera.width(), camera.height())});
  }
}

FleischmannFitness::~FleischmannFitness() = default;

FleischmannFitness::Scratch& FleischmannFitness::scratch() const {
  static thread_local Scratch scratch;
  return scratch;
}

void FleischmannFitness::place(const double* candidate, Scratch& scratch) const {
  body_model_.frames(candidate, scratch.frames);
  cones_->placer.place(scratch.frames, scratch.cones);
}

int FleischmannFitness::observe(const std::vector<FleischmannView>& views) {
  if (views.size() != views_.size())
    throw std::invalid_argument(std::to_string(views.size()) + " views were given, the rig has " +
                                std::to_string(views_.size()) + " cameras");
  for (size_t i = 0; i < views.size(); ++i)
    if (!views[i].silhouette.empty()) requireFit(views[i], views_[i].name, views_[i].full);
  tbb::parallel_for(size_t(0), views.size(), [&](size_t i) { views_[i].take(views[i], options_); });
  return int(std::count_if(views_.begin(), views_.end(),
                           [](const View& view) { return view.shows_person; }));
}

FitnessTerms FleischmannFitness::fitness(const double* candidate,
                                         const EdgeSelection& choice) const {
  Scratch& s = scratch();
  place(candidate, s);
  FitnessTerms sum;
  int views = 0, views_with_edges = 0;
  for (const View& view : views_) {
    if (!view.shows_person) continue;
    view.camera.outlines(s.cones, s.corners);
    s.drawQuads(view.camera.width(), view.camera.height());
    const Overlap overlap = view.overlap(s.canvas);
    if (overlap.drawn > 0)
      sum.silhouette +=
          (1.0 - options_.silhouette_weight) * double(overlap.shared) / double(overlap.drawn) +
          options_.silhouette_weight * double(overlap.shared) / double(view.area);
    ++views;
    if (!view.has_edges || choice.cones == 0) continue;
    const EdgeSum edge = edgesOf(view, s, choice);
    if (edge.points > 0) sum.edge += double(edge.sum) / (255.0 * edge.points);
    ++views_with_edges;
  }
  if (views > 0) sum.silhouette /= views;
  if (views_with_edges > 0) sum.edge /= views_with_edges;
  return sum;
}

EdgeSum FleischmannFitness::edgesOf(const View& view, const Scratch& s,
                                    const EdgeSelection& choice) const {
  if (!options_.hide_covered_edges)
    return sampleEdges(s.corners, view.edges, choice, options_.samples_per_edge);
  const HiddenPoints hidden(s.corners, s.cones, view.camera.position());
  return sampleEdges(s.corners, view.edges, choice, options_.samples_per_edge, &hidden);
}

ConeVisibility FleischmannFitness::evidence(const double* candidate, ConeSet cones) const {
  Scratch& s = scratch();
  place(candidate, s);
  ConeVisibility sum;
  for (const View& view : views_) {
    if (!view.shows_person) continue;
    view.camera.outlines(s.cones, s.corners);
    const auto overlap = [&](ConeSet drawn) {
      s.drawQuads(view.camera.width(), view.camera.height(), drawn);
      return view.overlap(s.canvas);
    };
    const Overlap all = overlap(kAllCones), others = overlap(kAllCones & ~cones);
    sum.drawn += overlap(cones).drawn;
    sum.alone += all.drawn - others.drawn;
    sum.inside += all.shared - others.shared;
  }
  return sum;
}

cv::Mat FleischmannFitness::drawing(const double* candidate, int view) const {
  Scratch& s = scratch();
  place(candidate, s);
  const ViewCamera& camera = views_.at(size_t(view)).camera;
  camera.outlines(s.cones, s.corners);
  s.drawQuads(camera.width(), camera.height());
  return s.canvas.image().mask();
}

std::vector<std::vector<cv::Point2f>> FleischmannFitness::outlines(const double* candidate,
                                                                   int view) const {
  Scratch& s = scratch();
  place(candidate, s);
  views_.at(size_t(view)).camera.outlines(s.cones, s.corners);
  std::vector<std::vector<cv::Point2f>> outlines(kFleischmannConeCount);
  for (size_t i = 0; i < outlines.size(); ++i)
    for (size_t k = 0; k < 4 && s.corners.seen[i]; ++k)
      outlines[i].emplace_back(s.corners.x[k][i], s.corners.y[k][i]);
  return outlines;
}

const cv::Mat& FleischmannFitness::edges(int view) const {
  return views_.at(size_t(view)).edges;
}

}  // namespace markerless_mocap
