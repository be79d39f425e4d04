/// Eight colour images of 640 x 480 to a labelled pose tree: silhouettes, hull, thinning, labels,
/// over a film of the virtual studio that is rendered beforehand. `instantAfterInstant` is what one
/// caller waits for; `stagesAtOnce` lets each stage work on another instant, as the nodelets do.
/// `valid` is the share of trees that are. The bytes of the images alone are copied once by
/// `copyImages`, as a measure of the machine. Arguments: voxels along an edge of 2 m, threads.

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>

#include <fstream>
#include <iterator>

#include "capture/virtual_studio.h"
#include "markerless_mocap/hull/hull_carver.h"
#include "markerless_mocap/silhouette/silhouette_extractor.h"
#include "markerless_mocap/skeleton/pose_tree_builder.h"

namespace markerless_mocap {
namespace {

constexpr int kBackgroundFrames = 30, kInstants = 24;

struct Film {
  CameraRig rig;
  std::vector<std::vector<cv::Mat>> empty, instants;
};

const Film& film() {
  static const Film film = [] {
    StudioOptions options;
    options.motion = "wave_and_walk";
    options.fps = 4;
    options.background_frames = kBackgroundFrames;
    std::ifstream urdf(std::string(MOCAP_SOURCE_DIR) + "/urdf/human.urdf.in");
    const StudioFiles files{std::string(std::istreambuf_iterator<char>(urdf), {}),
                            std::string(MOCAP_SOURCE_DIR) + "/config/motions"};
    const VirtualStudio studio(options, files, "person1");
    Film out;
    out.rig = studio.rig();
    for (int i = 0; i < kBackgroundFrames + kInstants; ++i)
      (i < kBackgroundFrames ? out.empty : out.instants).push_back(studio.render(i).images);
    return out;
  }();
  return film;
}

class Chain {
 public:
  explicit Chain(const benchmark::State& state)
      : threads_(tbb::global_control::max_allowed_parallelism, size_t(state.range(1))),
        carver_(film().rig, hullOptions(int(state.range(0)))),
        builder_(PoseTreeOptions()) {
    for (size_t c = 0; c < film().rig.size(); ++c) extractors_.emplace_back(SilhouetteOptions());
    for (const auto& images : film().empty) silhouettes(images);
  }

  std::vector<HullView> silhouettes(const std::vector<cv::Mat>& images) {
    std::vector<HullView> views(images.size());
    tbb::parallel_for(size_t(0), images.size(),
                      [&](size_t c) { views[c].mask = extractors_[c].update(images[c]).mask; });
    return views;
  }
  VisualHull hull(const std::vector<HullView>& views) { return carver_.carve(views); }
  void tree(const VisualHull& hull) {
    valid_ += builder_.build(hull).valid();
    ++trees_;
  }
  double validShare() const { return trees_ ? double(valid_) / trees_ : 0; }

 private:
  static HullOptions hullOptions(int edge) {
    HullOptions options;
    options.volume = "explicit";
    options.volume_min = {-1, -1, 0};
    options.volume_max = {1, 1, 2};
    options.pitch = 2.0 / edge;
    return options;
  }

  tbb::global_control threads_;
  std::vector<SilhouetteExtractor> extractors_;
  HullCarver carver_;
  PoseTreeBuilder builder_;
  int64_t valid_ = 0, trees_ = 0;
};

void tell(benchmark::State& state, const Chain& chain) {
  state.SetItemsProcessed(state.iterations() * kInstants);
  state.counters["valid"] = chain.validShare();
}

void instantAfterInstant(benchmark::State& state) {
  Chain chain(state);
  for (auto _ : state)
    for (const auto& images : film().instants) chain.tree(chain.hull(chain.silhouettes(images)));
  tell(state, chain);
}

void stagesAtOnce(benchmark::State& state) {
  Chain chain(state);
  for (auto _ : state) {
    size_t next = 0;
    using tbb::filter_mode;
    tbb::parallel_pipeline(
        4,
        tbb::make_filter<void, std::vector<HullView>>(filter_mode::serial_in_order,
                                                      [&](tbb::flow_control& control) {
                                                        if (next == film().instants.size()) {
                                                          control.stop();
                                                          return std::vector<HullView>();
                                                        }
                                                        return chain.silhouettes(
                                                            film().instants[next++]);
                                                      }) &
            tbb::make_filter<std::vector<HullView>, VisualHull>(
                filter_mode::serial_in_order,
                [&](const std::vector<HullView>& views) { return chain.hull(views); }) &
            tbb::make_filter<VisualHull, void>(filter_mode::serial_in_order,
                                               [&](const VisualHull& hull) { chain.tree(hull); }));
  }
  tell(state, chain);
}

void copyImages(benchmark::State& state) {
  std::vector<cv::Mat> copies(film().rig.size());
  for (auto _ : state)
    for (const auto& images : film().instants)
      for (size_t c = 0; c < images.size(); ++c) images[c].copyTo(copies[c]);
  state.SetItemsProcessed(state.iterations() * kInstants);
}

void arguments(benchmark::internal::Benchmark* benchmark) {
  for (const int edge : {64, 128})
    for (const int threads : {1, 2}) benchmark->Args({edge, threads});
  benchmark->Unit(benchmark::kMillisecond)->UseRealTime();
}

BENCHMARK(instantAfterInstant)->Apply(arguments);
BENCHMARK(stagesAtOnce)->Apply(arguments);
BENCHMARK(copyImages)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace markerless_mocap
