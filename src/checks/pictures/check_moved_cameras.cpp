#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "checks/pictures/check_pictures.h"
#include "checks/text/sentence.h"
#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

constexpr int kCorners = 300;
constexpr int kFewCorners = 12;
constexpr double kShare = 0.4;     // of the corners that must move alike
constexpr double kMoved = 0.0035;  // of the width of the image, as a shift of its corners
constexpr size_t kFewPictures = 6;

/// Motion of what stands still between two pictures.
struct Shift {
  double pixels = 0;  ///< of the picture, the largest at a corner of the image
  double turn = 0;    ///< about the optical axis, rad
};

cv::Mat evened(const cv::Mat& grey) {
  cv::Mat out;
  cv::createCLAHE(2.0, {8, 8})->apply(grey, out);
  return out;
}

double largestShift(const cv::Mat& affine, const cv::Size& size) {
  double most = 0;
  for (const double x : {0.0, double(size.width)})
    for (const double y : {0.0, double(size.height)}) {
      const cv::Mat at = affine * (cv::Mat_<double>(3, 1) << x, y, 1);
      most = std::max(most, std::hypot(at.at<double>(0) - x, at.at<double>(1) - y));
    }
  return most;
}

/// None if too little agrees.
std::optional<Shift> shiftBetween(const cv::Mat& from, const cv::Mat& to,
                                  const std::vector<cv::Point2f>& corners) {
  std::vector<cv::Point2f> moved, back, a, b;
  std::vector<uint8_t> found, found_back;
  std::vector<float> errors;
  const cv::Size window(21, 21);
  cv::calcOpticalFlowPyrLK(from, to, corners, moved, found, errors, window, 4);
  cv::calcOpticalFlowPyrLK(to, from, moved, back, found_back, errors, window, 4);
  for (size_t i = 0; i < corners.size(); ++i)
    if (found[i] && found_back[i] && cv::norm(back[i] - corners[i]) < 0.5) {
      a.push_back(corners[i]);
      b.push_back(moved[i]);
    }
  if (int(a.size()) < kFewCorners) return std::nullopt;
  std::vector<uint8_t> inliers;
  cv::setRNGSeed(1);
  const cv::Mat affine = cv::estimateAffinePartial2D(a, b, inliers, cv::RANSAC, 1.0);
  if (affine.empty() || cv::countNonZero(inliers) < kShare * double(corners.size()))
    return std::nullopt;
  return Shift{largestShift(affine, from.size()),
               std::atan2(affine.at<double>(1, 0), affine.at<double>(0, 0))};
}

/// How far what stands still in the first of some pictures has moved in others.
class StillScene {
 public:
  explicit StillScene(const cv::Mat& grey) : first_(evened(grey)) {
    cv::goodFeaturesToTrack(first_, corners_, kCorners, 0.02, 8);
  }
  /// Pixels; none if that cannot be told.
  std::optional<double> shiftOf(const cv::Mat& grey) const {
    if (int(corners_.size()) < kFewCorners || grey.size() != first_.size()) return std::nullopt;
    const auto shift = shiftBetween(first_, evened(grey), corners_);
    return shift ? std::optional<double>(shift->pixels) : std::nullopt;
  }

 private:
  cv::Mat first_;
  std::vector<cv::Point2f> corners_;
};

/// From which picture on all are shifted.
struct Moved {
  size_t from = 0;             ///< the count of the pictures if none is
  std::vector<double> shifts;  ///< of those from there on that are known, pixels
};

/// Looked at from the last picture back to the first that is not shifted by more than `least`,
/// which of a camera that stands still is the last.
Moved movedFrom(const std::vector<SeenPicture>& pictures, double least) {
  const StillScene scene(pictures.front().grey);
  Moved moved{pictures.size(), {}};
  for (size_t i = pictures.size(); i-- > 1;) {
    const std::optional<double> shift = scene.shiftOf(pictures[i].grey);
    if (!shift) continue;
    if (*shift < least) break;
    moved.from = i;
    moved.shifts.push_back(*shift);
  }
  return moved;
}

/// Whether what stands still is hidden in most pictures: in the others the person may be what
/// moved.
bool isSeldomSeen(const Moved& moved, size_t pictures) {
  return 2 * moved.shifts.size() < pictures - moved.from;
}

void checkCamera(const SeenCamera& camera, Findings* findings) {
  const std::vector<SeenPicture>& pictures = camera.pictures;
  if (camera.masks_only || pictures.size() < kFewPictures) return;
  const double width = pictures.front().grey.cols;
  const Moved moved = movedFrom(pictures, kMoved * width);
  const size_t from = moved.from;
  if (from + 1 >= pictures.size() || isSeldomSeen(moved, pictures.size())) return;
  const double shift = nearestQuantile(moved.shifts, 0.5);
  const double seconds = 1e-9 * double(pictures[from].stamp_ns - pictures.front().stamp_ns);
  const double before = 1e-9 * double(pictures[from - 1].stamp_ns - pictures.front().stamp_ns);
  const auto calibration = calibrationOf(camera);
  const double scale = calibration ? calibration->width / width : 1.0;
  std::string evidence = sentence(
      "what stands still has moved by %.1f px between %.1f and %.1f s "
      "after the first image",
      shift * scale, before, seconds);
  if (calibration)
    evidence += sentence(", about %.2f degrees",
                         std::atan(shift * scale / calibration->K(0, 0)) * 180 / M_PI);
  findings->push_back({"camera_moved", camera.name, Severity::kError, evidence,
                       "the calibration holds only before: fasten the camera, calibrate again, and "
                       "use the recording up to then (mocap_offline --duration)"});
}

}  // namespace

void checkMovedCameras(const SeenRig& rig, Findings* findings) {
  for (const SeenCamera& camera : rig.cameras) checkCamera(camera, findings);
}

}  // namespace markerless_mocap
