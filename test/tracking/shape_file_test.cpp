#include "markerless_mocap/tracking/shape_file.h"

#include <gtest/gtest.h>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

ShapeParameters someone() {
  ShapeParameters shape = ShapeStatistics::handMade().meanShape(1.68);
  shape[BodyLength::kThigh] = 0.412345;
  shape[offsetIndex(BodyCone::kYoke, 1) + 2] = -0.0123;
  return shape;
}

/// someone() with the line of one size replaced; an empty line takes it out.
std::string with(const std::string& size, const std::string& line) {
  std::string text = shapeToYaml(someone());
  const size_t at = text.find("\n" + size + ": ") + 1;
  text.replace(at, text.find('\n', at) + 1 - at, line.empty() ? "" : line + "\n");
  return text;
}

std::string refusal(const std::string& yaml) {
  return errorTextOf([&] { shapeFromYaml(yaml, "anna.yaml"); });
}

TEST(SizesFile, GivesBackWhatWasWrittenToAMicrometre) {
  const ShapeParameters read = shapeFromYaml(shapeToYaml(someone()), "anna.yaml");
  EXPECT_LT((read - someone()).cwiseAbs().maxCoeff(), 0.51e-6);
  EXPECT_EQ(read[BodyLength::kThigh], 0.412345);
  EXPECT_EQ(read[offsetIndex(BodyCone::kYoke, 1) + 2], -0.0123);
  EXPECT_EQ(shapeToYaml(read), shapeToYaml(someone()));
}

TEST(SizesFile, HasOneLineForEachSizeBelowItsMeaning) {
  const std::string text = shapeToYaml(someone());
  EXPECT_EQ(text.rfind("# Body shape of one person, metres", 0), 0u);
  EXPECT_NE(text.find("\nthigh: 0.412345\n"), std::string::npos);
  size_t lines = 0;
  for (size_t at = 0; (at = text.find('\n', at)) != std::string::npos; ++at)
    if (text[at + 1] != '#' && at + 1 < text.size()) ++lines;
  EXPECT_EQ(lines, size_t(kShapeParameterCount));
}

TEST(SizesFile, RefusesWhatIsNoMapOfSizes) {
  EXPECT_EQ(refusal("[1, 2]"), "anna.yaml must map names of shape parameters to metres");
  EXPECT_EQ(refusal(""), "anna.yaml must map names of shape parameters to metres");
  EXPECT_EQ(refusal("thigh: [").rfind("anna.yaml is no YAML: ", 0), 0u);
}

TEST(SizesFile, RefusesASizeThatIsMissingOrUnknown) {
  EXPECT_EQ(refusal(with("thigh", "")), "anna.yaml lacks the shape parameter thigh");
  EXPECT_EQ(refusal(shapeToYaml(someone()) + "tail: 0.3\n"),
            "anna.yaml has the unknown shape parameter tail");
}

TEST(SizesFile, RefusesWhatNoBodyMeasures) {
  const std::string positive = "anna.yaml: thigh must be a positive number of metres";
  for (const char* line : {"thigh: 0", "thigh: -0.4", "thigh: .nan", "thigh: .inf", "thigh: long",
                           "thigh: [0.4]", "thigh:"})
    EXPECT_EQ(refusal(with("thigh", line)), positive) << line;
  EXPECT_EQ(refusal(with("chest_cone/b/radius", "chest_cone/b/radius: 0")),
            "anna.yaml: chest_cone/b/radius must be a positive number of metres");
}

TEST(SizesFile, AnOffsetMayBeNegativeButMustBeANumber) {
  const std::string name = "thigh_cone/b/offset_x";
  EXPECT_EQ(
      shapeFromYaml(with(name, name + ": -0.02"), "anna.yaml")[offsetIndex(BodyCone::kThigh, 1)],
      -0.02);
  EXPECT_EQ(refusal(with(name, name + ": wide")),
            "anna.yaml: thigh_cone/b/offset_x must be a number of metres");
}

TEST(SizesFile, PartsOfNoPersonAreRefused) {
  EXPECT_EQ(refusal(with("thigh", "thigh: 1000")),
            "anna.yaml: thigh is 1000 m, allowed are up to 2 m");
}

TEST(StatureOf, IsTheSumFromFloorToCrown) {
  EXPECT_NEAR(statureOf(ShapeStatistics::handMade().meanShape(1.68)), 1.68, 0.005);
  ShapeParameters shape = someone();
  shape[BodyLength::kShank] += 0.03;
  shape[BodyLength::kForearm] += 0.5;  // hangs beside
  EXPECT_NEAR(statureOf(shape) - statureOf(someone()), 0.03, 1e-12);
}

}  // namespace
}  // namespace markerless_mocap
