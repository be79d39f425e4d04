#include "tools/calibrate_rig/film.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>
#include <stdexcept>

#include "files/text_file.h"
#include "ros/camera_conversions.h"
#include "ros/image_conversions.h"
#include "tools/common/bag_io.h"
#include "tools/common/film_files.h"

namespace markerless_mocap {
namespace {

namespace fs = std::filesystem;

/// With the times of the container: phones do not keep their rate.
class Video : public ImageFilm {
 public:
  explicit Video(const std::string& path) {
    checkRegularFile(path, "the video " + path, std::numeric_limits<uintmax_t>::max());
    video_.open(path);
    if (!video_.isOpened()) throw std::runtime_error("cannot read the video " + path);
    rate_ = video_.get(cv::CAP_PROP_FPS);
    if (!(rate_ > 0)) throw std::runtime_error("the video " + path + " tells no frame rate");
  }
  TimedImage next() override {
    TimedImage frame;
    if (const auto time = skip()) {
      frame.time = *time;
      video_.retrieve(frame.image);
    }
    return frame;
  }
  std::optional<double> skip() override {
    if (!video_.grab()) return std::nullopt;
    double time = 1e-3 * video_.get(cv::CAP_PROP_POS_MSEC);
    if (!last_) start_ = time;
    time -= start_;
    // The last frames of a decoder that looks ahead come without a time.
    if (last_ && !(time > *last_)) time = *last_ + 1.0 / rate_;
    last_ = time;
    return time;
  }
  int count() const override { return std::max(0, int(video_.get(cv::CAP_PROP_FRAME_COUNT))); }

 private:
  cv::VideoCapture video_;
  double rate_ = 0.0, start_ = 0.0;
  std::optional<double> last_;
};

class Pictures : public ImageFilm {
 public:
  explicit Pictures(const std::string& folder) : files_(entriesOf(folder, isPicture)) {}
  TimedImage next() override {
    if (next_ >= files_.size()) return {};
    TimedImage frame{cv::imread(files_[next_].string(), cv::IMREAD_COLOR), double(next_)};
    if (frame.image.empty())
      throw std::runtime_error("cannot read the picture " + files_[next_].string());
    ++next_;
    return frame;
  }
  std::optional<double> skip() override {
    if (next_ >= files_.size()) return std::nullopt;
    return double(next_++);
  }
  int count() const override { return int(files_.size()); }

 private:
  std::vector<fs::path> files_;
  size_t next_ = 0;
};

class BagTopic : public ImageFilm {
 public:
  BagTopic(const std::string& path, const std::string& topic) {
    openForReading(path, bag_);
    view_ = std::make_unique<rosbag::View>(bag_, rosbag::TopicQuery(topic));
    message_ = view_->begin();
  }
  TimedImage next() override {
    if (message_ == view_->end()) return {};
    const rosbag::MessageInstance& entry = *message_;
    TimedImage frame;
    if (const auto raw = messageOf<sensor_msgs::Image>(entry)) {
      frame = {matFromMessage(*raw), 1e-9 * double(nanosecondsOf(raw->header.stamp))};
    } else if (const auto jpeg = messageOf<sensor_msgs::CompressedImage>(entry)) {
      frame = {matFromMessage(*jpeg), 1e-9 * double(nanosecondsOf(jpeg->header.stamp))};
    }
    ++message_;
    return frame;
  }
  std::optional<double> skip() override {
    if (message_ == view_->end()) return std::nullopt;
    const rosbag::MessageInstance& entry = *message_;
    double time = 0.0;
    if (const auto raw = messageOf<sensor_msgs::Image>(entry))
      time = 1e-9 * double(nanosecondsOf(raw->header.stamp));
    else if (const auto jpeg = messageOf<sensor_msgs::CompressedImage>(entry))
      time = 1e-9 * double(nanosecondsOf(jpeg->header.stamp));
    ++message_;
    return time;
  }
  int count() const override { return int(view_->size()); }

 private:
  rosbag::Bag bag_;
  std::unique_ptr<rosbag::View> view_;
  rosbag::View::iterator message_;
};

}  // namespace

std::unique_ptr<ImageFilm> openFilm(const FilmSource& source) {
  if (!source.topic.empty()) return std::make_unique<BagTopic>(source.path, source.topic);
  if (fs::is_directory(source.path)) return std::make_unique<Pictures>(source.path);
  return std::make_unique<Video>(source.path);
}

}  // namespace markerless_mocap
