/// One image of each of eight cameras to its mask, against OpenCV's subtractors with their shadow
/// detection, in one run over the same images: the ratio is the result. Eight cameras in turn, as
/// their states do not stay in the cache; the time is for one image. `iou` is the mean overlap with
/// the exact masks. Arguments: width, height.

#include <benchmark/benchmark.h>

#include <opencv2/imgproc.hpp>
#include <opencv2/video/background_segm.hpp>

#include "markerless_mocap/silhouette/silhouette_extractor.h"

namespace markerless_mocap {
namespace {

constexpr int kCameras = 8, kInstants = 6;

/// A textured room with noise; a person of several colours walks and casts a soft shadow.
class Film {
 public:
  explicit Film(const benchmark::State& state)
      : size_(int(state.range(0)), int(state.range(1))), unit_(size_.height / 480.0) {
    cv::setNumThreads(1);
    for (int camera = 0; camera < kCameras; ++camera) {
      cv::Mat room(size_, CV_8UC3);
      cv::RNG random(uint64_t(camera + 1));
      random.fill(room, cv::RNG::UNIFORM, 60, 220);
      cv::GaussianBlur(room, room, {0, 0}, 3 * unit_);
      rooms_.push_back(room);
      for (int i = 0; i < kInstants; ++i) shoot(camera, i);
    }
  }

  cv::Mat empty(int camera, int seed) const { return noisy(rooms_[camera], 1000 + seed); }
  const cv::Mat& image(int camera, int instant) const {
    return images_[camera * kInstants + instant];
  }
  const cv::Mat& mask(int camera, int instant) const {
    return masks_[camera * kInstants + instant];
  }

 private:
  void shoot(int camera, int instant) {
    const cv::Point2d at(size_.width * (0.3 + 0.05 * camera) + 6 * unit_ * instant,
                         size_.height * 0.3);
    cv::Mat image = rooms_[camera].clone(), shade(size_, CV_32FC1, 1.0f);
    part(at, {70, 320}, {110, 25}, 0.75, &shade);
    cv::GaussianBlur(shade, shade, {0, 0}, 4 * unit_);
    cv::cvtColor(shade, shade, cv::COLOR_GRAY2BGR);
    cv::multiply(image, shade, image, 1, CV_8UC3);
    cv::Mat mask = cv::Mat::zeros(size_, CV_8UC1);
    drawPerson(at, 6 * instant, &image, &mask);
    images_.push_back(noisy(image, camera * kInstants + instant));
    masks_.push_back(mask);
  }

  void drawPerson(const cv::Point2d& at, int step, cv::Mat* image, cv::Mat* mask) const {
    const struct {
      cv::Point2d place;
      cv::Size2d half;
      cv::Scalar color;
    } parts[] = {{{0, 0}, {22, 30}, {130, 160, 210}},
                 {{0, 100}, {45, 80}, {50, 40, 190}},
                 {{-60, 110}, {13, 80}, {50, 40, 190}},
                 {{60, 110}, {13, 80}, {130, 160, 210}},
                 {{-20.0 - step, 230}, {22, 100}, {90, 50, 30}},
                 {{20.0 + step, 230}, {22, 100}, {90, 50, 30}}};
    for (const auto& p : parts) {
      part(at, p.place, p.half, p.color, image);
      part(at, p.place, p.half, 255, mask);
    }
  }

  void part(const cv::Point2d& at, const cv::Point2d& place, const cv::Size2d& half,
            const cv::Scalar& color, cv::Mat* image) const {
    cv::ellipse(*image, at + place * unit_,
                cv::Size(int(half.width * unit_), int(half.height * unit_)), 0, 0, 360, color,
                cv::FILLED);
  }

  static cv::Mat noisy(const cv::Mat& image, int seed) {
    cv::Mat noise(image.size(), CV_16SC3), out;
    cv::RNG random(uint64_t(seed + 1));
    random.fill(noise, cv::RNG::NORMAL, 0, 4);
    cv::add(image, noise, out, cv::noArray(), image.type());
    return out;
  }

  cv::Size size_;
  double unit_;  ///< of a picture 480 px high, px
  std::vector<cv::Mat> rooms_, images_, masks_;
};

double iou(const cv::Mat& a, const cv::Mat& b) {
  return double(cv::countNonZero(a & b)) / cv::countNonZero(a | b);
}

/// Times `extract(camera, image)`, which gives a mask, image after image.
template <class ExtractT>
void run(benchmark::State& state, const Film& film, const ExtractT& extract) {
  double sum = 0;
  for (int i = 0; i < kCameras * kInstants; ++i) {
    const int camera = i % kCameras, instant = i / kCameras;
    sum += iou(extract(camera, film.image(camera, instant)), film.mask(camera, instant));
  }
  int64_t i = 0;
  for (auto _ : state) {
    const int camera = int(i % kCameras), instant = int(i / kCameras % kInstants);
    benchmark::DoNotOptimize(extract(camera, film.image(camera, instant)));
    ++i;
  }
  state.counters["iou"] = sum / (kCameras * kInstants);
}

void ours(benchmark::State& state, const std::string& model) {
  const Film film(state);
  SilhouetteOptions options;
  options.model = model;
  std::vector<SilhouetteExtractor> extractors;
  for (int camera = 0; camera < kCameras; ++camera) {
    extractors.emplace_back(options);
    for (int i = 0; i < options.background_frames; ++i)
      extractors.back().update(film.empty(camera, i));
  }
  run(state, film,
      [&](int camera, const cv::Mat& image) { return extractors[camera].update(image).mask; });
}

/// OpenCV's own classes without any clean-up.
template <class SubtractorT>
void opencvs(benchmark::State& state, const SubtractorT& make) {
  constexpr double kRate = 0.001;  // at its automatic rate a person who stands melts
  const Film film(state);
  std::vector<cv::Ptr<cv::BackgroundSubtractor>> subtractors;
  cv::Mat classes;
  for (int camera = 0; camera < kCameras; ++camera) {
    subtractors.push_back(make());
    for (int i = 0; i < 30; ++i) subtractors.back()->apply(film.empty(camera, i), classes);
  }
  run(state, film, [&](int camera, const cv::Mat& image) {
    subtractors[camera]->apply(image, classes, kRate);
    return cv::Mat(classes == 255);
  });
}

void gaussian(benchmark::State& state) {
  ours(state, "gaussian");
}
void meanShift(benchmark::State& state) {
  ours(state, "mean_shift");
}
void opencvMog2(benchmark::State& state) {
  opencvs(state, [] { return cv::createBackgroundSubtractorMOG2(500, 16, true); });
}
void opencvKnn(benchmark::State& state) {
  opencvs(state, [] { return cv::createBackgroundSubtractorKNN(500, 400, true); });
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Args({640, 480})->Args({1280, 720})->Unit(benchmark::kMillisecond);
}

BENCHMARK(gaussian)->Apply(sizes);
BENCHMARK(meanShift)->Apply(sizes);
BENCHMARK(opencvMog2)->Apply(sizes);
BENCHMARK(opencvKnn)->Apply(sizes);

}  // namespace
}  // namespace markerless_mocap
