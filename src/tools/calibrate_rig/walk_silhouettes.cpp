#include "tools/calibrate_rig/walk_silhouettes.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "markerless_mocap/silhouette/recording_learner.h"
#include "markerless_mocap/silhouette/silhouette_extractor.h"
#include "tools/common/bags_in_threads.h"

namespace markerless_mocap {
namespace {

constexpr int kMostSets = 80;
constexpr int kMostImages = 600;  // of a film

struct TimedSilhouette {
  double time;  ///< s
  std::vector<uchar> png;
};

/// What is seen by one camera.
struct CameraWalk {
  const FilmSource* film = nullptr;
  std::vector<TimedSilhouette> silhouettes;
};

SharedBackground backgroundOf(const FilmSource& source, const SilhouetteOptions& options) {
  const std::unique_ptr<ImageFilm> film = openFilm(source);
  std::vector<RecordingLearner> learners;
  learners.emplace_back(options, film->count());
  for (bool more = true; more;) {
    if (!learners[0].wantsNext()) {
      more = film->skip().has_value();
      if (more) learners[0].add({});
      continue;
    }
    const TimedImage frame = film->next();
    more = !frame.image.empty();
    if (more) learners[0].add(frame.image);
  }
  return learnBackgrounds(learners)[0];
}

void checkSize(const cv::Mat& image, const CameraToCalibrate& camera) {
  if (image.cols != camera.width || image.rows != camera.height)
    throw std::runtime_error("the walk's images of " + camera.name + " are " +
                             std::to_string(image.cols) + " x " + std::to_string(image.rows) +
                             " pixels, those of the board " + std::to_string(camera.width) + " x " +
                             std::to_string(camera.height));
}

std::vector<TimedSilhouette> silhouettesIn(const FilmSource& source,
                                           const CameraToCalibrate& camera, double offset) {
  SilhouetteOptions options;
  options.background = "recording";  // films that are short have no images to spare
  SilhouetteExtractor extractor(options);
  extractor.useBackground(backgroundOf(source, options));
  const std::unique_ptr<ImageFilm> film = openFilm(source);
  const int every = 1 + film->count() / kMostImages;
  std::vector<TimedSilhouette> silhouettes;
  for (TimedImage frame = film->next(); !frame.image.empty(); frame = film->next()) {
    checkSize(frame.image, camera);
    const SilhouetteResult result = extractor.update(frame.image);
    silhouettes.push_back({frame.time + offset, {}});
    cv::imencode(".png", result.mask, silhouettes.back().png);
    for (int i = 1; i < every; ++i) film->skip();
  }
  return silhouettes;
}

const TimedSilhouette* nearestIn(const std::vector<TimedSilhouette>& silhouettes, double time) {
  const auto after = std::lower_bound(
      silhouettes.begin(), silhouettes.end(), time,
      [](const TimedSilhouette& silhouette, double t) { return silhouette.time < t; });
  if (after == silhouettes.begin()) return silhouettes.empty() ? nullptr : &*after;
  if (after == silhouettes.end() || time - (after - 1)->time < after->time - time)
    return &after[-1];
  return &*after;
}

/// The camera with fewest silhouettes.
const CameraWalk& slowestOf(const std::vector<CameraWalk>& walks) {
  const CameraWalk* slowest = nullptr;
  for (const CameraWalk& walk : walks)
    if (walk.film && (!slowest || walk.silhouettes.size() < slowest->silhouettes.size()))
      slowest = &walk;
  return *slowest;
}

std::vector<SilhouetteSet> joined(const std::vector<CameraWalk>& walks) {
  const std::vector<TimedSilhouette>& slowest = slowestOf(walks).silhouettes;
  std::vector<SilhouetteSet> sets;
  if (slowest.size() < 2) return sets;
  const double interval = (slowest.back().time - slowest.front().time) / double(slowest.size() - 1);
  const size_t every = 1 + slowest.size() / kMostSets;
  for (size_t k = 0; k < slowest.size(); k += every) {
    SilhouetteSet set(walks.size());
    for (size_t i = 0; i < walks.size(); ++i) {
      const TimedSilhouette* nearest = nearestIn(walks[i].silhouettes, slowest[k].time);
      if (nearest && std::abs(nearest->time - slowest[k].time) <= interval / 2)
        set[i] = cv::imdecode(nearest->png, cv::IMREAD_GRAYSCALE);
    }
    sets.push_back(std::move(set));
  }
  return sets;
}

}  // namespace

std::vector<SilhouetteSet> walkSilhouettes(const std::vector<FilmSource>& films,
                                           const std::vector<CameraToCalibrate>& cameras,
                                           const std::vector<double>& offsets, bool of_board) {
  std::vector<CameraWalk> walks(cameras.size());
  int found = 0;
  for (size_t i = 0; i < cameras.size(); ++i)
    for (const FilmSource& film : films)
      if (film.camera == cameras[i].name) {
        walks[i].film = &film;
        ++found;
      }
  if (found < 2)
    throw std::runtime_error("the walk needs films of two cameras or more, it has those of " +
                             std::to_string(found) + ": films are named after their cameras");
  const BagsInThreads bags;
  tbb::parallel_for(size_t(0), walks.size(), [&](size_t i) {
    if (!walks[i].film) return;
    const bool known = of_board || !walks[i].film->topic.empty();
    const double offset = known ? offsets[i] : 0.0;
    walks[i].silhouettes = silhouettesIn(*walks[i].film, cameras[i], offset);
  });
  return joined(walks);
}

}  // namespace markerless_mocap
