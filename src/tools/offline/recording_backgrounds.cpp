#include "tools/offline/recording_backgrounds.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "tools/common/progress.h"

namespace markerless_mocap {
namespace {

bool anyWantsNext(const std::vector<RecordingLearner>& learners) {
  return std::any_of(learners.begin(), learners.end(),
                     [](const RecordingLearner& learner) { return learner.wantsNext(); });
}

/// Passes over the frame sets that nobody needs, but for the last: the one after a gap may lack
/// images.
void skipUnneeded(Recording* recording, std::vector<RecordingLearner>* learners) {
  int unneeded = 0;
  for (; !anyWantsNext(*learners); ++unneeded)
    for (RecordingLearner& learner : *learners) learner.add({});
  recording->skip(unneeded - 1);
  if (unneeded > 0) recording->next();
}

void readAll(const OfflineOptions& options, Recording* recording,
             std::vector<RecordingLearner>* learners, Progress* progress) {
  for (;;) {
    progress->update(recording->fractionRead());
    skipUnneeded(recording, learners);
    const auto frame_set = nextFrameSet(options, recording);
    if (!frame_set) return;
    tbb::parallel_for(size_t(0), learners->size(),
                      [&](size_t i) { (*learners)[i].add(frame_set->frames[i].image); });
  }
}

void tell(const CameraRig& rig, const std::vector<SharedBackground>& backgrounds,
          std::ostream& notes) {
  notes << "somebody is in the first images: the background is learned from the whole recording; "
           "not seen in it:";
  for (size_t i = 0; i < backgrounds.size(); ++i)
    if (backgrounds[i])
      notes << ' ' << rig[i].name() << ' ' << std::lround(100 * unknownFraction(*backgrounds[i]))
            << " %";
  notes << '\n';
}

}  // namespace

std::vector<SharedBackground> learnBackgrounds(const OfflineOptions& options,
                                               PipelineOptions* pipeline, std::ostream* notes,
                                               bool terminal) {
  const SilhouetteOptions silhouette = pipeline->silhouette;
  if (!canLearnFromRecording(silhouette) || options.recording.use_masks) return {};
  pipeline->silhouette.background = "first_images";
  Recording recording(options.input, options.recording);
  const int expected = recording.expectedFrameSets();
  std::vector<RecordingLearner> learners;
  for (size_t i = 0; i < recording.rig().size(); ++i) learners.emplace_back(silhouette, expected);
  Progress progress("looking for the background", notes, terminal);
  readAll(options, &recording, &learners, &progress);
  progress.finish();
  std::vector<SharedBackground> backgrounds = learnBackgrounds(learners);
  if (std::count(backgrounds.begin(), backgrounds.end(), nullptr) == int(backgrounds.size()))
    return {};
  if (notes) tell(recording.rig(), backgrounds, *notes);
  return backgrounds;
}

}  // namespace markerless_mocap
