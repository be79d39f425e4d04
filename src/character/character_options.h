#pragma once

#include <string>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Who stands in the virtual studio. A part of its section: visit() adds these keys to the others.
struct CharacterOptions {
  static constexpr const char* kStage = "virtual_studio";
  double stature = 1.75;
  double male = 1.0;
  double bmi = 23.5;
  std::string clothes = "tight";
  std::string hair = "short";
  int look_seed = 1;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
