#include "tools/convert_calibration/convert_calibration.h"

#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "tools/common/camera_table.h"

namespace markerless_mocap {
namespace {

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

CalibrationFormat outputFormat(const ConversionOptions& options) {
  if (!options.format.empty()) return calibrationFormatNamed(options.format);
  if (endsWith(options.output, ".qca.txt")) return CalibrationFormat::kQualisys;
  if (endsWith(options.output, ".yaml") || endsWith(options.output, ".yml"))
    return CalibrationFormat::kRig;
  throw std::invalid_argument("the name " + options.output +
                              " tells no format (.yaml: a rig file), give one with --to");
}

WorldGuess worldOf(const CalibrationSet& input, const ConversionOptions& options) {
  WorldGuess guess = guessWorld(input);
  if (options.scale_to_metres != 0.0) {
    guess.world.scale_to_metres = options.scale_to_metres;
    guess.unit_reason = "as given";
  }
  if (options.up != "auto") {
    guess.world.up = options.up;
    guess.up_reason = "as given";
  }
  guess.world.validate();
  return guess;
}

/// Gives the size of `options` to cameras without one.
void fillSizes(const ConversionOptions& options, std::vector<CameraCalibration>* rig) {
  int width = 0, height = 0;
  char rest = 0;
  const bool given = !options.size.empty();
  if (given && (std::sscanf(options.size.c_str(), "%dx%d%c", &width, &height, &rest) != 2 ||
                width <= 0 || height <= 0))
    throw std::invalid_argument("size is " + options.size + ", allowed is such as 1280x720");
  for (CameraCalibration& camera : *rig) {
    if (camera.width > 0) continue;
    if (!given && !options.output.empty())
      throw std::invalid_argument("the calibration does not say the image size of " + camera.name +
                                  ", give it with --size, such as --size 1280x720");
    camera.width = width;
    camera.height = height;
  }
}

}  // namespace

Conversion convertCalibration(const ConversionOptions& options) {
  Conversion conversion;
  conversion.input = readCalibration(options.inputs);
  conversion.world = worldOf(conversion.input, options);
  for (const CameraCalibration& camera : conversion.input.cameras)
    conversion.rig.push_back(conversion.world.world.apply(camera));
  fillSizes(options, &conversion.rig);
  conversion.warnings = calibrationWarnings(conversion.rig);
  if (!options.output.empty())
    conversion.written =
        writeCalibration(options.output, outputFormat(options), conversion.rig, options.overwrite);
  return conversion;
}

void print(const Conversion& conversion, std::ostream& out) {
  const WorldGuess& world = conversion.world;
  out << conversion.rig.size() << " cameras from " << titleOf(conversion.input.format)
      << "\nunit: " << world.world.scale_to_metres << " m (" << world.unit_reason
      << "), up: " << world.world.up << " (" << world.up_reason << ")\nin metres, z up:\n";
  printCameras(conversion.rig, out);
  for (const std::string& remark : conversion.input.remarks) out << "note: " << remark << '\n';
  for (const std::string& warning : conversion.warnings) out << "note: " << warning << '\n';
  for (const std::string& file : conversion.written) out << "wrote " << file << '\n';
}

}  // namespace markerless_mocap
