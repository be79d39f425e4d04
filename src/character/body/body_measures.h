#pragma once

#include <vector>

#include "character/body/loft.h"

namespace markerless_mocap {

/// What a person's sections are mixed from.
struct BodyBuild {
  double stature = 1.75;  ///< metres
  double male = 1.0;      ///< 0 to 1
  double fatness = 0.0;   ///< 0 is average, 1 very heavy, negative thin

  /// A length given for the man of 1.75 m and the woman of 1.65 m.
  double length(double man, double woman) const {
    return stature * (male * man / 1.75 + (1.0 - male) * woman / 1.65);
  }
};

/// The fatness at which a person of that sex and stature weighs bmi * stature^2.
double fatnessOf(double bmi, double stature, double male);

// Sections of the parts, metres. The torso, neck, head and leg run upwards, with their front to
// +x and, for the leg, the middle of the body at side 0. The arm runs from the shoulder, the hand
// from the wrist, along +y, their side is z and front x. The foot runs along +x from below the
// ankle, its side is y from the middle of the leg, front z from the floor.
std::vector<LoftSection> torsoSections(const BodyBuild& build);
std::vector<LoftSection> neckSections(const BodyBuild& build);
std::vector<LoftSection> headSections(const BodyBuild& build);
std::vector<LoftSection> legSections(const BodyBuild& build);
std::vector<LoftSection> armSections(const BodyBuild& build);
std::vector<LoftSection> handSections(const BodyBuild& build);
std::vector<LoftSection> footSections(const BodyBuild& build);

}  // namespace markerless_mocap
