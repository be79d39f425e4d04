#include "tools/describe_options/option_pages.h"

#include <array>
#include <charconv>

#include "capture/studio_options.h"
#include "markerless_mocap/pipeline/pipeline.h"
#include "ros/node_options.h"

namespace markerless_mocap {
namespace {

/// The shortest text that reads back as the same number.
std::string text(double number) {
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  return {buffer.data(), end};
}

/// Writes one line of YAML per field, its meaning above it.
class YamlWriter : public OptionVisitor {
 public:
  void field(const char* key, bool& value, const char* meaning) override {
    line(key, value ? "true" : "false", meaning);
  }
  void field(const char* key, int& value, int, int, const char* meaning) override {
    line(key, std::to_string(value), meaning);
  }
  void field(const char* key, double& value, double, double, const char* meaning) override {
    line(key, text(value), meaning);
  }
  void field(const char* key, std::string& value, const std::vector<std::string>&,
             const char* meaning) override {
    line(key, '"' + value + '"', meaning);
  }
  void field(const char* key, std::vector<std::string>& value, const char* meaning) override {
    std::string list;
    for (const std::string& word : value) list += (list.empty() ? "\"" : ", \"") + word + '"';
    line(key, '[' + list + ']', meaning);
  }
  void field(const char* key, Eigen::Vector3d& value, double, double,
             const char* meaning) override {
    line(key, '[' + text(value.x()) + ", " + text(value.y()) + ", " + text(value.z()) + ']',
         meaning);
  }
  const std::string& lines() const { return lines_; }

 private:
  void line(const std::string& key, const std::string& value, const std::string& meaning) {
    lines_ += "  # " + meaning + "\n  " + key + ": " + value + '\n';
  }

  std::string lines_;
};

template <class OptionsT>
std::string tableOf(OptionsT options, const std::string& title = OptionsT::kStage) {
  OptionDescriber describer;
  options.visit(describer);
  return "\n## " + title + "\n\n| key | default | allowed | meaning |\n|---|---|---|---|\n" +
         describer.rows();
}

template <class OptionsT>
std::string nodeTable() {
  return tableOf(OptionsT(), "node " + std::string(OptionsT::kStage));
}

}  // namespace

std::string parameterPage() {
  std::string page =
      "# Parameters\n\n"
      "One section per stage, in the configuration file and as the private parameters of the node "
      "of that\nname. A key that is not listed or a value out of range stops the program with a "
      "sentence that names\nit. This page is the output of `describe_options`.\n";
  PipelineOptions stages;
  forEachStage(stages, [&](const char*, const auto& stage) { page += tableOf(stage); });
  page += tableOf(StudioOptions());
  page +=
      "\n# Parameters of the nodes alone\n\n"
      "Beside the above, in the same private namespace; the launch files set them, a configuration "
      "file does\nnot hold them.\n";
  return page + nodeTable<SilhouetteNodeOptions>() + nodeTable<HullNodeOptions>() +
         nodeTable<FittingNodeOptions>() + nodeTable<StudioNodeOptions>();
}

std::string defaultConfiguration() {
  std::string page =
      "# Every option with its default; what is left out keeps it. The nodes and mocap_offline "
      "read the\n# same file. Written by `describe_options --yaml`; docs/parameters.md has the "
      "allowed ranges.\n";
  PipelineOptions stages;
  forEachStage(stages, [&](const char* section, auto& stage) {
    YamlWriter writer;
    stage.visit(writer);
    page += "\n" + std::string(section) + ":\n" + writer.lines();
  });
  return page;
}

}  // namespace markerless_mocap
