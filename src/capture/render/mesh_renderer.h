#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "capture/scene/lit_scene.h"
#include "capture/scene/textured_room.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// The rendered images of one camera.
struct RenderedView {
  cv::Mat image;  ///< CV_8UC3, BGR, edges anti-aliased
  cv::Mat
      mask;  ///< CV_8UC1, 255 where the ray through the pixel's centre hits a person first, else 0
  cv::Mat depth;  ///< CV_32FC1, metres along that ray to the nearest object; infinity for the room
};

class FloorMirror;
class SampleGrid;
class RoomView;

/// Renders the objects of a scene in front of the room for one camera, with a depth buffer. Each
/// sample is a ray of the full lens model that is tested against the triangles (homogeneous edge
/// functions: Olano and Greer, Triangle Scan Conversion using 2D Homogeneous Coordinates, 1997).
/// Masks are therefore exact under distortion, and no clipping is needed. Immutable; render() may
/// be called from several threads and gives the same bytes in each.
class MeshRenderer {
 public:
  /// Computes all rays and the image of the empty room.
  /// \param floor_reflection 0 to 1: fraction of the light that the floor mirrors, seen from above
  MeshRenderer(Camera camera, const TexturedRoom& room, double floor_reflection = 0.0);
  const Camera& camera() const { return camera_; }
  /// Image of the empty room without noise, CV_8UC3 BGR.
  const cv::Mat& background() const;
  RenderedView render(const LitScene& scene) const;

 private:
  Camera camera_;
  std::shared_ptr<const SampleGrid> grid_;
  std::shared_ptr<const FloorMirror> mirror_;  ///< nullptr: the floor is dull
  std::shared_ptr<const RoomView> room_view_;
};

/// One renderer per camera, created in parallel.
std::vector<MeshRenderer> makeRenderers(const CameraRig& rig, const TexturedRoom& room,
                                        double floor_reflection = 0.0);

/// Simulates an open shutter: the mean of the images of evenly spaced times; mask and depth are
/// those of the middle one. Throws std::invalid_argument if there is no image or the sizes differ.
RenderedView motionBlurred(const std::vector<RenderedView>& shots);

}  // namespace markerless_mocap
