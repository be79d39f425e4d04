#pragma once

#include "character/character.h"
#include "character/character_options.h"

namespace markerless_mocap {

/// A person of the given size, sex, weight and dress as a closed, mirror-symmetric surface of about
/// 20000 vertices. Deterministic. Throws std::invalid_argument as CharacterOptions::validate().
Character makeCharacter(const CharacterOptions& options);

}  // namespace markerless_mocap
