#pragma once

#include "character/character.h"
#include "character/character_options.h"

namespace markerless_mocap {

/// A person of the given size, sex, weight and dress as closed, mirror-symmetric surface of about
/// 20000 vertices. Same options, same person. Throws std::invalid_argument if the options do.
Character makeCharacter(const CharacterOptions& options);

}  // namespace markerless_mocap
