#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Where a person is in an image: the convex hull of the silhouette, and its centre of area.
struct Outline {
  std::vector<Eigen::Vector2d> hull;  ///< pixels; empty: nobody
  Eigen::Vector2d centre{0, 0};       ///< pixels
  double area = 0.0;                  ///< square pixels
  bool cut = false;                   ///< touches the border of the image
};

/// \param mask CV_8UC1, 255 = person; other values are not \param width, height of the image that
///   the outline is for, pixels: the mask may be smaller
/// Parts of less than a fifth of the largest one are left out, and so is a person of less than
/// a 500th of the image.
Outline outlineOf(const cv::Mat& mask, int width, int height);

/// One image message.
struct SeenImage {
  int64_t stamp_ns = 0, received_ns = 0;
  int width = 0, height = 0;       ///< pixels; 0: could not be decoded, or was not
  uint64_t fingerprint = 0;        ///< of the pixels; equal only for equal images
  cv::Mat colors;                  ///< CV_8UC3, the image at kColorsWidth; empty if not decoded
  std::optional<Outline> outline;  ///< none: not looked for
};
constexpr int kColorsWidth = 32;  ///< of SeenImage::colors, pixels

/// A whole image, grey, at a width of at most kPictureWidth.
struct SeenPicture {
  int64_t stamp_ns = 0;
  cv::Mat grey;  ///< CV_8UC1
};
constexpr int kPictureWidth = 640;  ///< pixels
constexpr int kPictures = 24;       ///< of a recording

/// A camera_info message that differs from the one before.
struct SeenInfo {
  int64_t received_ns = 0;
  int width = 0, height = 0;
  Eigen::Matrix3d K = Eigen::Matrix3d::Zero();
  std::vector<double> D;
  LensType lens = LensType::kPolynomial;
  std::string frame;
  double time_offset = 0;  ///< s, to be added to the stamps, as a rig file has it
  std::string problem;  ///< why it cannot be used for another reason than K and size; empty: none
};

/// What one camera has sent.
struct SeenCamera {
  std::string name;
  std::vector<SeenImage> images;      ///< in the order in which they came
  std::vector<SeenPicture> pictures;  ///< in the order of time
  std::vector<SeenInfo> infos;        ///< in the order in which they came
  std::optional<Eigen::Isometry3d> T_world_camera;
  std::string pose_problem;  ///< why there is no pose
  bool masks_only = false;   ///< the images are silhouettes: nothing is said of their brightness
  int unreadable = 0;        ///< images that could not be decoded
};

/// What the cameras of a rig have sent. No ROS type, no bag.
struct SeenRig {
  std::vector<SeenCamera> cameras;
  std::string world_frame = "world";
  /// The box in which the hull will be carved, metres in world; empty: not known or automatic.
  Eigen::AlignedBox3d volume;
};

/// The calibration of a camera; none if camera_info or pose are missing or cannot be used.
std::optional<CameraCalibration> calibrationOf(const SeenCamera& camera);

}  // namespace markerless_mocap
