#pragma once

#include <Eigen/Core>
#include <opencv2/core/types.hpp>
#include <vector>

#include "capture/scene/lit_scene.h"

namespace markerless_mocap {

/// Intersection of the lamp's ray through a point below the lamp with the floor's plane, in texels
/// of a shadow map.
Eigen::Vector2f shadowTexel(const Lamp& lamp, const Eigen::Vector3f& place);

/// Shadows of the objects of a scene for one lamp, on the plane of the floor. The plane continues
/// behind the walls: a point of a wall is looked up where the lamp's ray through it meets the
/// plane.
class ShadowMap {
 public:
  ShadowMap(const Lamp& lamp, const std::vector<SceneObject>& objects);

  /// Whether there is no object below the lamp.
  bool empty() const { return rect_.empty(); }
  /// Texels outside of which there is no shadow.
  const cv::Rect& rect() const { return rect_; }
  /// Fraction of the lamp, 0 to 1, that is hidden at a point of the floor or a wall. Shadows are
  /// softer if the occluder is higher (percentage-closer soft shadows: Fernando, 2005).
  float occlusion(const Eigen::Vector2f& texel) const;
  /// Fraction of the lamp that is hidden from a vertex of an object by nearer objects.
  float occludedFraction(const Eigen::Vector3f& vertex) const;

 private:
  class SummedAreaTable;
  void findRect(const std::vector<SceneObject>& objects);
  void draw(const SceneObject& object);
  void drawTriangle(const Eigen::Vector3f (&corners)[3]);
  void soften();
  /// Half the width of the shadow's edge at a texel, in texels; 0 if there is no occluder nearby.
  int penumbra(const SummedAreaTable& cover, const SummedAreaTable& near, int x, int y) const;

  Lamp lamp_;
  cv::Rect rect_;
  /// 1 / (depth of the nearest object below the lamp), 1/m; 0: no object.
  std::vector<float> inverse_depth_;
  std::vector<float> occlusion_;
};

}  // namespace markerless_mocap
