#pragma once

#include <string>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Who stands in the virtual studio. A part of its section: visit() adds these keys to the others.
struct CharacterOptions {
  static constexpr const char* kStage = "virtual_studio";
  /// height of the person, m
  double stature = 1.75;
  /// shape of the person; 0: woman, 1: man, or a mixture
  double male = 1.0;
  /// body mass index of the person, kg/m^2
  double bmi = 23.5;
  /// tight clothes, a wide shirt and wide trousers, or a knee-long skirt with a tight shirt
  std::string clothes = "tight";
  /// long hair falls over neck and shoulder blades
  std::string hair = "short";
  /// seed of the colours of skin, hair and clothes, and of the pattern of the cloth
  int appearance_seed = 1;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
