#pragma once

#include <optional>

namespace CLI {
class App;
}

namespace markerless_mocap {

/// Parses what a program is called with. What cannot be used is printed as a sentence with the name
/// of the program, the option and what it takes; numbers that are not finite cannot.
/// \return exit code if the program is to end, after --help with 0
std::optional<int> parseArguments(CLI::App& app, int argc, char** argv);

}  // namespace markerless_mocap
