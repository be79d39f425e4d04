#include "ros/parameters.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "error_text_of.h"

namespace markerless_mocap {
namespace {

struct Stage {
  static constexpr const char* kStage = "stage";
  double pitch = 0.03;
  bool fast = false;
  Eigen::Vector3d corner{0.0, 0.0, 0.0};
  void visit(OptionVisitor& v) {
    v.field("pitch", pitch, 0.001, 1.0, "");
    v.field("fast", fast, "");
    v.field("corner", corner, -10.0, 10.0, "");
  }
  void validate() const { checkFields(*this); }
};

struct Limits {
  double weight = 1.0, lower = -1.0, upper = 1.0;
  void visit(OptionVisitor& v) {
    v.field("weight", weight, 0.0, 10.0, "");
    v.range("knee", lower, upper, -3.0, 3.0, "");
  }
};

/// Stage with a section that holds a section.
struct DeepStage {
  static constexpr const char* kStage = "stage";
  struct Method {
    int rays = 100;
    Limits limits;
    void visit(OptionVisitor& v) {
      v.field("rays", rays, 10, 1000, "");
      v.section("limits", limits, "");
    }
  } method;
  void visit(OptionVisitor& v) { v.section("method", method, ""); }
  void validate() const { checkFields(*this); }
};

struct OldStage {
  static constexpr const char* kStage = "pose_fitting";
  bool unused = false;
  void visit(OptionVisitor& v) { v.field("unused", unused, ""); }
  void validate() const { checkFields(*this); }
};

struct Node {
  static constexpr const char* kStage = "stage";
  std::vector<std::string> cameras;
  void visit(OptionVisitor& v) { v.field("cameras", cameras, ""); }
  void validate() const { checkFields(*this); }
};

XmlRpc::XmlRpcValue sampleParameters() {
  XmlRpc::XmlRpcValue value;
  value["pitch"] = 0.02;
  value["fast"] = true;
  value["corner"][0] = 1;
  value["corner"][1] = -2.5;
  value["corner"][2] = 3;
  value["cameras"][0] = "cam0";
  value["cameras"][1] = "cam1";
  return value;
}

TEST(Parameters, BinaryDataAreNamed) {
  XmlRpc::XmlRpcValue value = sampleParameters();
  char bytes[] = "abc";
  value["corner"][1] = XmlRpc::XmlRpcValue(bytes, 3);
  EXPECT_EQ(errorTextOf([&] { yamlFromXmlRpc(value, "/stage"); }),
            "/stage/corner is a date or binary data, allowed are texts, numbers, lists and maps");
}

TEST(Parameters, FillSeveralStructsFromOneNamespace) {
  Stage stage;
  Node node;
  loadOptionsTogether(yamlFromXmlRpc(sampleParameters()), "stage", stage, node);
  EXPECT_DOUBLE_EQ(stage.pitch, 0.02);
  EXPECT_TRUE(stage.fast);
  EXPECT_EQ(stage.corner, Eigen::Vector3d(1.0, -2.5, 3.0));
  EXPECT_EQ(node.cameras, (std::vector<std::string>{"cam0", "cam1"}));
}

TEST(Parameters, KeyThatNobodyAsksForIsNamed) {
  XmlRpc::XmlRpcValue value = sampleParameters();
  value["pich"] = 0.05;
  Stage stage;
  Node node;
  const std::string sentence =
      errorTextOf([&] { loadOptionsTogether(yamlFromXmlRpc(value), "/stage", stage, node); });
  EXPECT_NE(sentence.find("/stage/pich is not an option"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("did you mean pitch"), std::string::npos) << sentence;
}

TEST(Parameters, ValueOutOfRangeAndNaNAreRefused) {
  for (const double pitch : {5.0, std::numeric_limits<double>::quiet_NaN()}) {
    XmlRpc::XmlRpcValue value;
    value["pitch"] = pitch;
    Stage stage;
    const std::string sentence =
        errorTextOf([&] { loadOptionsTogether(yamlFromXmlRpc(value), "stage", stage); });
    EXPECT_NE(sentence.find("stage/pitch"), std::string::npos) << sentence;
  }
}

TEST(Parameters, NestedStructsReachTheirSections) {
  XmlRpc::XmlRpcValue value;
  value["method"]["rays"] = 500;
  value["method"]["limits"]["weight"] = 2;  // a whole number where a double is wanted
  value["method"]["limits"]["knee"][0] = 0;
  value["method"]["limits"]["knee"][1] = 1.5;
  value["cameras"][0] = "cam0";
  DeepStage stage;
  Node node;
  loadOptionsTogether(yamlFromXmlRpc(value), "/stage", stage, node);
  EXPECT_EQ(stage.method.rays, 500);
  EXPECT_EQ(stage.method.limits.weight, 2.0);
  EXPECT_EQ(stage.method.limits.lower, 0.0);
  EXPECT_EQ(stage.method.limits.upper, 1.5);
  EXPECT_EQ(node.cameras, std::vector<std::string>{"cam0"});
}

TEST(Parameters, ErrorsInNestedStructsNameThePathBelowTheNode) {
  const auto errorOf = [](const XmlRpc::XmlRpcValue& value) {
    DeepStage stage;
    return errorTextOf([&] { loadOptionsTogether(yamlFromXmlRpc(value), "/a/node", stage); });
  };
  XmlRpc::XmlRpcValue value;
  value["method"]["limits"]["weight"] = 20;
  EXPECT_EQ(errorOf(value), "/a/node/method/limits/weight is 20, allowed is 0 to 10");
  XmlRpc::XmlRpcValue typo;
  typo["method"]["ray"] = 20;
  EXPECT_EQ(errorOf(typo), "/a/node/method/ray is not an option (value 20), did you mean rays?");
}

TEST(Parameters, OldKeyIsFoundUnderAnyNameOfTheNode) {
  OldStage stage;
  XmlRpc::XmlRpcValue value;
  value["contour_rays"] = 900;
  EXPECT_EQ(errorTextOf([&] { loadOptionsTogether(yamlFromXmlRpc(value), "/left/fit", stage); }),
            "/left/fit/contour_rays is now /left/fit/contour/rays");
}

TEST(Parameters, NothingSetLeavesTheDefaults) {
  Stage stage;
  loadOptionsTogether(yamlFromXmlRpc(XmlRpc::XmlRpcValue()), "stage", stage);
  EXPECT_DOUBLE_EQ(stage.pitch, 0.03);
}

}  // namespace
}  // namespace markerless_mocap
