#include "nodes/usb_cameras/camera_source.h"

#include <ros/time.h>
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "nodes/common/end_process.h"

namespace markerless_mocap {
namespace {

constexpr double kLongestDelay = 1.0;                              // s, of an image in the driver
constexpr double kManualExposure = 1.0, kAutomaticExposure = 3.0;  // of Video4Linux
constexpr auto kPause = std::chrono::milliseconds(500);            // until it is opened again

bool isNumber(const std::string& text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c); });
}

int64_t now() {
  const ros::WallTime time = ros::WallTime::now();
  return int64_t(time.sec) * 1000000000 + time.nsec;
}

/// Video4Linux gives the time of an image by the monotonic clock. Where it does not, the image was
/// taken just now.
int64_t stampOf(const cv::VideoCapture& capture) {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  const double delay =
      double(time.tv_sec) + 1e-9 * double(time.tv_nsec) - 1e-3 * capture.get(cv::CAP_PROP_POS_MSEC);
  const bool known = delay >= 0.0 && delay < kLongestDelay;
  return now() - (known ? std::llround(1e9 * delay) : 0);
}

}  // namespace

CameraSource::CameraSource(std::string name, std::string source, const UsbCameraOptions& options)
    : name_(std::move(name)),
      source_(std::move(source)),
      options_(options),
      device_(isNumber(source_) || source_.rfind("/dev/", 0) == 0) {
  if (!open())
    throw std::runtime_error("usb_cameras: " + source_ + " of camera " + name_ +
                             " cannot be opened" +
                             (device_ ? "; is it plugged in, and not in use elsewhere?" : ""));
}

CameraSource::~CameraSource() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

bool CameraSource::open() {
  if (!device_) return capture_.open(source_);
  const bool opened = isNumber(source_) ? capture_.open(std::stoi(source_), cv::CAP_V4L2)
                                        : capture_.open(source_, cv::CAP_V4L2);
  if (!opened) return false;
  const std::string& code = options_.pixel_format;
  capture_.set(cv::CAP_PROP_FOURCC, cv::VideoWriter::fourcc(code[0], code[1], code[2], code[3]));
  capture_.set(cv::CAP_PROP_FRAME_WIDTH, options_.width);
  capture_.set(cv::CAP_PROP_FRAME_HEIGHT, options_.height);
  capture_.set(cv::CAP_PROP_FPS, options_.fps);
  capture_.set(cv::CAP_PROP_BUFFERSIZE, 2);
  capture_.set(cv::CAP_PROP_AUTO_EXPOSURE,
               options_.exposure > 0 ? kManualExposure : kAutomaticExposure);
  if (options_.exposure > 0) capture_.set(cv::CAP_PROP_EXPOSURE, options_.exposure);
  if (options_.white_balance > 0) {
    capture_.set(cv::CAP_PROP_AUTO_WB, 0);
    capture_.set(cv::CAP_PROP_WB_TEMPERATURE, options_.white_balance);
  }
  return true;
}

void CameraSource::start(int64_t start_ns, Sink sink, Trouble trouble) {
  start_ns_ = start_ns;
  sink_ = std::move(sink);
  trouble_ = std::move(trouble);
  thread_ = std::thread([this] { runOrEndProcess("a camera", [this] { run(); }); });
}

void CameraSource::run() {
  while (!stop_) {
    const bool was_played = !device_ && readFile();
    if (device_) readDevice();
    if (stop_ || (was_played && !options_.loop)) return;
    if (!was_played) {
      trouble_("no image comes from " + source_ + " of camera " + name_ + ", it is opened again");
      std::this_thread::sleep_for(kPause);
    }
    open();
  }
}

void CameraSource::readDevice() {
  cv::Mat image;
  while (!stop_ && capture_.grab()) {
    const int64_t stamp_ns = stampOf(capture_);
    if (capture_.retrieve(image)) sink_(stamp_ns, image);
  }
}

bool CameraSource::readFile() {
  const int64_t interval_ns = std::llround(1e9 / std::max(capture_.get(cv::CAP_PROP_FPS), 1.0));
  int64_t stamp_ns = start_ns_ - interval_ns;
  cv::Mat image;
  while (!stop_ && capture_.read(image)) {
    const int64_t told = start_ns_ + std::llround(1e6 * capture_.get(cv::CAP_PROP_POS_MSEC));
    // The last frames of a decoder that looks ahead come without a time.
    stamp_ns = told > stamp_ns ? told : stamp_ns + interval_ns;
    if (!waitUntil(stamp_ns)) break;
    sink_(stamp_ns, image);
  }
  const bool had_images = stamp_ns >= start_ns_;
  start_ns_ = stamp_ns + interval_ns;
  return had_images;
}

bool CameraSource::waitUntil(int64_t stamp_ns) const {
  while (!stop_ && now() < stamp_ns)
    std::this_thread::sleep_for(
        std::min(std::chrono::nanoseconds(stamp_ns - now()), std::chrono::nanoseconds(kPause)));
  return !stop_;
}

}  // namespace markerless_mocap
