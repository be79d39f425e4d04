#include <gtest/gtest.h>

#include "body/body_fixture.h"

namespace markerless_mocap {
namespace {

std::string refusal(const std::string& urdf) {
  return errorTextOf([&] { BodyModel::fromUrdf(urdf, "person1"); });
}

TEST(UrdfReaderTest, garbageIsRefused) {
  const std::string no_xml = "URDF of the body: the text is no XML from line ";
  EXPECT_EQ(refusal(""), "URDF of the body: the text is empty or has no tags");
  EXPECT_EQ(refusal("no xml at all"), no_xml + "1 on: text stands where a tag belongs");
  EXPECT_EQ(refusal(humanUrdf().substr(0, 4000)).rfind(no_xml, 0), 0u);
  EXPECT_EQ(refusal("<robot name=\"a\">\n<link name=\"b\">\n</joint></robot>"),
            no_xml + "2 on: a tag has no end, or that of another");
  EXPECT_EQ(refusal("<robot name=\"a\">\n<link name=\"b/></robot>"),
            no_xml + "2 on: an attribute is not NAME=\"VALUE\", or stands twice");
  EXPECT_EQ(refusal("<robot name=\"a\"/>").rfind("URDF of the body: the text is XML, but no", 0),
            0u);
}

std::string repeated(const std::string& text, int times) {
  std::string out;
  for (int i = 0; i < times; ++i) out += text;
  return out;
}

TEST(UrdfReaderTest, textsOfTooManyTagsAreRefusedBeforeTheyAreRead) {
  EXPECT_EQ(refusal(repeated("<a>", 300000)),
            "URDF of the body: it has 300000 tags, allowed are 10000");
  const std::string too_deep =
      "URDF of the body: the text is no XML from line 1 on: tags nest too deep";
  EXPECT_EQ(refusal("<robot name=\"a\">" + repeated("<a>", 9999)), too_deep);
  EXPECT_EQ(
      refusal("<robot name=\"a\">" + repeated("<a>", 4990) + repeated("</a>", 4990) + "</robot>"),
      too_deep);
}

/// The body with more links: link<i> hangs on `parent(i)`.
template <class Parent>
std::string withLinks(int count, const Parent& parent) {
  std::string more;
  for (int i = 0; i < count; ++i) {
    const std::string n = std::to_string(i);
    more += "<link name=\"link" + n + "\"/><joint name=\"joint" + n +
            "\" type=\"fixed\"><parent link=\"" + parent(i) + "\"/><child link=\"link" + n +
            "\"/></joint>";
  }
  return replaced(humanUrdf(), "</robot>", more + "</robot>");
}

TEST(UrdfReaderTest, chainsAndStarsOfLinksAreReadOrRefused) {
  const auto chain = [](int i) { return i ? "link" + std::to_string(i - 1) : "head_person1"; };
  const auto star = [](int) { return std::string("head_person1"); };
  EXPECT_EQ(refusal(withLinks(1000, chain)), "");
  EXPECT_EQ(refusal(withLinks(1000, star)), "");
  EXPECT_NE(refusal(withLinks(100000, chain)).find("tags, allowed are 10000"), std::string::npos);
  EXPECT_NE(refusal(withLinks(100000, star)).find("tags, allowed are 10000"), std::string::npos);
}

TEST(UrdfReaderTest, linksThatHangOnTwoJointsAreRefused) {
  const auto chain = [](int i) { return i ? "link" + std::to_string(i - 1) : "head_person1"; };
  const std::string again =
      "<joint name=\"again\" type=\"fixed\"><parent link=\"link0\"/><child link=\"link1\"/>"
      "</joint>";
  EXPECT_EQ(refusal(replaced(withLinks(3, chain), "</robot>", again + "</robot>")),
            "URDF of the body: link link1 is the child of more than one joint");
  const std::string cycle =
      "<joint name=\"cycle\" type=\"fixed\"><parent link=\"link2\"/><child link=\"link0\"/>"
      "</joint>";
  EXPECT_EQ(refusal(replaced(withLinks(3, chain), "</robot>", cycle + "</robot>")),
            "URDF of the body: link link0 is the child of more than one joint");
}

TEST(UrdfReaderTest, bodyOfAnotherIdIsRefused) {
  EXPECT_EQ(errorTextOf([] { BodyModel::fromUrdf(humanUrdf(), "person2"); }),
            "URDF of the body: link body_person2 is missing");
}

TEST(UrdfReaderTest, missingJointIsNamed) {
  EXPECT_EQ(refusal(replaced(humanUrdf(), "\"l_knee_person1\" type", "\"knee_person1\" type")),
            "URDF of the body: joint l_knee_person1 is missing");
}

TEST(UrdfReaderTest, missingLinkIsNamed) {
  std::string urdf = replaced(humanUrdf(), "link name=\"r_wrist_person1\"", "link name=\"hand\"");
  urdf = replaced(urdf, "child link=\"r_wrist_person1\"", "child link=\"hand\"");
  EXPECT_EQ(refusal(urdf), "URDF of the body: link r_wrist_person1 is missing");
}

TEST(UrdfReaderTest, fixedKneeIsRefused) {
  EXPECT_EQ(refusal(replaced(humanUrdf(), "\"r_knee_person1\" type=\"revolute\"",
                             "\"r_knee_person1\" type=\"fixed\"")),
            "URDF of the body: joint r_knee_person1 must be revolute");
}

TEST(UrdfReaderTest, emptyLimitIsRefused) {
  EXPECT_EQ(refusal(replaced(humanUrdf(), "upper=\"1.4\"", "upper=\"-0.6\"")),
            "URDF of the body: joint waist_person1 must have a lower limit below its upper limit");
}

TEST(UrdfReaderTest, shapeIsReadAsRoundCones) {
  const std::string chest = "<link name=\"waist_person1\"/>";
  const std::string with_capsule =
      "<link name=\"waist_person1\">"
      "<visual><origin xyz=\"0 0 0.5\"/><geometry><cylinder radius=\"0.1\" length=\"0.4\"/>"
      "</geometry><material name=\"skin\"/></visual>"
      "<visual><origin xyz=\"0 0 0.7\"/><geometry><sphere radius=\"0.1\"/></geometry></visual>"
      "<visual><origin xyz=\"0 0 0.9\"/><geometry><sphere radius=\"0.2\"/></geometry></visual>"
      "<visual><geometry><box size=\"1 1 1\"/></geometry></visual></link>";
  const BodyModel model =
      BodyModel::fromUrdf(replaced(humanUrdf(), chest, with_capsule), "person1");
  std::vector<RoundCone> cones;
  for (const RoundCone& cone : model.shape())
    if (cone.link == model.linkIndex("waist")) cones.push_back(cone);
  ASSERT_EQ(cones.size(), 2u);  // the sphere in the cylinder's rounded end and the box are left out
  EXPECT_TRUE(cones[0].a.isApprox(Eigen::Vector3d(0, 0, 0.7)));
  EXPECT_TRUE(cones[0].b.isApprox(Eigen::Vector3d(0, 0, 0.3)));
  EXPECT_FLOAT_EQ(cones[0].rgb.x(), 0.86f);
  EXPECT_EQ(cones[1].a, cones[1].b);
  EXPECT_DOUBLE_EQ(cones[1].radius_a, 0.2);
}

TEST(UrdfReaderTest, anklesMayBeFixed) {
  const int all = BodyModel::fromUrdf(humanUrdf(), "person1").angleCount();
  const BodyModel fixed =
      BodyModel::fromUrdf(replaced(humanUrdf(), "\"l_ankle_person1\" type=\"revolute\"",
                                   "\"l_ankle_person1\" type=\"fixed\""),
                          "person1");
  EXPECT_EQ(fixed.angleCount(), all - 1);
  EXPECT_EQ(refusal(replaced(humanUrdf(), "\"l_ankle_person1\" type=\"revolute\"",
                             "\"l_ankle_person1\" type=\"continuous\"")),
            "URDF of the body: joint l_ankle_person1 must be revolute or fixed");
}

TEST(UrdfReaderTest, theJointsThatTheRepLacksAreOptional) {
  std::string urdf = humanUrdf();
  for (const char* name : {"r_waist", "l_y_clavicle", "r_y_clavicle"}) {
    const std::string joint = std::string(name) + "_person1\" type=\"";
    urdf = replaced(urdf, joint + "revolute", "fixed_" + joint + "fixed");
  }
  EXPECT_EQ(BodyModel::fromUrdf(urdf, "person1").angleCount(), 24);
}

}  // namespace
}  // namespace markerless_mocap
