#include "studies/sppso_study/fleischmann_sequence.h"

#include <tbb/parallel_for.h>

#include <opencv2/imgproc.hpp>

#include "capture/ground_truth.h"
#include "studies/common/true_parameters.h"

namespace markerless_mocap {
namespace {

constexpr int kMargin = 40;  // pixels around the person, more than the range of edges
constexpr int kBatch = 32;   // frame sets in memory at full size at the same time

CroppedView croppedView(const cv::Mat& image, const cv::Mat& mask) {
  CroppedView view;
  const cv::Rect body = cv::boundingRect(mask);
  if (body.empty()) return view;
  view.part = cv::Rect(body.x - kMargin, body.y - kMargin, body.width + 2 * kMargin,
                       body.height + 2 * kMargin) &
              cv::Rect(0, 0, mask.cols, mask.rows);
  view.silhouette = mask(view.part).clone();
  cv::cvtColor(image(view.part), view.image, cv::COLOR_BGR2GRAY);
  return view;
}

SequenceFrame frameOf(const StudioFrameSet& frame_set) {
  SequenceFrame frame;
  frame.stamp_ns = frame_set.time_ns;
  for (size_t i = 0; i < frame_set.masks.size(); ++i)
    frame.views.push_back(croppedView(frame_set.images[i], frame_set.masks[i]));
  return frame;
}

Eigen::Matrix3Xd markersOf(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Matrix3Xd markers(3, Eigen::Index(markerNames().size()));
  for (Eigen::Index m = 0; m < markers.cols(); ++m) markers.col(m) = points[size_t(m)];
  return markers;
}

}  // namespace

FleischmannSequence filmOf(const StudioOptions& options, const StudioFiles& files, int frames,
                           const std::function<void(int)>& progress) {
  StudioOptions studio = options;
  studio.background_frames = 0;
  const VirtualStudio stage(studio, files, "person1");
  FleischmannSequence film;
  film.rig = stage.rig();
  film.body = std::make_shared<const BodyModel>(stage.body());
  film.fps = studio.fps;
  film.joints.names = markerNames();
  TrueParameters truth(*film.body);
  for (int first = 0; first < frames; first += kBatch) {
    const int count = std::min(kBatch, frames - first);
    std::vector<SequenceFrame> batch{size_t(count)};
    std::vector<StudioFrameSet> frame_sets{size_t(count)};
    tbb::parallel_for(0, count, [&](int i) {
      StudioFrameSet& frame_set = frame_sets[size_t(i)];
      frame_set = stage.render(first + i);
      batch[size_t(i)] = frameOf(frame_set);
      frame_set.images.clear();
      frame_set.silhouettes.clear();
      frame_set.masks.clear();
    });
    for (int i = 0; i < count; ++i) {
      batch[size_t(i)].truth = truth.follow(frame_sets[size_t(i)].body);
      film.joints.add(batch[size_t(i)].stamp_ns, markersOf(frame_sets[size_t(i)].points));
      film.frames.push_back(std::move(batch[size_t(i)]));
    }
    progress(first + count);
  }
  return film;
}

std::vector<FleischmannView> wholeViews(const FleischmannSequence& film, size_t frame) {
  std::vector<FleischmannView> views;
  for (size_t i = 0; i < film.rig.size(); ++i) {
    const CroppedView& kept = film.frames.at(frame).views[i];
    FleischmannView view;
    view.silhouette = cv::Mat::zeros(film.rig[i].height(), film.rig[i].width(), CV_8UC1);
    view.image = view.silhouette.clone();
    if (!kept.part.empty()) {
      kept.silhouette.copyTo(view.silhouette(kept.part));
      kept.image.copyTo(view.image(kept.part));
    }
    views.push_back(view);
  }
  return views;
}

}  // namespace markerless_mocap
