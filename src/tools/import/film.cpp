#include "tools/import/film.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <stdexcept>

#include "files/text_file.h"
#include "numerics/order_statistics.h"
#include "tools/common/film_files.h"

namespace markerless_mocap {

namespace fs = std::filesystem;

struct Film::Source {
  cv::VideoCapture video;
  std::vector<fs::path> images;

  explicit Source(const fs::path& path) {
    if (fs::is_directory(path)) {
      images = entriesOf(path, isPicture);
      return;
    }
    checkRegularFile(path.string(), "the film " + path.string(),
                     std::numeric_limits<uintmax_t>::max());
    video.open(path.string());
  }
  double time() const { return 1e-3 * video.get(cv::CAP_PROP_POS_MSEC); }
  bool skip(size_t index) { return images.empty() ? video.grab() : index < images.size(); }
  cv::Mat read(size_t index) {
    cv::Mat image;
    if (images.empty())
      video.read(image);
    else if (index < images.size()) {
      image = cv::imread(images[index].string(), cv::IMREAD_COLOR);
      if (image.empty())
        throw std::runtime_error("cannot read the image " + images[index].string());
    }
    return image;
  }
};

Film::Film(const std::string& path, double fps)
    : path_(path), source_(std::make_unique<Source>(path)) {
  const bool video = source_->images.empty();
  if (video && !source_->video.isOpened()) throw std::runtime_error("cannot read the film " + path);
  fps_ = video ? source_->video.get(cv::CAP_PROP_FPS) : fps;
  Source beginning(path);
  const cv::Mat first = beginning.read(0);
  if (first.empty()) throw std::runtime_error("the film " + path + " has no frames");
  size_ = first.size();
  start_ = video ? beginning.time() : 0.0;
}

Film::~Film() = default;
Film::Film(Film&&) noexcept = default;

int Film::frames() const {
  if (!source_->images.empty()) return int(source_->images.size());
  return std::max(0, int(source_->video.get(cv::CAP_PROP_FRAME_COUNT)));
}

int Film::turned() const {
  return source_->images.empty() ? int(source_->video.get(cv::CAP_PROP_ORIENTATION_META)) : 0;
}

void Film::doNotTurn() {
  turns_ = false;
  source_->video.set(cv::CAP_PROP_ORIENTATION_AUTO, 0);
  if (turned() % 180 != 0) size_ = {size_.height, size_.width};
}

void Film::addMasks(const std::string& path) {
  if (Source(path).read(0).empty()) throw std::runtime_error("there are no masks in " + path);
  masks_ = std::make_unique<Source>(path);
  masks_path_ = path;
}

Film Film::again() const {
  Film film(path_, fps_);
  if (!turns_) film.doNotTurn();
  if (masks_) film.addMasks(masks_path_);
  return film;
}

bool Film::skip() {
  if (!source_->skip(next_)) return false;
  if (!times_) ownTime();
  if (masks_) masks_->skip(next_);
  ++next_;
  return true;
}

// The median interval: a film that dropped frames is no slower.
void Film::setTimes(std::vector<double> times) {
  times_ = std::move(times);
  std::vector<double> intervals;
  for (size_t i = 1; i < times_->size(); ++i) intervals.push_back((*times_)[i] - (*times_)[i - 1]);
  if (intervals.empty()) return;
  if (const double interval = medianAmong(intervals); interval > 0.0) fps_ = 1.0 / interval;
}

double Film::ownTime() {
  if (!source_->images.empty()) return double(next_) / fps_;
  double time = source_->time() - start_;
  // The last frames of a decoder that looks ahead come without a time.
  if (next_ > 0 && !(time > last_time_)) time = last_time_ + 1.0 / std::max(fps_, 1.0);
  last_time_ = time;
  return time;
}

std::optional<FilmFrame> Film::next() {
  FilmFrame frame;
  frame.image = source_->read(next_);
  if (frame.image.empty()) return std::nullopt;
  if (times_ && next_ >= times_->size()) return std::nullopt;
  frame.time = times_ ? (*times_)[next_] : ownTime();
  if (masks_) {
    frame.mask = masks_->read(next_);
    if (frame.mask.empty())
      throw std::runtime_error("the masks of " + path_ + " end after " + std::to_string(next_) +
                               " frames");
  }
  ++next_;
  return frame;
}

namespace {

/// What a camera's folder holds; no path if it is none.
std::string filmOfFolder(const fs::path& folder) {
  if (!entriesOf(folder, isPicture).empty()) return folder.string();
  const std::vector<fs::path> videos = entriesOf(folder, isVideo);
  if (videos.size() > 1)
    throw std::runtime_error("the folder " + folder.string() +
                             " has several videos, name one film for each camera: " +
                             (folder.parent_path() / "*" / videos[0].filename()).string());
  return videos.empty() ? "" : videos[0].string();
}

void addFilmsOf(const std::string& folder, std::vector<NamedFilm>* films) {
  const size_t before = films->size();
  const auto any = [](const fs::path& path) { return isVideo(path) || fs::is_directory(path); };
  for (const fs::path& path : entriesOf(folder, any)) {
    if (!fs::is_directory(path))
      films->push_back({path.stem().string(), path.string()});
    else if (const std::string film = filmOfFolder(path); !film.empty())
      films->push_back({path.filename().string(), film});
  }
  if (films->size() == before)
    throw std::runtime_error("the folder " + folder +
                             " has no videos and no folders with images or a video");
}

}  // namespace

std::vector<NamedFilm> filmsIn(const std::vector<std::string>& inputs) {
  std::vector<NamedFilm> films;
  for (const std::string& input : inputs) {
    if (!fs::exists(input)) throw std::runtime_error("there is no file or folder " + input);
    if (fs::is_regular_file(input))
      films.push_back({cameraOfFilm(input, inputs), input});
    else
      addFilmsOf(input, &films);
  }
  return films;
}

}  // namespace markerless_mocap
