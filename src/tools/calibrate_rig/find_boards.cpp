#include "tools/calibrate_rig/find_boards.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "tools/common/bags_in_threads.h"

namespace markerless_mocap {
namespace {

/// The part that is done of several films that are read side by side.
class SharedProgress {
 public:
  SharedProgress(size_t films, const std::function<void(double)>& show)
      : parts_(films, 0.0), show_(show) {}
  void update(size_t film, double part) {
    if (!show_) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    parts_[film] = std::min(1.0, part);
    double sum = 0;
    for (const double one : parts_) sum += one;
    show_(sum / double(parts_.size()));
  }

 private:
  std::mutex mutex_;
  std::vector<double> parts_;
  const std::function<void(double)>& show_;
};

/// Views of one camera.
struct FilmBoards {
  CameraToCalibrate camera;
  std::vector<BoardView> views;
  int images = 0;
  std::vector<double> times;
};

/// Which images of a film are searched.
struct Wanted {
  size_t every = 1;                              ///< without numbers
  const std::vector<size_t>* numbers = nullptr;  ///< ascending
  bool thorough = false;

  bool has(size_t number) const {
    return numbers ? std::binary_search(numbers->begin(), numbers->end(), number)
                   : number % every == 0;
  }
};

Wanted evenly(const FilmSource& source, int most_images) {
  constexpr int kFew = 30;  // images that are worth a longer search
  const int count = openFilm(source)->count();
  return {size_t(std::max(1, (count + most_images - 1) / most_images)), nullptr,
          count > 0 && std::min(count, most_images) <= kFew};
}

void checkSize(const cv::Mat& image, CameraToCalibrate* camera) {
  if (camera->width == 0) {
    camera->width = image.cols;
    camera->height = image.rows;
  }
  if (image.cols != camera->width || image.rows != camera->height)
    throw std::runtime_error("the images of " + camera->name + " change their size from " +
                             std::to_string(camera->width) + " x " +
                             std::to_string(camera->height) + " to " + std::to_string(image.cols) +
                             " x " + std::to_string(image.rows));
}

double timeOf(double own_time, size_t number, const FrameTimes& times, const std::string& camera) {
  const auto own = times.find(camera);
  if (own == times.end()) return own_time;
  if (number >= own->second.size())
    throw std::runtime_error("the film of " + camera +
                             " has more images than the table has times, " +
                             std::to_string(own->second.size()));
  return own->second[number];
}

FilmBoards searchFilm(const BoardDetector& detector, const FilmSource& source, const Wanted& wanted,
                      const FrameTimes& times, const std::function<void(double)>& progress) {
  const std::unique_ptr<ImageFilm> film = openFilm(source);
  FilmBoards found;
  found.camera.name = source.camera;
  std::optional<BoardCorners> before;
  for (size_t number = 0;; ++number) {
    if (!wanted.has(number)) {
      const auto passed = film->skip();
      if (!passed) break;
      found.times.push_back(timeOf(*passed, number, times, source.camera));
      continue;
    }
    const TimedImage frame = film->next();
    if (frame.image.empty()) break;
    found.times.push_back(timeOf(frame.time, number, times, source.camera));
    checkSize(frame.image, &found.camera);
    ++found.images;
    before = detector.detect(frame.image, wanted.thorough, before ? &*before : nullptr);
    if (before) found.views.push_back({0, found.times.back(), false, *before});
    progress(double(number + 1) / std::max(1, film->count()));
  }
  if (found.times.empty()) throw std::runtime_error("there are no images in " + source.path);
  return found;
}

FoundBoards searchFilms(const BoardDetector& detector, const std::vector<FilmSource>& films,
                        const std::vector<Wanted>& wanted, const FrameTimes& times,
                        const std::function<void(double)>& progress) {
  std::vector<FilmBoards> found(films.size());
  SharedProgress shared(films.size(), progress);
  const BagsInThreads bags;
  tbb::parallel_for(size_t(0), films.size(), [&](size_t i) {
    found[i] = searchFilm(detector, films[i], wanted[i], times,
                          [&](double part) { shared.update(i, part); });
  });
  FoundBoards all;
  for (size_t i = 0; i < films.size(); ++i) {
    all.cameras.push_back(found[i].camera);
    all.images.push_back(found[i].images);
    all.times.push_back(std::move(found[i].times));
    for (BoardView& view : found[i].views) {
      view.camera = i;
      all.views.push_back(std::move(view));
    }
  }
  return all;
}

}  // namespace

FoundBoards findBoards(const BoardDetector& detector, const std::vector<FilmSource>& films,
                       int most_images, const FrameTimes& times,
                       const std::function<void(double)>& progress) {
  std::vector<Wanted> wanted;
  for (const FilmSource& film : films) wanted.push_back(evenly(film, most_images));
  return searchFilms(detector, films, wanted, times, progress);
}

FoundBoards findBoardsIn(const BoardDetector& detector, const std::vector<FilmSource>& films,
                         const std::vector<std::vector<size_t>>& numbers, const FrameTimes& times,
                         const std::function<void(double)>& progress) {
  std::vector<Wanted> wanted(films.size());
  for (size_t i = 0; i < films.size(); ++i) wanted[i].numbers = &numbers[i];
  return searchFilms(detector, films, wanted, times, progress);
}

std::vector<cv::Mat> imagesOf(const FilmSource& source, int images) {
  const std::unique_ptr<ImageFilm> film = openFilm(source);
  const int every = std::max(1, film->count() / std::max(1, images));
  std::vector<cv::Mat> found;
  for (int number = 0; int(found.size()) < images; ++number) {
    if (number % every != 0) {
      if (!film->skip()) break;
      continue;
    }
    found.push_back(film->next().image.clone());
    if (found.back().empty()) {
      found.pop_back();
      break;
    }
  }
  return found;
}

void addLensPictures(const FoundBoards& pictures, FoundBoards* boards) {
  for (const BoardView& view : pictures.views) {
    const CameraToCalibrate& of = pictures.cameras[view.camera];
    const auto camera =
        std::find_if(boards->cameras.begin(), boards->cameras.end(),
                     [&](const CameraToCalibrate& one) { return one.name == of.name; });
    if (camera == boards->cameras.end())
      throw std::runtime_error("there are lens pictures of " + of.name +
                               ", which is none of the cameras");
    if (camera->width != of.width || camera->height != of.height)
      throw std::runtime_error("the lens pictures of " + of.name + " are " +
                               std::to_string(of.width) + " x " + std::to_string(of.height) +
                               " pixels, its film is " + std::to_string(camera->width) + " x " +
                               std::to_string(camera->height));
    boards->views.push_back(view);
    boards->views.back().camera = size_t(camera - boards->cameras.begin());
    boards->views.back().alone = true;
  }
}

}  // namespace markerless_mocap
