#pragma once

#include <vector>

#include "character/body/loft.h"

namespace markerless_mocap {

/// Parameters from which a person's cross-sections are computed.
struct BodyBuild {
  double stature = 1.75;  ///< metres
  double male = 1.0;      ///< 0 to 1
  double fatness = 0.0;   ///< 0: average, 1: very heavy, negative: thin

  /// Interpolates a length that is given for the man of 1.75 m and the woman of 1.65 m.
  double length(double man, double woman) const {
    return stature * (male * man / 1.75 + (1.0 - male) * woman / 1.65);
  }
};

/// The fatness of a person of this sex and stature with a weight of bmi * stature^2.
double fatnessOf(double bmi, double stature, double male);

// Cross-sections of the parts, metres. Torso, neck, head and leg run upwards with their front to
// +x; for the leg, side 0 is the middle of the body. The arm runs from the shoulder along +y, the
// hand from the wrist; their side is z, their front x. The foot runs along +x from below the ankle;
// its side is y from the middle of the leg, its front z from the floor.
std::vector<LoftSection> torsoSections(const BodyBuild& build);
std::vector<LoftSection> neckSections(const BodyBuild& build);
std::vector<LoftSection> headSections(const BodyBuild& build);
std::vector<LoftSection> legSections(const BodyBuild& build);
std::vector<LoftSection> armSections(const BodyBuild& build);
std::vector<LoftSection> handSections(const BodyBuild& build);
std::vector<LoftSection> footSections(const BodyBuild& build);

}  // namespace markerless_mocap
