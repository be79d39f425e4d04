#pragma once

#include <string>

namespace markerless_mocap {

/// Refuses glTF files, text or binary, that end Assimp 5.2 by a null pointer or a full stack: a
/// skin without inverseBindMatrices, and nodes nested too deeply or in a circle. Other files pass,
/// also those that Assimp refuses by itself. Throws std::invalid_argument with path and fault.
void checkGltf(const std::string& path);

}  // namespace markerless_mocap
