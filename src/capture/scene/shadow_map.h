#pragma once

#include <Eigen/Core>
#include <opencv2/core/types.hpp>
#include <vector>

#include "capture/scene/lit_scene.h"

namespace markerless_mocap {

/// Where the lamp's ray through a place under it meets the floor's plane, in a shadow map's texels.
Eigen::Vector2f shadowTexel(const Lamp& lamp, const Eigen::Vector3f& place);

/// What the objects of a scene keep from one lamp, on the plane of the floor, which is taken to go
/// on behind the walls: a place of a wall is looked up where the lamp's ray through it comes down.
class ShadowMap {
 public:
  ShadowMap(const Lamp& lamp, const std::vector<SceneObject>& objects);

  /// Whether no object stands under the lamp.
  bool empty() const { return rect_.empty(); }
  /// Texels outside of which nothing is dark.
  const cv::Rect& rect() const { return rect_; }
  /// Share (0 to 1) of the lamp that a place of the floor or a wall does not see. Soft: the wider,
  /// the higher that is what casts it (percentage-closer soft shadows: Fernando, 2005).
  float occlusion(const Eigen::Vector2f& texel) const;
  /// Share of the lamp that objects nearer to it hide from a vertex of an object.
  float occludedFraction(const Eigen::Vector3f& vertex) const;

 private:
  class SummedAreaTable;
  void findRect(const std::vector<SceneObject>& objects);
  void draw(const SceneObject& object);
  void drawTriangle(const Eigen::Vector3f (&corners)[3]);
  void soften();
  /// Half the width of the shadow's edge at a texel, texels; 0 where nothing is near.
  int penumbra(const SummedAreaTable& cover, const SummedAreaTable& near, int x, int y) const;

  Lamp lamp_;
  cv::Rect rect_;
  std::vector<float>
      inverse_depth_;  ///< 1 / (how far below the lamp the nearest object is), 0 for none
  std::vector<float> occlusion_;
};

}  // namespace markerless_mocap
