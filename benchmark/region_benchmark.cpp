/// One view of 330 x 248 samples (640 x 480 at every second pixel): the person by colours around a
/// projected body, against one iteration of OpenCV's GrabCut over the same samples. `ratio` is the
/// time of GrabCut divided by ours in the same run, `iou` the overlap with the exact mask.

#include <benchmark/benchmark.h>

#include <chrono>
#include <opencv2/imgproc.hpp>

#include "region/region_segmenter.h"

namespace markerless_mocap {
namespace {

constexpr int kParts = 6;

/// Six cones before a textured wall.
struct View {
  cv::Mat image, person;

  View() : image(248, 330, CV_8UC3), person(cv::Mat::zeros(248, 330, CV_8UC1)) {
    cv::RNG random(3);
    random.fill(image, cv::RNG::UNIFORM, 60, 220);
    cv::GaussianBlur(image, image, {0, 0}, 6);
    const cv::Scalar colors[kParts] = {{50, 40, 190}, {130, 160, 210}, {130, 160, 210},
                                       {50, 40, 190}, {90, 50, 30},    {90, 50, 30}};
    for (const ProjectedCone& cone : bodyAt(0).cones) {
      const cv::Point a(int(cone.a.x()), int(cone.a.y())), b(int(cone.b.x()), int(cone.b.y()));
      cv::line(image, a, b, colors[cone.part], int(2 * cone.radius_a));
      cv::line(person, a, b, 255, int(2 * cone.radius_a));
    }
    cv::Mat noise(image.size(), CV_8UC3);
    random.fill(noise, cv::RNG::UNIFORM, 0, 12);
    image += noise;
  }

  static ProjectedBody bodyAt(float shift) {
    const auto cone = [&](float ax, float ay, float bx, float by, float radius, int part) {
      return ProjectedCone{{ax + shift, ay}, {bx + shift, by}, radius, radius, 3, 3, part};
    };
    return {{cone(165, 75, 165, 125, 16, 0), cone(165, 48, 165, 50, 10, 1),
             cone(185, 75, 210, 120, 6, 2), cone(145, 75, 120, 120, 6, 3),
             cone(158, 130, 150, 210, 8, 4), cone(172, 130, 182, 210, 8, 5)},
            5.f};
  }
};

void Segment(benchmark::State& state) {
  using Clock = std::chrono::steady_clock;
  cv::setNumThreads(1);
  const View view;
  RegionSegmenter segmenter(kParts);
  segmenter.learn(view.image, View::bodyAt(0));
  const ProjectedBody body = View::bodyAt(4);
  const cv::Mat around(view.image.size(), CV_8UC1, cv::Scalar(cv::GC_BGD));
  std::chrono::duration<double> ours{0}, grab_cut{0};
  RegionMask found;
  for (auto _ : state) {
    const auto start = Clock::now();
    found = segmenter.segment(view.image, body, {});
    const auto between = Clock::now();
    cv::Mat labels = around.clone(), background, foreground;
    labels(cv::Rect(100, 30, 130, 200)).setTo(cv::GC_PR_FGD);
    cv::grabCut(view.image, labels, {}, background, foreground, 1, cv::GC_INIT_WITH_MASK);
    ours += between - start;
    grab_cut += Clock::now() - between;
  }
  state.counters["ms"] = 1e3 * ours.count() / double(state.iterations());
  state.counters["ratio"] = grab_cut / ours;
  state.counters["iou"] = double(cv::countNonZero(found.mask & view.person)) /
                          cv::countNonZero(found.mask | view.person);
}
BENCHMARK(Segment)->Unit(benchmark::kMillisecond);

void Learn(benchmark::State& state) {
  const View view;
  RegionSegmenter segmenter(kParts);
  for (auto _ : state) segmenter.learn(view.image, View::bodyAt(0));
}
BENCHMARK(Learn)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace markerless_mocap
