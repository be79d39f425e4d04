#include <CLI/CLI.hpp>
#include <iostream>

#include "tools/common/arguments.h"
#include "tools/describe_options/option_pages.h"

int main(int argc, char** argv) {
  CLI::App app("Prints the manual of all parameters.", "describe_options");
  bool yaml = false;
  app.add_flag("--yaml", yaml, "print a configuration file with all defaults instead");
  if (const auto code = markerless_mocap::parseArguments(app, argc, argv)) return *code;
  std::cout << (yaml ? markerless_mocap::allOptionsPage() : markerless_mocap::parameterPage());
  return 0;
}
