#pragma once

#include <functional>
#include <future>
#include <optional>

#include "markerless_mocap/silhouette/silhouette_options.h"
#include "silhouette/background/background.h"
#include "silhouette/recording/scene_samples.h"

namespace markerless_mocap {

/// Learns the background of a scene that people do not leave while they are watched: from the first
/// images, and again from all images so far after two, four, ... times as many.
class LiveLearner {
 public:
  explicit LiveLearner(const SilhouetteOptions& options);

  void change(const SilhouetteOptions& options) { options_ = options; }
  /// \param image CV_8UC1 or CV_8UC3, always the same size and type
  void add(const cv::Mat& image);
  /// Whether something moves in the images so far or somebody is seen in the last one, or option
  /// `background` is `recording`. To be asked once, after the first images.
  bool isOccupied() { return occupancy()(); }
  /// The same for another thread, as it takes as long as some images.
  std::function<bool()> occupancy();
  /// Whether the background should be learned again now.
  bool isDue() const { return sampler_.seen() >= next_; }
  /// Whether it need not be learned again.
  bool isDone() const { return next_ > last_ && !learning_.valid(); }
  Background learn();
  /// The same in another thread, as it takes as long as some images; nothing happens if that still
  /// runs. \param is_awaited nothing can be done without it; else its priority is low
  void learnBeside(bool is_awaited);
  /// Whether that runs. To end this object waits for it.
  bool isLearning() const { return learning_.valid(); }
  /// What learnBeside() has found; empty if it has found nothing new yet.
  std::optional<Background> learned();

 private:
  /// Whether nothing moves in the images so far; of the first time that it is asked.
  bool startsStill();
  /// When to learn again.
  void schedule(const Background& background);

  SilhouetteOptions options_;
  SceneSampler sampler_;
  int next_, last_;  ///< numbers of images
  std::optional<bool> starts_still_;
  std::future<Background> learning_;
};

}  // namespace markerless_mocap
