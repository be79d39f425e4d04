#pragma once

#include <Eigen/Core>
#include <functional>

#include "character/character.h"

namespace markerless_mocap {

/// A flat rectangle in space.
struct Panel {
  Eigen::Vector3f corner;            ///< metres
  Eigen::Vector3f along_u, along_v;  ///< its sides from the corner, metres; u x v points outwards
};

/// Colour as a function of the distances from the corner along both sides, metres.
using PanelColor = std::function<Eigen::Vector3f(float u, float v)>;

/// Adds a panel of square cells of about `cell` metres, with a colour per corner of a cell.
void addPanel(const Panel& panel, float cell, const PanelColor& color, ColoredMesh* mesh);

/// Adds the six sides of a box.
void addPanelBox(const Eigen::Vector3f& low, const Eigen::Vector3f& high, float cell,
                 const PanelColor& color, ColoredMesh* mesh);

}  // namespace markerless_mocap
