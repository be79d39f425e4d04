#pragma once

#include <string>

#include "calibration/board.h"

namespace CLI {
class App;
}

namespace markerless_mocap {

/// A board as programs are told of it: a file, and options that replace what the file says.
struct BoardArguments {
  std::string file;
  BoardOptions options;
  CLI::App* app = nullptr;
};

/// Adds --board and one option for each key of a board file.
void describeBoard(CLI::App& app, BoardArguments* arguments);

/// Whether the command line says anything of the board; call after parsing.
bool isBoardDescribed(const BoardArguments& arguments);

/// The board; call after parsing. Throws std::invalid_argument or std::runtime_error.
BoardOptions boardOf(const BoardArguments& arguments);

}  // namespace markerless_mocap
