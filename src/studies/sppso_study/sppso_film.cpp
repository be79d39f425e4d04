#include "studies/sppso_study/sppso_film.h"

#include <tbb/parallel_for.h>

#include <opencv2/imgproc.hpp>

#include "capture/truth.h"
#include "studies/common/true_parameters.h"

namespace markerless_mocap {
namespace {

constexpr int kMargin = 40;  // pixels kept around the person, more than edges reach
constexpr int kBatch = 32;   // instants in memory at a time with all their pixels

FilmedView croppedView(const cv::Mat& image, const cv::Mat& mask) {
  FilmedView view;
  const cv::Rect body = cv::boundingRect(mask);
  if (body.empty()) return view;
  view.part = cv::Rect(body.x - kMargin, body.y - kMargin, body.width + 2 * kMargin,
                       body.height + 2 * kMargin) &
              cv::Rect(0, 0, mask.cols, mask.rows);
  view.silhouette = mask(view.part).clone();
  cv::cvtColor(image(view.part), view.image, cv::COLOR_BGR2GRAY);
  return view;
}

FilmedFrame frameOf(const StudioInstant& instant) {
  FilmedFrame frame;
  frame.stamp_ns = instant.time_ns;
  for (size_t i = 0; i < instant.masks.size(); ++i)
    frame.views.push_back(croppedView(instant.images[i], instant.masks[i]));
  return frame;
}

Eigen::Matrix3Xd markersOf(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Matrix3Xd markers(3, Eigen::Index(markerNames().size()));
  for (Eigen::Index m = 0; m < markers.cols(); ++m) markers.col(m) = points[size_t(m)];
  return markers;
}

}  // namespace

SppsoFilm filmOf(const StudioOptions& options, const StudioFiles& files, int frames,
                 const std::function<void(int)>& progress) {
  StudioOptions studio = options;
  studio.background_frames = 0;
  const VirtualStudio stage(studio, files, "person1");
  SppsoFilm film;
  film.rig = stage.rig();
  film.body = std::make_shared<const BodyModel>(stage.body());
  film.fps = studio.fps;
  film.joints.names = markerNames();
  TrueParameters truth(*film.body);
  for (int first = 0; first < frames; first += kBatch) {
    const int count = std::min(kBatch, frames - first);
    std::vector<FilmedFrame> batch{size_t(count)};
    std::vector<StudioInstant> instants{size_t(count)};
    tbb::parallel_for(0, count, [&](int i) {
      StudioInstant& instant = instants[size_t(i)];
      instant = stage.render(first + i);
      batch[size_t(i)] = frameOf(instant);
      instant.images.clear();
      instant.silhouettes.clear();
      instant.masks.clear();
    });
    for (int i = 0; i < count; ++i) {
      batch[size_t(i)].truth = truth.follow(instants[size_t(i)].body);
      film.joints.add(batch[size_t(i)].stamp_ns, markersOf(instants[size_t(i)].points));
      film.frames.push_back(std::move(batch[size_t(i)]));
    }
    progress(first + count);
  }
  return film;
}

std::vector<AppearanceView> wholeViews(const SppsoFilm& film, size_t frame) {
  std::vector<AppearanceView> views;
  for (size_t i = 0; i < film.rig.size(); ++i) {
    const FilmedView& kept = film.frames.at(frame).views[i];
    AppearanceView view;
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
