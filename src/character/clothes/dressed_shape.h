#pragma once

#include <array>
#include <optional>

#include "character/body/body_shape.h"
#include "character/character_options.h"

namespace markerless_mocap {

/// Visible layers of a person.
enum class Layer { kSkin, kShirt, kTrousers, kSkirt, kShoes, kHair };
constexpr int kLayerCount = 6;

/// A body with clothes and hair as signed distances, mirror-symmetric in y.
class DressedShape {
 public:
  DressedShape(const BodyShape& body, const CharacterOptions& options);

  /// Signed distance to the outermost layer, metres, negative inside.
  double distance(const Eigen::Vector3d& p) const;
  /// The outermost layer at a point of the surface.
  Layer layerAt(const Eigen::Vector3d& p) const;

 private:
  std::array<double, kLayerCount> layers(const Eigen::Vector3d& p) const;
  double shirt(const Eigen::Vector3d& p, const PartDistances& parts) const;
  double trousers(const Eigen::Vector3d& p, const PartDistances& parts) const;
  double skirt(const Eigen::Vector3d& p) const;
  double hair(const Eigen::Vector3d& p, const PartDistances& parts) const;
  double length(double man, double woman) const { return body_.build().length(man, woman); }

  BodyShape body_;
  bool loose_, bare_legs_, long_hair_;
  std::optional<Loft> shirt_, sleeve_, trouser_, skirt_, fall_;
};

}  // namespace markerless_mocap
