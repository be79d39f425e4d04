#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "calibration/board.h"
#include "files/text_file.h"
#include "files/toml_text.h"
#include "files/yaml_text.h"

namespace markerless_mocap {
namespace {

template <class ValueT>
ValueT wanted(const toml::table& table, const char* key) {
  if (const auto value = table[key].value<ValueT>()) return *value;
  throw std::invalid_argument(std::string("there is no ") + key + ", or it is of another kind");
}

/// Side of a square in metres: as measured, or as caliscope fits squares into its sheet.
double squareIn(const toml::table& table, const BoardOptions& board) {
  constexpr double kMetresPerInch = 0.0254;
  if (const auto centimetres = table["square_size_override_cm"].value<double>())
    return *centimetres / 100;
  if (const auto centimetres = table["square_size_overide_cm"].value<double>())
    return *centimetres / 100;
  const std::string units = wanted<std::string>(table, "units");
  if (units != "inch" && units != "cm")
    throw std::invalid_argument("units is " + units + ", allowed are inch and cm");
  const double side = std::min(wanted<double>(table, "board_width") / board.columns,
                               wanted<double>(table, "board_height") / board.rows);
  return side * (units == "inch" ? kMetresPerInch : 0.01);
}

/// The charuco.toml of caliscope.
BoardOptions boardInToml(const toml::table& table) {
  BoardOptions board;
  board.columns = wanted<int>(table, "columns");
  board.rows = wanted<int>(table, "rows");
  board.square = squareIn(table, board);
  board.marker = board.square * wanted<double>(table, "aruco_scale");
  board.dictionary = wanted<std::string>(table, "dictionary");
  board.inverted = table["inverted"].value_or(false);
  board.white_first = table["legacy_pattern"].value_or(false);
  return board;
}

bool isToml(const std::string& path) {
  const std::string ending = ".toml";
  return path.size() > ending.size() &&
         path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
}

}  // namespace

BoardOptions readBoard(const std::string& path) {
  const std::string text = readTextFile(path, "the board " + path);
  const bool is_toml = isToml(path);
  const toml::table toml = is_toml ? tomlFrom(text, path) : toml::table();
  const YAML::Node yaml = is_toml ? YAML::Node() : yamlFrom(text, path);
  try {
    BoardOptions board = is_toml ? boardInToml(toml) : loadOptions<BoardOptions>(yaml);
    board.validate();
    return board;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
}

}  // namespace markerless_mocap
