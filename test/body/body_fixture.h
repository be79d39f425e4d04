#pragma once

#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>

#include "error_text_of.h"
#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/body/body_urdf.h"

namespace markerless_mocap {

inline std::string humanTemplate() {
  std::ifstream file(std::string(MOCAP_SOURCE_DIR) + "/urdf/human.urdf.in");
  return std::string(std::istreambuf_iterator<char>(file), {});
}

inline std::string humanUrdf(
    const BodyProportions& proportions = BodyProportions::fromStature(1.75)) {
  return fillUrdfTemplate(humanTemplate(), "person1", proportions);
}

inline BodyModel human(const BodyProportions& proportions = BodyProportions::fromStature(1.75)) {
  return BodyModel::fromUrdf(humanUrdf(proportions), "person1");
}

inline std::shared_ptr<const BodyModel> testBody() {
  static const auto body = std::make_shared<const BodyModel>(human());
  return body;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace markerless_mocap
