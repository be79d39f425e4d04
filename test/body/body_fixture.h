#pragma once

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/body/body_urdf.h"

namespace markerless_mocap {

inline std::string humanTemplate() {
  std::ifstream file(std::string(MOCAP_SOURCE_DIR) + "/urdf/human.urdf.in");
  return std::string(std::istreambuf_iterator<char>(file), {});
}

inline std::string humanUrdf(double stature_m = 1.75) {
  return fillUrdfTemplate(humanTemplate(), "person1", BodyProportions::fromStature(stature_m));
}

inline BodyModel human(double stature_m = 1.75) {
  return BodyModel::fromUrdf(humanUrdf(stature_m), "person1");
}

/// The sentence of the std::invalid_argument that `call` throws; empty if it throws none.
template <class Call>
std::string sentenceOf(Call call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace markerless_mocap
