#pragma once

#include <future>
#include <optional>
#include <vector>

#include "contour/regions/region_search.h"
#include "contour/track/contour_multi_hypothesis_tracker.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// A second search of a frame set by colour, which confirms the pose that is tracked or finds a
/// better one. It holds copies: it may be answered in another thread, and later.
struct ColorQuestion {
  RegionObserver observer;  ///< without colours: those that a wrong pose has taught speak for it
  ContourMultiHypothesisTracker tracker;
  RegionFrame frame;
  VisualHull hull;
  ContourBody body;
  ContourPose pose;  ///< the one that is tracked
  std::vector<ContourPose> proposals;

  ColorScene scene() const { return {observer, tracker, frame, hull, body}; }
};

/// Adds default postures to proposals of which none fits well.
ColorQuestion completed(ColorQuestion question);

/// What a question's colours show: the tracked pose, or one that is clearly better; empty if
/// neither can be fitted.
std::optional<RegionFit> answered(const ColorQuestion& question);

/// Which of two poses the colours of a frame set show, fitted to them: the tracked one, or a rival
/// that is clearly better. Empty if neither can be fitted. Takes as long as following the person
/// over some frames.
std::optional<RegionFit> preferred(const ColorScene& scene, const ContourPose& tracked,
                                   const ContourPose& rival);

/// Completes and answers one question after another in another thread.
class ColorCheck {
 public:
  bool isBusy() const { return answer_.valid(); }
  /// kBeside: at low priority. kAwaited: nothing is reported before the answer.
  enum Urgency { kBeside, kAwaited };
  /// Must not be called while it is busy.
  void ask(ColorQuestion question, Urgency urgency);
  struct Answer {
    ContourPose asked;
    std::optional<RegionFit> found;
  };
  /// Empty while there is none, and if it has been forgotten meanwhile.
  std::optional<Answer> answer();
  /// The next answer is about a body that is not tracked any more.
  void forget() { forgotten_ = true; }

 private:
  std::future<Answer> answer_;
  bool forgotten_ = false;
};

/// A pose that was found instead of `asked`, at the time of a later pose of the body that was taken
/// for `asked`: joints that were wrong are as found, the others as they are now.
ContourPose broughtForward(const ContourPose& found, const ContourPose& asked,
                           const ContourPose& now);

}  // namespace markerless_mocap
