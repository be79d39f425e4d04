#include "markerless_mocap/body/body_urdf.h"

#include <gtest/gtest.h>

#include "body/body_fixture.h"
#include "body/urdf/expression.h"

namespace markerless_mocap {
namespace {

std::string filled(const std::string& text) {
  return fillUrdfTemplate(text, "person1", BodyProportions::fromStature(2.0));
}

TEST(BodyUrdfTest, fillsIdNamesAndExpressions) {
  EXPECT_EQ(filled("<a n=\"x_${id}\" l=\"${-thigh / 2} 1\"/>"),
            "<a n=\"x_person1\" l=\"-0.245000 1\"/>");
  EXPECT_EQ(filled("nothing to fill"), "nothing to fill");
}

TEST(BodyUrdfTest, evaluatesInTheUsualOrder) {
  const std::map<std::string, double> names{{"a", 2.0}, {"b_1", 3.0}};
  EXPECT_DOUBLE_EQ(evaluate("1 + a * b_1", names), 7.0);
  EXPECT_DOUBLE_EQ(evaluate("(1 + a) * b_1 - -0.5", names), 9.5);
  EXPECT_DOUBLE_EQ(evaluate("8 / 2 / a", names), 2.0);
}

TEST(BodyUrdfTest, badExpressionsAreToldInOneSentence) {
  EXPECT_EQ(errorTextOf([] { filled("${tail}"); }),
            "URDF template: the expression ${tail} has the unknown name tail");
  EXPECT_EQ(errorTextOf([] { filled("${1 / 0}"); }),
            "URDF template: the expression ${1 / 0} has no finite value");
  EXPECT_EQ(errorTextOf([] { filled("${2 * }"); }),
            "URDF template: the expression ${2 * } lacks a number or name");
  EXPECT_EQ(errorTextOf([] { filled("${(1}"); }),
            "URDF template: the expression ${(1} lacks a closing bracket");
  EXPECT_EQ(errorTextOf([] { filled("${1 1}"); }),
            "URDF template: the expression ${1 1} cannot be understood from \"1\" on");
  EXPECT_EQ(errorTextOf([] { filled("a ${thigh"); }), "URDF template: a ${ is never closed by }");
}

TEST(BodyUrdfTest, deepExpressionsAreRefused) {
  for (const char sign : {'(', '-'}) {
    const std::string sentence =
        errorTextOf([&] { evaluate(std::string(1000000, sign) + "1", {}); });
    EXPECT_NE(sentence.find("has more than 100 brackets or signs in each other"),
              std::string::npos);
    EXPECT_LT(sentence.size(), 400u);
  }
  EXPECT_EQ(evaluate(std::string(90, '-') + "2", {}), 2.0);
  std::string sum = "1";
  for (int i = 0; i < 1000; ++i) sum += " + (1)";
  EXPECT_EQ(evaluate(sum, {}), 1001.0);
}

TEST(BodyUrdfTest, hugeStaturesAreToldInFull) {
  EXPECT_NE(errorTextOf([] { BodyProportions::fromStature(1e300); }).find(" m, allowed is 0.5"),
            std::string::npos);
}

TEST(BodyUrdfTest, badIdsAreRefused) {
  for (const char* id : {"", "1a", "a b", "a\"", "a_b", "ä"})
    EXPECT_EQ(
        errorTextOf([&] { fillUrdfTemplate("", id, BodyProportions()); }),
        "body id is \"" + std::string(id) + "\", allowed are letters and digits, a letter first");
}

TEST(BodyUrdfTest, statureIsTheSumOfItsParts) {
  for (const double stature : {0.5, 1.2, 1.75, 2.5}) {
    const BodyProportions p = BodyProportions::fromStature(stature);
    EXPECT_NEAR(p.ankle_height + p.shank + p.thigh + p.torso + p.neck + p.head, stature, 1e-9);
    const BodyModel model = human(p);
    EXPECT_NEAR(model.joint("l_elbow").T_parent_joint.translation().z(), -p.upper_arm, 1e-5);
  }
}

TEST(BodyUrdfTest, impossibleStaturesAreRefused) {
  EXPECT_EQ(errorTextOf([] { BodyProportions::fromStature(0.49); }),
            "stature is 0.490000 m, allowed is 0.5 to 2.5 m");
  EXPECT_NE(errorTextOf([] { BodyProportions::fromStature(2.51); }), "");
  EXPECT_NE(errorTextOf([] { BodyProportions::fromStature(std::stod("nan")); }), "");
}

}  // namespace
}  // namespace markerless_mocap
