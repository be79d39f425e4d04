#include "markerless_mocap/body/body_urdf.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <map>
#include <stdexcept>

#include "body/urdf/expression.h"

namespace markerless_mocap {
namespace {

bool isValidId(const std::string& id) {
  const auto letter = [](unsigned char c) { return c < 128 && std::isalpha(c); };
  const auto letter_or_digit = [](unsigned char c) { return c < 128 && std::isalnum(c); };
  return !id.empty() && letter(id[0]) && std::all_of(id.begin(), id.end(), letter_or_digit);
}

std::map<std::string, double> namesOf(const BodyProportions& p) {
  return {{"torso", p.torso},
          {"head", p.head},
          {"upper_arm", p.upper_arm},
          {"forearm", p.forearm},
          {"thigh", p.thigh},
          {"shank", p.shank},
          {"shoulder_width", p.shoulder_width},
          {"hip_width", p.hip_width},
          {"hand", p.hand},
          {"foot", p.foot},
          {"ankle_height", p.ankle_height},
          {"neck", p.neck},
          {"girth", p.girth}};
}

std::string decimal(double value) {
  std::array<char, 400> text;  // the largest double has 309 digits before the point
  const auto end = std::to_chars(text.begin(), text.end(), value, std::chars_format::fixed, 6).ptr;
  return std::string(text.data(), end);
}

}  // namespace

BodyProportions BodyProportions::fromStature(double stature_m) {
  if (!(stature_m >= 0.5 && stature_m <= 2.5))
    throw std::invalid_argument("stature is " + decimal(stature_m) + " m, allowed is 0.5 to 2.5 m");
  // Heights and legs: Drillis and Contini 1966, as printed in Winter, Biomechanics and Motor
  // Control of Human Movement, Fig. 4.1: hip 0.530 H, shoulder 0.818 H, thigh 0.245, shank 0.246,
  // ankle 0.039, foot 0.152, hand 0.108. Arms between joint centres: de Leva 1996, Table 4, mean
  // of women and men. Their shoulder (0.259) and hip (0.191) breadths are outer ones; between joint
  // centres the shoulders are about 0.205 H apart and the hips, by Bell et al. 1990 at 0.72 of the
  // breadth between the iliac spines, 0.10 to 0.12 H. The neck base is the seventh cervical
  // vertebra.
  BodyProportions p;
  p.torso = (0.818 - 0.530) * stature_m;
  p.neck = 0.045 * stature_m;
  p.head = (1.0 - 0.818 - 0.045) * stature_m;
  p.upper_arm = 0.160 * stature_m;
  p.forearm = 0.153 * stature_m;
  p.hand = 0.108 * stature_m;
  p.thigh = 0.245 * stature_m;
  p.shank = 0.246 * stature_m;
  p.ankle_height = 0.039 * stature_m;
  p.foot = 0.152 * stature_m;
  p.shoulder_width = 0.205 * stature_m;
  p.hip_width = 0.11 * stature_m;
  p.girth = stature_m / 1.75;
  return p;
}

std::string fillUrdfTemplate(const std::string& template_xml, const std::string& id,
                             const BodyProportions& proportions) {
  if (!isValidId(id))
    throw std::invalid_argument("body id is \"" + id +
                                "\", allowed are letters and digits, a letter first");
  const std::map<std::string, double> names = namesOf(proportions);
  std::string filled;
  size_t at = 0;
  while (true) {
    const size_t open = template_xml.find("${", at);
    filled += template_xml.substr(at, open - at);
    if (open == std::string::npos) return filled;
    const size_t close = template_xml.find('}', open);
    if (close == std::string::npos)
      throw std::invalid_argument("URDF template: a ${ is never closed by }");
    const std::string expression = template_xml.substr(open + 2, close - open - 2);
    filled += expression == "id" ? id : decimal(evaluate(expression, names));
    at = close + 1;
  }
}

}  // namespace markerless_mocap
