#include "markerless_mocap/pipeline/tracker_options.h"

#include <gtest/gtest.h>

#include <set>

#include "error_text_of.h"
#include "markerless_mocap/pipeline/make_body_tracker.h"
#include "option_list.h"

namespace markerless_mocap {
namespace {

TrackerOptions load(const std::string& yaml) {
  return loadOptions<TrackerOptions>(YAML::Load(yaml));
}

std::string errorOf(const std::string& yaml) {
  return errorTextOf([&] { load(yaml); });
}

TEST(TrackerOptions, ReadsItsOwnKeysAndThoseOfAllMethods) {
  const TrackerOptions o = load(
      "{method: fleischmann, measure: false, stature_sigma: 0.02, shape_poses: 12, stature: 1.6, "
      "filter: {enabled: false, cutoff: 2}, contour: {rays: 400, joint_velocity_sigma: 3.5}, "
      "hsiao: {seed: 7, joint_limits: {left_elbow: [-2, 0.1]}}, "
      "fleischmann: {final_stage_particles: 30, downsampling: 2}}");
  EXPECT_EQ(o.method, "fleischmann");
  EXPECT_FALSE(o.person.measure);
  EXPECT_EQ(o.person.stature_sigma, 0.02);
  EXPECT_EQ(o.person.shape_poses, 12);
  EXPECT_EQ(o.person.stature, 1.6);
  EXPECT_FALSE(o.filter.enabled);
  EXPECT_EQ(o.filter.cutoff, 2.0);
  EXPECT_EQ(o.contour.rays, 400);
  EXPECT_EQ(o.contour.joint_velocity_sigma, 3.5);
  EXPECT_EQ(o.hsiao.seed, 7);
  EXPECT_EQ(o.hsiao.joint_limits.lower[8], -2.0);  // theta_9 is the left elbow
  EXPECT_EQ(o.hsiao.joint_limits.upper[8], 0.1);
  EXPECT_EQ(o.fleischmann.swarm.final_stage_particles, 30);
  EXPECT_EQ(o.fleischmann.image.downsampling, 2);
}

TEST(TrackerOptions, DefaultsAreThoseOfTheNestedStructs) {
  const TrackerOptions o = load("");
  EXPECT_EQ(o.method, "contour");
  EXPECT_EQ(valuesOf(o.person), valuesOf(PersonOptions()));
  EXPECT_EQ(valuesOf(o.filter), valuesOf(FilterOptions()));
  EXPECT_EQ(valuesOf(o.contour), valuesOf(ContourOptions()));
  EXPECT_EQ(valuesOf(o.hsiao), valuesOf(HsiaoOptions()));
  EXPECT_EQ(valuesOf(o.fleischmann), valuesOf(FleischmannOptions()));
}

TEST(TrackerOptions, ErrorsNameThePathOfTheKey) {
  EXPECT_EQ(errorOf("contour: {rays: 5}"),
            "pose_fitting/contour/rays is 5, allowed is 100 to 20000");
  EXPECT_EQ(errorOf("method: guess"),
            "pose_fitting/method is \"guess\", allowed is one of contour, hsiao, fleischmann");
  EXPECT_EQ(errorOf("shape_poses: 4"), "pose_fitting/shape_poses is 4, allowed is 5 to 300");
  EXPECT_EQ(errorOf("rays: 400").rfind("pose_fitting/rays is not an option", 0), 0u);
  EXPECT_EQ(errorOf("contour: {ray: 400}"),
            "pose_fitting/contour/ray is not an option (value 400), did you mean rays?");
  EXPECT_EQ(errorOf("hsiao: {joint_limits: {right_knee: [1, 0.5]}}"),
            "pose_fitting/hsiao/joint_limits/right_knee is [1, 0.5], allowed is [min, max] with a "
            "min that is not greater than max");
}

TEST(TrackerOptions, ValidateNamesTheSamePathForWhatWasSetInCode) {
  const auto errorAfter = [](auto change) {
    TrackerOptions options;
    change(options);
    return errorTextOf([&] { options.validate(); });
  };
  EXPECT_EQ(errorAfter([](TrackerOptions&) {}), "");
  EXPECT_EQ(errorAfter([](TrackerOptions& o) { o.contour.ray_sigma = 0; }),
            "pose_fitting/contour/ray_sigma is 0, allowed is 0.001 to 0.1");
  EXPECT_EQ(errorAfter([](TrackerOptions& o) { o.fleischmann.swarm.final_stage_particles = 0; }),
            "pose_fitting/fleischmann/final_stage_particles is 0, allowed is 1 to 10000");
  EXPECT_EQ(errorAfter([](TrackerOptions& o) { o.filter.cutoff = 0; }),
            "pose_fitting/filter/cutoff is 0, allowed is 0.01 to 100");
  EXPECT_EQ(errorAfter([](TrackerOptions& o) { o.person.stature = 17.5; }),
            "pose_fitting/stature is 17.5, allowed is 0.5 to 2.5");
  EXPECT_EQ(errorAfter([](TrackerOptions& o) {
              o.contour.robust_scale_final = 0.5;
            }).rfind("pose_fitting/contour/robust_scale_final is 0.5", 0),
            0u);
}

TEST(TrackerOptions, StagesOfNestedStructsAreTheirPaths) {
  for (const auto& [stage, key] :
       {std::pair{FilterOptions::kStage, "filter"}, std::pair{ContourOptions::kStage, "contour"},
        std::pair{HsiaoOptions::kStage, "hsiao"},
        std::pair{FleischmannOptions::kStage, "fleischmann"},
        std::pair{FleischmannImageOptions::kStage, "fleischmann"}})
    EXPECT_EQ(stage, std::string(TrackerOptions::kStage) + "/" + key);
}

TEST(TrackerOptions, NoTwoFieldsHaveTheSamePath) {
  std::set<std::string> paths;
  for (const auto& entry : optionsOf(TrackerOptions()))
    EXPECT_TRUE(paths.insert(entry.path).second) << entry.path;
  EXPECT_TRUE(paths.count("contour/rays"));
  EXPECT_TRUE(paths.count("stature"));
}

TEST(TrackerNeeds, EachMethodSaysWhatItReads) {
  EXPECT_TRUE(needsOf("contour").masks && !needsOf("contour").images);
  EXPECT_TRUE(!needsOf("hsiao").masks && !needsOf("hsiao").images);
  EXPECT_TRUE(needsOf("fleischmann").masks && needsOf("fleischmann").images);
  EXPECT_TRUE(needsOf("contour").colors);
  EXPECT_TRUE(!needsOf("hsiao").colors && !needsOf("fleischmann").colors);
  EXPECT_EQ(errorTextOf([] { needsOf("guess"); }), "there is no method guess");
}

}  // namespace
}  // namespace markerless_mocap
