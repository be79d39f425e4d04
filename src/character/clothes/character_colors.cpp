#include "character/clothes/character_colors.h"

#include <cmath>
#include <random>
#include <vector>

#include "character/body/signed_distance.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;
using Palette = std::vector<Vector3d>;

const Palette kSkin{
    {.91, .74, .64}, {.84, .64, .52}, {.72, .51, .38}, {.50, .33, .23}, {.34, .22, .16}};
const Palette kHair{
    {.09, .07, .06}, {.24, .15, .09}, {.42, .27, .14}, {.68, .53, .30}, {.48, .46, .44}};
const Palette kShirt{{.72, .16, .15}, {.16, .30, .58}, {.20, .45, .27}, {.86, .84, .78},
                     {.78, .58, .16}, {.35, .20, .42}, {.20, .21, .24}, {.25, .55, .60}};
const Palette kTrousers{
    {.15, .19, .30}, {.13, .13, .14}, {.42, .37, .28}, {.33, .34, .36}, {.30, .21, .15}};
const Palette kShoes{{.08, .07, .07}, {.32, .19, .10}, {.75, .75, .74}};

const Vector3d& pick(const Palette& palette, std::mt19937_64& random) {
  return palette[random() % palette.size()];
}

/// Smooth noise of about -1 to 1 with a grain of `size` metres.
double grain(const Vector3d& p, double size) {
  const Vector3d q = p / size;
  return (std::sin(q.x() * 1.7 + 2.1 * std::sin(q.y() * 1.3)) +
          std::sin(q.y() * 1.9 + 1.7 * std::sin(q.z() * 1.1)) +
          std::sin(q.z() * 2.3 + 1.9 * std::sin(q.x() * 1.5))) /
         3.0;
}

}  // namespace

CharacterColors::CharacterColors(uint64_t seed, const HumanSkeleton& skeleton)
    : stature_(skeleton.stature) {
  std::mt19937_64 random(seed);
  base_[size_t(Layer::kSkin)] = pick(kSkin, random);
  base_[size_t(Layer::kHair)] = pick(kHair, random);
  base_[size_t(Layer::kShirt)] = pick(kShirt, random);
  base_[size_t(Layer::kTrousers)] = pick(kTrousers, random);
  base_[size_t(Layer::kSkirt)] = pick(kShirt, random);
  base_[size_t(Layer::kShoes)] = pick(kShoes, random);
  second_ = pick(kShirt, random);
  pattern_ = int(random() % 3);
}

Vector3d CharacterColors::cloth(const Vector3d& p, Layer layer) const {
  Vector3d color = base_[size_t(layer)];
  if (layer == Layer::kShirt && pattern_ > 0) {
    const double rings = std::sin(2.0 * M_PI * p.z() / 0.10);
    const double bars = std::sin(2.0 * M_PI * p.y() / 0.10);
    const double fraction = pattern_ == 1
                                ? ramp(rings, 0.2, 0.3)
                                : 0.5 * ramp(rings, 0.3, 0.4) + 0.5 * ramp(bars, 0.3, 0.4);
    color += 0.6 * fraction * (second_ - color);
  }
  return color * (1.0 + 0.07 * grain(p, 0.05) + 0.05 * grain(p, 0.014));
}

Vector3d CharacterColors::face(const Vector3d& p) const {
  const Vector3d q(p.x(), std::abs(p.y()), p.z());
  const auto near = [&](double y, double z, double half_y, double half_z) {
    const double dy = (q.y() / stature_ - y / 1.75) * 1.75 / half_y;
    const double dz = (q.z() / stature_ - z / 1.75) * 1.75 / half_z;
    return q.x() > 0.03 * stature_ ? 1.0 - ramp(std::sqrt(dy * dy + dz * dz), 1.0, 0.3) : 0.0;
  };
  Vector3d color = base_[size_t(Layer::kSkin)] * (1.0 + 0.03 * grain(p, 0.03));
  color += 0.75 * near(.032, 1.640, .015, .008) * (Vector3d(.12, .10, .10) - color);
  color += 0.7 * near(.033, 1.662, .020, .006) * (base_[size_t(Layer::kHair)] - color);
  color += 0.6 * near(.0, 1.568, .024, .008) * (Vector3d(.62, .25, .24) - color);
  return color;
}

Eigen::Vector3f CharacterColors::colorAt(const Vector3d& p, Layer layer) const {
  const Vector3d color = layer == Layer::kSkin ? face(p) : cloth(p, layer);
  return color.cwiseMax(0.0).cwiseMin(1.0).cast<float>();
}

}  // namespace markerless_mocap
