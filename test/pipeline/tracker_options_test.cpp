#include "markerless_mocap/pipeline/tracker_options.h"

#include <gtest/gtest.h>

#include <set>

#include "sentence_of.h"

namespace markerless_mocap {
namespace {

TrackerOptions load(const std::string& yaml) {
  return loadOptions<TrackerOptions>(YAML::Load(yaml));
}

std::string refusal(const std::string& yaml) {
  return sentenceOf([&] { load(yaml); });
}

TEST(TrackerOptions, ReadsItsOwnKeysAndThoseOfAllMethods) {
  const TrackerOptions o = load(
      "{method: sppso, measure: false, stature_deviation: 0.02, measuring_poses: 12, "
      "stature: 1.6, seed: 7, contour_rays: 400, contour_turn_rate: 3.5, sppso_last_particles: "
      "30}");
  EXPECT_EQ(o.method, "sppso");
  EXPECT_FALSE(o.measure);
  EXPECT_EQ(o.stature_deviation, 0.02);
  EXPECT_EQ(o.measuring_poses, 12);
  EXPECT_EQ(o.skeleton.stature, 1.6);
  EXPECT_EQ(o.skeleton.seed, 7);
  EXPECT_EQ(o.contour.rays, 400);
  EXPECT_EQ(o.contour.turn_rate, 3.5);
  EXPECT_EQ(o.sppso.last_particles, 30);
}

TEST(TrackerOptions, DefaultsFollowByContoursAndMeasure) {
  const TrackerOptions o = load("");
  EXPECT_EQ(o.method, "contour");
  EXPECT_TRUE(o.measure);
  EXPECT_EQ(o.contour.rays, ContourOptions().rays);
}

TEST(TrackerOptions, RefusalsNameTheKeyAsTheUserWroteIt) {
  EXPECT_EQ(refusal("contour_rays: 5"), "pose_fitting/contour_rays is 5, allowed is 100 to 20000");
  EXPECT_EQ(refusal("method: guess"),
            "pose_fitting/method is \"guess\", allowed is one of contour, skeleton, sppso");
  EXPECT_EQ(refusal("measuring_poses: 4"),
            "pose_fitting/measuring_poses is 4, allowed is 5 to 300");
  EXPECT_EQ(refusal("rays: 400").rfind("pose_fitting/rays is not an option", 0), 0u);
  EXPECT_EQ(refusal("contour_ray: 400"),
            "pose_fitting/contour_ray is not an option (value 400), did you mean contour_rays?");
}

TEST(TrackerOptions, ValidateFindsWhatWasSetInCode) {
  const auto refused = [](auto change) {
    TrackerOptions options;
    change(options);
    return sentenceOf([&] { options.validate(); });
  };
  EXPECT_EQ(refused([](TrackerOptions&) {}), "");
  EXPECT_EQ(refused([](TrackerOptions& o) { o.contour.sigma = 0; }),
            "pose_fitting/contour_sigma is 0, allowed is 0.001 to 0.1");
  EXPECT_NE(
      refused([](TrackerOptions& o) { o.sppso.last_particles = 0; }).find("sppso_last_particles"),
      std::string::npos);
  EXPECT_NE(refused([](TrackerOptions& o) { o.skeleton.stature = 9; }).find("stature"),
            std::string::npos);
  EXPECT_NE(refused([](TrackerOptions& o) { o.contour.outlier_last = 0.5; }).find("outlier_last"),
            std::string::npos);
}

TEST(TrackerOptions, NoTwoFieldsHaveTheSameKey) {
  OptionDescriber describer;
  TrackerOptions().visit(describer);
  std::set<std::string> keys;
  const std::string& rows = describer.rows();
  for (size_t at = 0; at < rows.size(); at = rows.find('\n', at) + 1) {
    const std::string key = rows.substr(at, rows.find(" |", at) - at);
    EXPECT_TRUE(keys.insert(key).second) << key;
  }
  EXPECT_TRUE(keys.count("| `contour_rays`"));
  EXPECT_TRUE(keys.count("| `stature`"));
}

}  // namespace
}  // namespace markerless_mocap
