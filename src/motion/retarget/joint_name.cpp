#include "motion/retarget/joint_name.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace markerless_mocap {
namespace {

template <size_t N>
bool isOneOf(const std::array<const char*, N>& words, const std::string& word) {
  return std::any_of(words.begin(), words.end(), [&](const char* w) { return word == w; });
}

// "LeftForeArm" -> Left Fore Arm, "lThigh" -> l Thigh, "LHipJoint" -> L Hip Joint,
// "spine_01" -> spine 01.
std::vector<std::string> cut(const std::string& name) {
  std::vector<std::string> tokens;
  const auto kind = [](unsigned char c) {
    return isupper(c) ? 'A' : islower(c) ? 'a' : isdigit(c) ? '0' : ' ';
  };
  char last = ' ';
  for (size_t i = 0; i < name.size(); ++i) {
    const char now = kind(static_cast<unsigned char>(name[i]));
    const char next = i + 1 < name.size() ? kind(static_cast<unsigned char>(name[i + 1])) : ' ';
    const bool begins_word = now == 'A' && (last == 'a' || next == 'a');
    if (now != ' ') {
      if (last == ' ' || begins_word || (now == '0') != (last == '0')) tokens.emplace_back();
      tokens.back() += char(tolower(static_cast<unsigned char>(name[i])));
    }
    last = now;
  }
  return tokens;
}

bool isHelper(const std::string& token) {
  constexpr std::array<const char*, 15> kHelpers{"ik",      "fk",  "pole",  "target", "ctrl",
                                                 "control", "mch", "twist", "roll",   "twister",
                                                 "tweak",   "nub", "vis",   "parent", "end"};
  return isOneOf(kHelpers, token);
}

bool saysNothing(const std::string& token) {
  constexpr std::array<const char*, 16> kFillers{
      "mixamorig", "bip", "character", "def", "org", "cc", "valve", "biped",
      "bone",      "jnt", "b",         "j",   "jt",  "bn", "bend",  "c"};
  return isOneOf(kFillers, token);
}

// After a bone's name these are a part of it: "ToeBase".
bool isPrefix(const std::string& token) {
  constexpr std::array<const char*, 6> kPrefixes{"base", "armature", "rig", "avg", "m", "f"};
  return isOneOf(kPrefixes, token);
}

// In lower case names the side is joined to the word: "lhand", "leftupleg".
void splitSide(JointName& parsed) {
  constexpr std::array<const char*, 24> kSided{
      "femur",    "tibia", "foot",    "toes",     "clavicle", "humerus", "radius", "wrist",
      "hand",     "thigh", "shin",    "collar",   "shldr",    "forearm", "upleg",  "leg",
      "shoulder", "arm",   "toebase", "upperarm", "lowerarm", "hip",     "uarm",   "farm"};
  for (const char* side : {"left", "right", "l", "r"}) {
    const std::string prefix = side;
    if (parsed.word.compare(0, prefix.size(), prefix) == 0 &&
        isOneOf(kSided, parsed.word.substr(prefix.size()))) {
      parsed.side = prefix[0];
      parsed.word.erase(0, prefix.size());
      return;
    }
  }
}

}  // namespace

JointName parseJointName(const std::string& name) {
  JointName parsed;
  // "rig:Hips" and "Armature|Hips" begin with the rig's name.
  const size_t space = name.find_last_of(":|");
  const std::string own = space == std::string::npos ? name : name.substr(space + 1);
  parsed.helper = own.compare(0, 2, "__") == 0;
  bool numbered = false;
  for (const std::string& token : cut(own)) {
    if (isdigit(static_cast<unsigned char>(token[0]))) {
      if (!numbered) parsed.number = std::atoi(token.c_str());
      numbered = true;
    } else if (token == "l" || token == "left") {
      parsed.side = 'l';
    } else if (token == "r" || token == "right") {
      parsed.side = 'r';
    } else if (isHelper(token)) {
      parsed.helper = true;
    } else if (!saysNothing(token) && !(parsed.word.empty() && isPrefix(token))) {
      parsed.word += token;
    }
  }
  if (parsed.side == ' ') splitSide(parsed);
  return parsed;
}

}  // namespace markerless_mocap
