#include "character/clothes/dressed_shape.h"

#include <algorithm>
#include <cmath>

#include "character/body/signed_distance.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;
using Sections = std::vector<LoftSection>;

constexpr LoftAxes kUpwards{2, 1, 0}, kSideways{1, 2, 0};
constexpr double kNone = 1e3;  ///< distance to a layer that is not worn, m

/// Cross-sections of cloth that hangs from the widest section of the body above.
/// \param from first section of the body that carries it, counted from the top
/// \param fraction of that width that remains below
Sections hanging(Sections body, size_t from, double fraction) {
  LoftSection widest;
  for (size_t i = body.size() - from; i-- > 0;) {
    for (double LoftSection::*field :
         {&LoftSection::side, &LoftSection::front, &LoftSection::back}) {
      widest.*field = std::max(widest.*field, body[i].*field);
      body[i].*field = std::max(body[i].*field, fraction * widest.*field);
    }
  }
  return body;
}

void widen(LoftSection& s, double side, double front, double back) {
  s.side += side;
  s.front += front;
  s.back += back;
}

/// A wide shirt, with a gap of about 8 cm to the body below the chest.
Sections shirtSections(const BodyBuild& build) {
  Sections rows = hanging(torsoSections(build), 2, 1.0);
  const double chest = build.length(1.35, 1.27), hem = build.length(0.83, 0.79);
  for (LoftSection& row : rows) {
    const double down = std::clamp((chest - row.at) / (chest - hem), 0.0, 1.0);
    const double air = build.length(1, 0.95) * (0.010 + 0.030 * down);
    widen(row, air, air, air);
  }
  return rows;
}

/// From the shoulder to the middle of the forearm, slightly hanging down.
Sections sleeveSections(const BodyBuild& build) {
  Sections rows = armSections(build);
  std::reverse(rows.begin(), rows.end());
  rows = hanging(rows, 0, 0.97);
  std::reverse(rows.begin(), rows.end());
  for (LoftSection& row : rows) {
    const double along = std::clamp(row.at / build.length(0.4, 0.37), 0.0, 1.0);
    const double air = build.length(1, 0.95) * (0.010 + 0.016 * along);
    widen(row, air, air, air);
    row.side_centre -= 0.6 * air * along;
  }
  return rows;
}

Sections trouserSections(const BodyBuild& build) {
  Sections rows = hanging(legSections(build), 0, 0.90);
  for (LoftSection& row : rows) {
    const double air = build.length(0.014, 0.013);
    widen(row, air, air, air);
  }
  return rows;
}

/// A bell shape from the waist to below the knee.
Sections skirtSections(const BodyBuild& build) {
  const double waist = build.length(1.08, 1.02), hem = build.length(0.44, 0.415);
  Sections rows;
  for (const LoftSection& row : hanging(torsoSections(build), 0, 1.0))
    if (row.at <= waist) rows.push_back(row);
  rows.insert(rows.begin(), rows.front());
  rows.front().at = hem;
  for (LoftSection& row : rows) {
    const double down = std::clamp((waist - row.at) / (waist - hem), 0.0, 1.0);
    const double flare = build.length(1, 0.95) * down;
    widen(row, 0.006 + 0.075 * flare, 0.006 + 0.105 * flare, 0.006 + 0.09 * flare);
  }
  return rows;
}

/// Long hair behind the head and on the back; metres for the woman of 1.65 m.
Sections hairFall(const BodyBuild& build) {
  const double f = build.stature / 1.65, back = f * 0.012 * build.fatness;
  Sections rows{{1.270, 0, -.128, .050, .012, .012}, {1.310, 0, -.122, .078, .022, .020},
                {1.370, 0, -.098, .090, .030, .026}, {1.430, 0, -.070, .088, .034, .036},
                {1.490, 0, -.048, .084, .036, .052}, {1.550, 0, -.030, .083, .040, .072},
                {1.610, 0, -.012, .070, .045, .080}};
  for (LoftSection& row : rows)
    row = {row.at * f, 0, row.front_centre * f - back, row.side * f, row.front * f, row.back * f};
  return rows;
}

}  // namespace

DressedShape::DressedShape(const BodyShape& body, const CharacterOptions& options)
    : body_(body),
      loose_(options.clothes == "loose"),
      bare_legs_(options.clothes == "skirt"),
      long_hair_(options.hair == "long") {
  const BodyBuild& build = body.build();
  if (loose_) {
    shirt_.emplace(kUpwards, shirtSections(build), 0.2, 0.015);
    sleeve_.emplace(kSideways, sleeveSections(build), 0.0, 0.01);
    trouser_.emplace(kUpwards, trouserSections(build), 0.1, 0.01);
  }
  if (bare_legs_) skirt_.emplace(kUpwards, skirtSections(build), 0.0, 0.012);
  if (long_hair_) fall_.emplace(kUpwards, hairFall(build), 0.2, 0.015);
}

