#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/products/body_pose.h"
#include "markerless_mocap/tracking/product_source.h"
#include "markerless_mocap/tracking/tracked_body.h"

namespace markerless_mocap {

/// After a longer gap between two frame sets, nanoseconds, a person may have moved too far to be
/// followed: a tracker may doubt its pose, and search.
constexpr int64_t kLongGap_ns = 150000000;

/// Input of a tracker at one time. All references must stay valid during the call.
struct TrackerInput {
  int64_t stamp_ns;  ///< capture time
  const std::vector<cv::Mat>&
      masks;  ///< by camera, CV_8UC1 0 | 128 unknown | 255; empty where missing
  const std::vector<cv::Mat>& images;  ///< by camera, grey or BGR; empty where missing
  ProductSource& products;
  /// Whether newer frame sets wait by now: then what is not needed to follow the person is put off.
  /// It is asked again in between, as a search takes as long as many frames. Empty: none ever wait.
  std::function<bool()> behind = {};
  bool images_awaited = false;  ///< images that are missing here will come with later frames
  /// By camera, s: how much later than stamp_ns its image was taken; empty: all were taken then.
  std::vector<double> later_s = {};
  /// Called with the pose that update() will return, once at most and as soon as it is known. What
  /// takes long and seldom finds a better pose is done afterwards, for later frames. Empty: nobody
  /// is in a hurry, and the pose is the better one already.
  std::function<void(const BodyPose&)> report = {};
};

/// Tracks the pose of one person over time. Every tracking method implements this interface. Not
/// thread-safe, but for prepare().
class BodyTracker {
 public:
  virtual ~BodyTracker();
  /// The pose at the time of `now`. It is kLost, with the reason, if there is none.
  /// \param now a stamp that is not later than the last one restarts the tracking. Throws
  ///   std::invalid_argument if masks or images do not match the rig
  virtual BodyPose update(const TrackerInput& now) = 0;
  /// Does what can be done with a mask alone, before those of the other cameras are there. It is
  /// used if the next update() has the same mask: a cv::Mat with the same pixels in memory. The
  /// pose is the same without. For any thread, also while update() runs. A mask that update() would
  /// not take is left alone.
  virtual void prepare(size_t /*camera*/, const cv::Mat& /*mask*/) const {}
  /// By camera: whether its images would help, though its masks have no unknown background, as the
  /// last masks were in doubt; empty: none would.
  virtual std::vector<bool> wantedImages() const { return {}; }
  /// Follows the person from the pose of the last update() back in time until it is lost. Later
  /// poses are as if this had not been called.
  /// \param earlier frame sets before that of the last update(), the latest first
  /// \return poses of the first of them; none from methods that cannot do so, or while the body is
  ///   being measured
  virtual std::vector<BodyPose> followBack(const std::vector<TrackerInput>& /*earlier*/) {
    return {};
  }
  /// Restarts the tracking: poses of earlier frames have no influence. The body stays, and so do
  /// the frames collected for the estimate of its shape.
  virtual void reset() = 0;
  /// Estimates the shape of the body from the frames seen so far instead of waiting for more.
  /// Does nothing in methods that do not estimate the shape.
  virtual void estimateShapeNow() {}
  /// The current body of the person. It changes only in update(), after its shape has been
  /// estimated.
  virtual const std::shared_ptr<const TrackedBody>& body() const = 0;
};

}  // namespace markerless_mocap
