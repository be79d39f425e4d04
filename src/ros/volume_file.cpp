#include "ros/volume_file.h"

#include <stdexcept>

#include "files/yaml_text.h"
#include "markerless_mocap/options/options.h"
#include "ros/package_files.h"

namespace markerless_mocap {
namespace {

/// Reads the options of a volume file only.
class VolumeReader : public OptionReader {
 public:
  using OptionReader::OptionReader;
  void visitField(const OptionField& field) override {
    const std::string key = field.key;
    if (key == "volume" || key == "volume_min" || key == "volume_max")
      OptionReader::visitField(field);
  }
};

YAML::Node listOf(const Eigen::Vector3d& v) {
  YAML::Node list(std::vector<double>(v.data(), v.data() + 3));
  list.SetStyle(YAML::EmitterStyle::Flow);
  return list;
}

}  // namespace

std::string volumeText(const HullOptions& options) {
  YAML::Node root;
  YAML::Node section = root[HullOptions::kStage];
  section["volume"] = options.volume;
  section["volume_min"] = listOf(options.volume_min);
  section["volume_max"] = listOf(options.volume_max);
  return YAML::Dump(root) + "\n";
}

HullOptions withVolumeOf(const std::string& file, const HullOptions& options) {
  const std::string text = readText(file);
  try {
    const YAML::Node root = yamlFrom(text, file);
    OptionReader whole(root, file);
    whole.allow(HullOptions::kStage);
    whole.finish();
    HullOptions changed = options;
    VolumeReader reader(root[HullOptions::kStage], file + "/" + HullOptions::kStage,
                        HullOptions::kStage);
    changed.visit(reader);
    reader.finish();
    changed.validate();
    return changed;
  } catch (const YAML::Exception& error) {
    throw std::invalid_argument(file + ": " + sentenceOf(error));
  }
}

}  // namespace markerless_mocap