double DressedShape::shirt(const Vector3d& p, const PartDistances& parts) const {
  const HumanSkeleton& s = body_.skeleton();
  const Vector3d neck = s.headOf(Bone::kNeck), elbow = s.headOf(Bone::kLeftForearm);
  const double round = 0.008, womanly = 1.0 - body_.build().male;
  const double sleeve_end = elbow.y() + (loose_ ? length(.09, .08) : -length(.10, .09));
  const double hem = loose_ ? length(.83, .79) : length(.945, .892);
  double d = body_.torsoAndArm(parts) - (loose_ ? 0.008 : 0.007);
  if (loose_) {
    const double chest = length(1.19, 1.12);
    const double cloth = smoothUnion(shirt_->distance(p), sleeve_->distance(p), length(.06, .055));
    const double fold = 0.004 * std::sin(34.0 * p.z() + 9.0 * p.x() + 4.0 * std::sin(17 * p.y())) +
                        0.003 * std::sin(41.0 * p.y() - 23.0 * p.x() + 11.0 * p.z());
    d = smoothUnion(smoothIntersection(d, chest - p.z(), 0.05), cloth + fold, 0.03);
  }
  const double collar = p.z() + 0.5 * (p.x() - neck.x()) - neck.z() - length(.022, .012);
  const double scoop =
      ellipsoid(p, neck + Vector3d(length(.045, .045), 0, length(.012, .010)),
                length(1, .95) * Vector3d(.060, .075 + .01 * womanly, .060 + .02 * womanly));
  d = smoothIntersection(smoothIntersection(d, collar, round), -scoop, round);
  d = smoothIntersection(d, p.y() - sleeve_end, round);
  return smoothIntersection(d, hem - p.z(), round);
}

double DressedShape::trousers(const Vector3d& p, const PartDistances& parts) const {
  const double waist = length(1.03, 0.985);
  double d = body_.torsoAndLeg(parts) - 0.004;
  if (loose_) {
    const double fold = 0.004 * std::sin(29.0 * p.z() + 13.0 * p.x()) +
                        0.003 * std::sin(47.0 * p.z() - 31.0 * p.y());
    const double cloth = smoothIntersection(trouser_->distance(p) + fold, 0.006 - p.y(), 0.008);
    d = smoothUnion(d, cloth, 0.02);
  }
  d = smoothIntersection(d, length(loose_ ? .030 : .080, loose_ ? .028 : .075) - p.z(), 0.008);
  return smoothIntersection(d, p.z() - waist, 0.008);
}

double DressedShape::skirt(const Vector3d& p) const {
  const double waist = length(1.05, 0.995), hem = length(0.45, 0.425);
  const double down = std::clamp((waist - p.z()) / (waist - hem), 0.0, 1.0);
  const double pleat = 0.012 * down * std::cos(9.0 * std::atan2(p.y(), p.x()));
  double d = smoothIntersection(skirt_->distance(p) + pleat, hem - p.z(), 0.01);
  return smoothIntersection(d, p.z() - waist, 0.008);
}

double DressedShape::hair(const Vector3d& p, const PartDistances& parts) const {
  const auto f = [this](double man) { return length(man, man * 1.65 / 1.75); };
  const double hairline = p.x() - f(.018) - 0.68 * (p.z() - f(1.60));
  const double nape = f(1.565) + 0.45 * std::max(p.x(), -0.07) - p.z();
  double d = smoothIntersection(parts.head - f(.012), hairline, f(.012));
  d = smoothIntersection(d, nape, f(.012));
  return long_hair_ ? smoothUnion(d, fall_->distance(p), f(.03)) : d;
}

std::array<double, kLayerCount> DressedShape::layers(const Vector3d& p) const {
  const Vector3d half(p.x(), std::abs(p.y()), p.z());
  const PartDistances parts = body_.parts(half);
  const double cuff = length(.085, .08);
  std::array<double, kLayerCount> d;
  d[size_t(Layer::kSkin)] = body_.whole(parts);
  d[size_t(Layer::kShirt)] = shirt(half, parts);
  d[size_t(Layer::kTrousers)] = bare_legs_ ? kNone : trousers(half, parts);
  d[size_t(Layer::kSkirt)] = bare_legs_ ? skirt(half) : kNone;
  const double shoe = smoothUnion(parts.foot, parts.leg, length(.03, .028)) - 0.003;
  d[size_t(Layer::kShoes)] = smoothIntersection(shoe, half.z() - cuff, 0.008);
  d[size_t(Layer::kHair)] = hair(half, parts);
  return d;
}

double DressedShape::distance(const Vector3d& p) const {
  const std::array<double, kLayerCount> d = layers(p);
  return std::max(*std::min_element(d.begin(), d.end()), -p.z());
}

Layer DressedShape::layerAt(const Vector3d& p) const {
  const std::array<double, kLayerCount> d = layers(p);
  return Layer(std::min_element(d.begin(), d.end()) - d.begin());
}

}  // namespace markerless_mocap
