#include "markerless_mocap/pipeline/tracker_options.h"

#include <gtest/gtest.h>

#include <set>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

TrackerOptions load(const std::string& yaml) {
  return loadOptions<TrackerOptions>(YAML::Load(yaml));
}

std::string refusal(const std::string& yaml) {
  return errorTextOf([&] { load(yaml); });
}

TEST(TrackerOptions, ReadsItsOwnKeysAndThoseOfAllMethods) {
  const TrackerOptions o = load(
      "{method: fleischmann, measure: false, stature_sigma: 0.02, shape_poses: 12, "
      "stature: 1.6, seed: 7, contour_rays: 400, contour_joint_velocity_sigma: 3.5, "
      "sppso_final_stage_particles: "
      "30}");
  EXPECT_EQ(o.method, "fleischmann");
  EXPECT_FALSE(o.person.measure);
  EXPECT_EQ(o.person.stature_sigma, 0.02);
  EXPECT_EQ(o.person.shape_poses, 12);
  EXPECT_EQ(o.person.stature, 1.6);
  EXPECT_EQ(o.hsiao.seed, 7);
  EXPECT_EQ(o.contour.rays, 400);
  EXPECT_EQ(o.contour.joint_velocity_sigma, 3.5);
  EXPECT_EQ(o.fleischmann.final_stage_particles, 30);
}

TEST(TrackerOptions, DefaultsFollowByContoursAndMeasure) {
  const TrackerOptions o = load("");
  EXPECT_EQ(o.method, "contour");
  EXPECT_TRUE(o.person.measure);
  EXPECT_EQ(o.contour.rays, ContourOptions().rays);
}

TEST(TrackerOptions, RefusalsNameTheKeyAsTheUserWroteIt) {
  EXPECT_EQ(refusal("contour_rays: 5"), "pose_fitting/contour_rays is 5, allowed is 100 to 20000");
  EXPECT_EQ(refusal("method: guess"),
            "pose_fitting/method is \"guess\", allowed is one of contour, hsiao, fleischmann");
  EXPECT_EQ(refusal("shape_poses: 4"), "pose_fitting/shape_poses is 4, allowed is 5 to 300");
  EXPECT_EQ(refusal("rays: 400").rfind("pose_fitting/rays is not an option", 0), 0u);
  EXPECT_EQ(refusal("contour_ray: 400"),
            "pose_fitting/contour_ray is not an option (value 400), did you mean contour_rays?");
}

TEST(TrackerOptions, ValidateFindsWhatWasSetInCode) {
  const auto refused = [](auto change) {
    TrackerOptions options;
    change(options);
    return errorTextOf([&] { options.validate(); });
  };
  EXPECT_EQ(refused([](TrackerOptions&) {}), "");
  EXPECT_EQ(refused([](TrackerOptions& o) { o.contour.sigma = 0; }),
            "pose_fitting/contour_sigma is 0, allowed is 0.001 to 0.1");
  EXPECT_NE(refused([](TrackerOptions& o) {
              o.fleischmann.final_stage_particles = 0;
            }).find("sppso_final_stage_particles"),
            std::string::npos);
  EXPECT_NE(refused([](TrackerOptions& o) { o.person.stature = 9; }).find("stature"),
            std::string::npos);
  EXPECT_NE(refused([](TrackerOptions& o) {
              o.contour.robust_scale_final = 0.5;
            }).find("robust_scale_final"),
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

TEST(TrackerOptions, RefusesAStatureThatNobodyHas) {
  TrackerOptions options;
  options.person.stature = 17.5;
  EXPECT_THROW(options.validate(), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
