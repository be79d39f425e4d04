#include "studies/learn_contour_body/learn_contour_body.h"

#include <set>

#include "capture/studio_fixture.h"
#include "motion/human_skeleton.h"
#include "ros/package_files.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

LearnOptions fewInstants() {
  LearnOptions options;
  options.people = 1;
  options.frame_sets = 3;
  options.motions = {"melee"};
  options.files = packageFiles();
  return options;
}

TEST(LearnContourBody, FindsThePersonsOwnLengths) {
  const ShapeStatistics learned = learnContourBody(fewInstants(), nullptr);
  const CharacterOptions who = exampleOf(0);
  const HumanSkeleton bones = HumanSkeleton::adult(who.stature, who.male);
  const ShapeParameters shape = learned.meanShape(who.stature);
  EXPECT_NEAR(shape[BodyLength::kThigh], bones.lengthOf(Bone::kLeftThigh), 0.01);
  EXPECT_NEAR(shape[BodyLength::kForearm], bones.lengthOf(Bone::kLeftForearm), 0.01);
  EXPECT_NEAR(shape[BodyLength::kHipWidth], 2 * bones.headOf(Bone::kLeftThigh).y(), 0.01);
}

TEST(LearnContourBody, ThePackagesTemplateIsAPersons) {
  const std::string text = readText(MOCAP_SOURCE_DIR "/models/contour_body.yaml");
  const ShapeStatistics learned = ShapeStatistics::fromYaml(text, "contour_body.yaml");
  const ShapeStatistics made = ShapeStatistics::handMade();
  for (int i = 0; i < BodyLength::kCount; ++i)
    EXPECT_NEAR(learned.mean[i], made.mean[i], 0.25 * made.mean[i]) << shapeParameterName(i);
  const ContourBody body(learned.meanShape(1.75));
  EXPECT_GT(learned.mean[radiusIndex(BodyCone::kThigh, 0)],
            learned.mean[radiusIndex(BodyCone::kForearm, 1)]);
}

TEST(LearnContourBody, PeopleDiffer) {
  constexpr int kPeople = 40;
  std::set<double> statures;
  for (int i = 0; i < kPeople; ++i) {
    exampleOf(i).validate();  // throws on who cannot be built
    statures.insert(exampleOf(i).stature);
  }
  EXPECT_EQ(statures.size(), size_t(kPeople));
}

TEST(LearnContourBody, NeedsSomebodyToLearnFrom) {
  LearnOptions options = fewInstants();
  options.people = 0;
  EXPECT_EQ(errorTextOf([&] { learnContourBody(options, nullptr); }),
            "at least one person, one motion and one frame are needed");
}

}  // namespace
}  // namespace markerless_mocap
