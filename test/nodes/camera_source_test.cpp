#include "nodes/usb_cameras/camera_source.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <future>

namespace markerless_mocap {
namespace {

class Film {
 public:
  Film() : path_(testing::TempDir() + "film_" + std::to_string(getpid()) + ".avi") {
    cv::VideoWriter film(path_, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 100.0, {64, 48});
    for (int i = 0; i < kFrames; ++i) film.write(cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(20 * i)));
  }
  ~Film() { remove(); }
  void remove() const { std::filesystem::remove(path_); }
  const std::string& path() const { return path_; }

  static constexpr int kFrames = 10;

 private:
  std::string path_;
};

UsbCameraOptions playedAgain() {
  UsbCameraOptions options;
  options.loop = true;
  return options;
}

TEST(CameraSource, AFilmIsPlayedAgainWithStampsThatGoOn) {
  const Film film;
  std::promise<void> twice;
  std::vector<int64_t> stamps;
  CameraSource source("cam", film.path(), playedAgain());
  source.start(
      1,
      [&](int64_t stamp_ns, const cv::Mat&) {
        stamps.push_back(stamp_ns);
        if (stamps.size() == 2 * Film::kFrames) twice.set_value();
      },
      [](const std::string& reason) { ADD_FAILURE() << reason; });
  ASSERT_EQ(twice.get_future().wait_for(std::chrono::seconds(20)), std::future_status::ready);
  for (size_t i = 1; i < 2 * Film::kFrames; ++i) EXPECT_NEAR(stamps[i] - stamps[i - 1], 1e7, 1e6);
}

TEST(CameraSource, AFilmThatIsGoneIsTold) {
  const Film film;
  std::promise<std::string> told;
  bool is_told = false;
  CameraSource source("cam", film.path(), playedAgain());
  source.start(
      1, [&](int64_t, const cv::Mat&) { film.remove(); },
      [&](const std::string& reason) {
        if (!std::exchange(is_told, true)) told.set_value(reason);
      });
  std::future<std::string> reason = told.get_future();
  ASSERT_EQ(reason.wait_for(std::chrono::seconds(20)), std::future_status::ready);
  EXPECT_EQ(reason.get(),
            "no image comes from " + film.path() + " of camera cam, it is opened again");
}

}  // namespace
}  // namespace markerless_mocap
