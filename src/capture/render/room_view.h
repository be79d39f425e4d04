#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "capture/render/sample_grid.h"
#include "capture/scene/lit_scene.h"
#include "capture/scene/textured_room.h"

namespace markerless_mocap {

/// Weights of the nine samples of a pixel, by the sum of their distances in x and y: a tent filter
/// two pixels wide, the blur of an ordinary lens.
constexpr std::array<int, 3> kTent = {4, 2, 1};
constexpr int kTentSum = 16;

class FloorMirror;

/// The image of the empty room in one camera, and the shadows on it.
class RoomView {
 public:
  /// \param mirror reflections on the floor; nullptr: none
  RoomView(const Camera& camera, const SampleGrid& grid, const TexturedRoom& room,
           const FloorMirror* mirror = nullptr);

  /// CV_8UC3, BGR.
  const cv::Mat& picture() const { return picture_; }
  /// Darkens the parts of the room that the scene's objects hide from the lamps.
  /// \param image picture() or a copy
  void castShadows(const LitScene& scene, cv::Mat& image) const;
  /// Adds the sun and takes away the light of lamps that are off.
  /// \param image picture() or a copy
  void changeLight(const LitScene& scene, cv::Mat& image) const;

 private:
  static constexpr int kBlock = 16;  ///< pixels
  struct Bounds {
    Eigen::Vector2f low, high;
  };

  void drawPicture(const Camera& camera, const SampleGrid& grid, const TexturedRoom& room);
  void boundBlocks(const TexturedRoom& room);
  cv::Rect blockRect(int block) const;
  Eigen::Vector3f lightAt(const LitScene& scene, const Eigen::Vector3f& place) const;
  void shadeBlock(const cv::Rect& rect, const LitScene& scene, uint32_t lamps,
                  cv::Mat& image) const;

  Eigen::Vector3f half_size_;  ///< the room's
  cv::Mat picture_;
  cv::Mat positions_;                        ///< CV_32FC3: world place that each pixel shows
  std::vector<Lamp> lamps_;                  ///< the room's
  std::vector<std::vector<Bounds>> bounds_;  ///< by lamp and block: texels on the floor's plane
};

}  // namespace markerless_mocap
