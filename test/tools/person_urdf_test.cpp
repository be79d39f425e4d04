#include "tools/common/person_urdf.h"

#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

using PersonUrdf = ToolTest;

TEST_F(PersonUrdf, ATemplateOfNoBodyIsRefused) {
  EXPECT_NE(bodyUrdf("", "anna", 1.7).find("head_anna"), std::string::npos);
  writeText("empty.urdf", "");
  EXPECT_EQ(errorTextOf<std::exception>([&] { bodyUrdf(path("empty.urdf"), "anna", 1.7); }),
            path("empty.urdf") + ": URDF of the body: the text is empty or has no tags");
  writeText("robot.urdf", "<robot name=\"r\"><link name=\"base\"/></robot>");
  EXPECT_EQ(errorTextOf<std::exception>([&] { bodyUrdf(path("robot.urdf"), "anna", 1.7); }),
            path("robot.urdf") + ": URDF of the body: link body_anna is missing");
}

}  // namespace
}  // namespace markerless_mocap
