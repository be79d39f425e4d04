#pragma once

#include <string>

#include "character/character.h"

namespace markerless_mocap {

/// Imports a rigged character from a file that Assimp can read with its skin: glTF and GLB,
/// Collada, FBX. All meshes that are moved by bones or attached to a bone are merged; others
/// (floor, lamps) are left out. Bones are found by name, see mapBones(). Weights of twist joints,
/// fingers and other joints are given to the nearest bone above; a vertex without weights is given
/// to the nearest bone. Up and forward are found in the bind pose, or in the nodes' pose if the
/// bind pose is not upright. The character is then brought to the T-pose of HumanPose: arms
/// straight out, legs straight down, feet to the front. Spine, chest, neck, head, collar bones,
/// hands and toes that the rig does not have are placed by an adult's proportions and get a part of
/// the weights. Joints of left and right are averaged. The colour of a vertex is that of the base
/// colour texture (in the file or beside it), else the vertex's own, else the material's.
/// \param path of the model
/// \param stature height of the mesh in the T-pose, metres, 0.5 to 2.5; the unit and size in the
///   file are ignored Throws std::invalid_argument with the file's name if the file cannot be read,
///   has no mesh or no bones, if a bone of arms or legs is not found, a vertex is not finite or the
///   character is not upright; or if the stature is out of range.
Character importCharacter(const std::string& path, double stature);

}  // namespace markerless_mocap
