#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// A round cone placed in the world, metres.
struct SolidCone {
  Eigen::Vector3d a, b;
  double radius_a, radius_b;
  Eigen::Vector3f rgb;  ///< each 0 to 1
};

/// The body's shape in the world.
std::vector<SolidCone> posedShape(const BodyModel& model, const LinkPoses& T_world_link);

/// What one camera sees.
struct RenderedView {
  cv::Mat image;  ///< CV_8UC3, BGR
  cv::Mat mask;   ///< CV_8UC1, 255 where a cone is seen, else 0
  cv::Mat depth;  ///< CV_32FC1, metres along the pixel's ray, infinity where the room is seen
};

/// Draws round cones before the room, with a depth buffer. One ray through each pixel's centre, so
/// lens distortion is honoured. Immutable.
class ViewRenderer {
 public:
  /// Computes all rays and the picture of the empty room.
  explicit ViewRenderer(Camera camera);
  const Camera& camera() const { return camera_; }
  /// Noiseless picture of the empty room, CV_8UC3 BGR.
  const cv::Mat& background() const { return background_; }
  RenderedView render(const std::vector<SolidCone>& cones) const;

 private:
  cv::Rect boundingBox(const SolidCone& cone) const;
  void draw(const SolidCone& cone, RenderedView& view) const;

  Camera camera_;
  std::vector<Eigen::Vector3f> rays_;  ///< unit direction in the world by pixel, row by row
  cv::Mat background_;
};

}  // namespace markerless_mocap
