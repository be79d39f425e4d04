#include "tools/import/person_starts.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <opencv2/imgproc.hpp>

#include "checks/film_starts.h"
#include "markerless_mocap/products/silhouette_mask.h"
#include "markerless_mocap/silhouette/recording_learner.h"
#include "markerless_mocap/silhouette/silhouette_extractor.h"
#include "ros/rig_recorder.h"
#include "text/joined.h"

namespace markerless_mocap {
namespace {

constexpr double kRate = 12.0;      // images per second in which the person is looked for
constexpr double kTogether = 0.02;  // s, or half an image: what is less is no offset

size_t strideOf(const Film& film) {
  return size_t(std::max(1.0, std::floor(film.fps() / kRate)));
}

template <class... Args>
std::string text(const char* format, Args... args) {
  char buffer[500];
  std::snprintf(buffer, sizeof buffer, format, args...);
  return buffer;
}

/// The part of several films that is done, each read twice.
class FilmsProgress {
 public:
  FilmsProgress(const std::vector<Film>& films, const std::function<void(double)>& show)
      : show_(show) {
    for (const Film& film : films) all_ += 2 * std::max(film.frames(), 1);
  }
  void readOne() {
    const std::lock_guard<std::mutex> lock(mutex_);
    show_(std::min(1.0, double(++done_) / all_));
  }

 private:
  const std::function<void(double)>& show_;
  std::mutex mutex_;
  int all_ = 0, done_ = 0;
};

SharedBackground backgroundOf(const Film& source, const SilhouetteOptions& options,
                              FilmsProgress* progress) {
  std::vector<RecordingLearner> learners;
  learners.emplace_back(options, source.frames());
  Film film = source.again();
  for (bool more = true; more; progress->readOne()) {
    if (!learners[0].wantsNext()) {
      more = film.skip();
      if (more) learners[0].add({});
      continue;
    }
    const auto frame = film.next();
    more = frame.has_value();
    if (more) learners[0].add(checkedSize(frame->image));
  }
  return learnBackgrounds(learners)[0];
}

cv::Mat storedMask(const cv::Mat& image) {
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return maskOfThreeValues(grey);
}

FilmedPerson personIn(const Film& source, const CameraCalibration& camera,
                      FilmsProgress* progress) {
  SilhouetteOptions options;
  options.background = "recording";  // films that are short have no images to spare
  Film film = source.again();
  SilhouetteExtractor extractor(options);
  FilmedPerson person;
  person.calibration = camera;
  bool has_masks = false;
  for (auto frame = film.next(); frame; frame = film.next()) {
    if (person.seconds.empty()) {
      has_masks = !frame->mask.empty();
      if (!has_masks) extractor.useBackground(backgroundOf(source, options, progress));
    }
    const cv::Mat mask =
        has_masks ? storedMask(frame->mask) : extractor.update(checkedSize(frame->image)).mask;
    person.seconds.push_back(frame->time);
    person.outlines.push_back(outlineOf(mask, camera.width, camera.height));
    progress->readOne();
    for (size_t k = 1; k < strideOf(film); ++k) {
      film.skip();
      progress->readOne();
    }
  }
  return person;
}

std::vector<std::string> foundStarts(const std::vector<CameraCalibration>& cameras,
                                     const std::vector<double>& offsets) {
  const auto first = std::min_element(offsets.begin(), offsets.end());
  const std::string& first_name = cameras[size_t(first - offsets.begin())].name;
  std::vector<std::string> notes;
  for (size_t i = 0; i < cameras.size(); ++i)
    if (&offsets[i] != &*first)
      notes.push_back(
          text("the film of %s began %.3f s after that of %s, by the motion of the "
               "person (--synchronised: they began together)",
               cameras[i].name.c_str(), offsets[i] - *first, first_name.c_str()));
  return notes;
}

std::string uncertain(const std::vector<CameraCalibration>& cameras, const FilmClocks& clocks,
                      const std::string& consequence) {
  std::string names;
  for (size_t i = 0; i < cameras.size(); ++i)
    if (!(clocks.certainty[i] >= kCertainOffset)) addWord(&names, cameras[i].name);
  return "when the film of " + names +
         " began is not certain by the motion of the person, who should walk through the room, at "
         "no even pace: " +
         consequence;
}

bool areTogether(const std::vector<double>& offsets, const std::vector<Film>& films) {
  double least = kTogether;
  for (const Film& film : films) least = std::max(least, 0.5 / std::max(film.fps(), 1.0));
  const auto [low, high] = std::minmax_element(offsets.begin(), offsets.end());
  return *high - *low < 2 * least;
}

bool allFound(const FilmClocks& clocks) {
  return std::all_of(clocks.offsets.begin(), clocks.offsets.end(),
                     [](double offset) { return std::isfinite(offset); });
}

}  // namespace

std::vector<std::string> findPersonStarts(const std::vector<Film>& films,
                                          const std::vector<CameraCalibration>& cameras,
                                          const FilmsInput& input, std::vector<double>* offsets,
                                          const std::function<void(double)>& progress) {
  if (films.size() < 2) return {};
  std::vector<FilmedPerson> persons(films.size());
  FilmsProgress shared(films, progress);
  tbb::parallel_for(size_t(0), films.size(),
                    [&](size_t i) { persons[i] = personIn(films[i], cameras[i], &shared); });
  const FilmClocks clocks = personClocks(persons, input.largest_offset);
  if (clocks.certain()) {
    if (areTogether(clocks.offsets, films)) return {};
    *offsets = clocks.offsets;
    return foundStarts(cameras, *offsets);
  }
  if (input.start == FilmStart::kApart && allFound(clocks)) {
    *offsets = clocks.offsets;
    std::vector<std::string> notes = foundStarts(cameras, *offsets);
    notes.push_back(uncertain(cameras, clocks,
                              "check the bag (check_recording), or give times "
                              "(--times)"));
    return notes;
  }
  return {uncertain(cameras, clocks,
                    "the films are taken to have begun together; if they did not, give times "
                    "(--times, or time_offset in the rig file)")};
}

}  // namespace markerless_mocap
