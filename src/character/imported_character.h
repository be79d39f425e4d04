#pragma once

#include <string>

#include "character/character.h"

namespace markerless_mocap {

/// A user's own rigged character from any file that Assimp reads with its skin: glTF and GLB,
/// Collada, FBX.
///
/// All meshes that bones move, or that hang on a bone, are merged; others (floor, lamps) are left
/// out. Bones are found by name, see mapBones(); weights of twist joints, fingers and other joints
/// go to the nearest bone above, a vertex without weights to the nearest bone. The bind pose, or
/// the nodes' pose if that is no upright person, gives up and forward and is brought to the T-pose
/// of HumanPose: arms straight out, legs straight down, feet to the front. Spine, chest, neck,
/// head, collar bones, hands and toes that the rig does not have are placed by an adult's
/// proportions and take over their share of the weights. Joints of left and right are averaged.
/// Colours are those of the base colour texture (in the file or beside it) at the vertices, else
/// the vertices' own, else the material's.
///
/// \param path of the model
/// \param stature the mesh's height in the T-pose, metres, 0.5 to 2.5; the file's unit and size do
/// not matter
/// Throws std::invalid_argument, naming the file, if it cannot be read, has no mesh, no bones or
/// no name for a bone of arms or legs, a vertex at no finite place, or does not stand upright; or
/// if the stature is outside.
Character importCharacter(const std::string& path, double stature);

}  // namespace markerless_mocap
