#include "studies/label_samples/label_samples.h"

#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

#include "capture/ground_truth.h"
#include "markerless_mocap/hull/hull_carver.h"
#include "markerless_mocap/silhouette/silhouette_extractor.h"
#include "studies/label_samples/label_sampler.h"
#include "studies/label_samples/limb_cut.h"

namespace markerless_mocap {
namespace {

constexpr int kBackgroundFrames = 12;
constexpr int kCutEvery = 10;  // frames

StudioOptions studioOptions(const LabelSampleOptions& options) {
  if (options.frames < 1) throw std::invalid_argument("frames must be at least 1");
  StudioOptions studio = options.studio;
  studio.background_frames = options.silhouettes ? kBackgroundFrames : 0;
  return studio;
}

/// Options of a hull that covers the whole volume of the studio.
HullOptions hullOptions(const LabelSampleOptions& options) {
  HullOptions hull;
  hull.pitch = options.pitch;
  hull.volume = "explicit";
  hull.volume_min = {-1.9375, -1.9375, 0};
  hull.volume_max = {1.9375, 1.9375, 2.4375};
  if (options.studio.degradations.mask_damage > 0.0 && !options.silhouettes)
    hull.missing_votes_allowed = 1;
  return hull;
}

/// The silhouettes of successive frame sets.
class Masks {
 public:
  Masks(const VirtualStudio& studio, bool extracted) : studio_(studio) {
    if (!extracted) return;
    SilhouetteOptions options;
    options.background_frames = kBackgroundFrames;
    for (size_t camera = 0; camera < studio.rig().size(); ++camera)
      extractors_.emplace_back(options);
    for (int i = 0; i < kBackgroundFrames; ++i) of(studio.render(i));
  }

  std::vector<HullView> of(const StudioFrameSet& frame_set) {
    std::vector<HullView> views(studio_.rig().size());
    for (size_t camera = 0; camera < views.size(); ++camera)
      views[camera].mask = extractors_.empty()
                               ? frame_set.silhouettes[camera]
                               : extractors_[camera].update(frame_set.images[camera]).mask;
    return views;
  }

 private:
  const VirtualStudio& studio_;
  std::vector<SilhouetteExtractor> extractors_;
};

}  // namespace

void writeLabelSamples(const LabelSampleOptions& options, std::ostream* out) {
  const VirtualStudio studio(studioOptions(options), options.files, "truth");
  HullCarver carver(studio.rig(), hullOptions(options));
  Masks masks(studio, options.silhouettes);
  LabelSampleWriter sampler(groundTruthNames(), out);
  std::mt19937 random(uint32_t(options.studio.seed));
  const int begin = studio.options().background_frames, all = studio.frameSetCount() - begin;
  const int count = std::min(options.frames, all);
  for (int i = 0; i < count; ++i) {
    if (options.interrupted()) throw std::runtime_error("interrupted");
    const StudioFrameSet frame_set = studio.render(begin + int((i + 0.5) * all / count));
    const VisualHull hull = carver.carve(masks.of(frame_set));
    sampler.add(hull, frame_set.points, false);
    if (i % kCutEvery == 0 && !hull.voxels.empty())
      sampler.add(withLimbCut(hull, groundTruthNames(), frame_set.points, &random),
                  frame_set.points, true);
  }
}

}  // namespace markerless_mocap
