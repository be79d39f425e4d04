#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "capture/scene/lit_scene.h"
#include "capture/scene/textured_room.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// What one camera sees.
struct RenderedView {
  cv::Mat image;  ///< CV_8UC3, BGR, edges anti-aliased
  cv::Mat mask;   ///< CV_8UC1, 255 where the ray of the pixel's centre meets a person first, else 0
  cv::Mat depth;  ///< CV_32FC1, metres along that ray to the nearest object, infinity at the room
};

class SampleGrid;
class RoomView;

/// Draws the objects of a scene before the room as one camera sees them, with a depth buffer. Each
/// sample is a ray of the full lens model that is tested against the triangles themselves
/// (homogeneous edge functions: Olano and Greer, Triangle Scan Conversion using 2D Homogeneous
/// Coordinates, 1997), so masks are exact under distortion and nothing needs clipping. Immutable;
/// render() may be called from several threads and gives the same bytes on each.
class MeshRenderer {
 public:
  /// Computes all rays and the picture of the empty room.
  MeshRenderer(Camera camera, const TexturedRoom& room);
  const Camera& camera() const { return camera_; }
  /// Noiseless picture of the empty room, CV_8UC3 BGR.
  const cv::Mat& background() const;
  RenderedView render(const LitScene& scene) const;

 private:
  Camera camera_;
  std::shared_ptr<const SampleGrid> grid_;
  std::shared_ptr<const RoomView> room_view_;
};

/// One renderer per camera, made in parallel.
std::vector<MeshRenderer> makeRenderers(const CameraRig& rig, const TexturedRoom& room);

/// What the camera sees while its shutter is open: the mean of the images at sub-instants, evenly
/// spaced; mask and depth of the middle one. Throws std::invalid_argument if there is none or the
/// sizes differ.
RenderedView motionBlurred(const std::vector<RenderedView>& shots);

}  // namespace markerless_mocap
