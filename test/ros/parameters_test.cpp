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

TEST(Parameters, NothingSetLeavesTheDefaults) {
  Stage stage;
  loadOptionsTogether(yamlFromXmlRpc(XmlRpc::XmlRpcValue()), "stage", stage);
  EXPECT_DOUBLE_EQ(stage.pitch, 0.03);
}

}  // namespace
}  // namespace markerless_mocap
