#include <CLI/CLI.hpp>
#include <iostream>

#include "files/whole_file.h"
#include "tools/common/arguments.h"
#include "tools/common/board_arguments.h"
#include "tools/common/run_tool.h"
#include "tools/make_board/board_pdf.h"

using namespace markerless_mocap;

int main(int argc, char** argv) {
  CLI::App app("Writes a calibration board as a PDF at true size, and its board file.",
               "make_board");
  BoardArguments arguments;
  std::string output, page = "A4";
  app.add_option("output", output, "PDF to write; the board file gets the same name with .yaml")
      ->required();
  app.add_option("--page", page, "A4, A3, A2, A1, A0, letter, or WIDTHxHEIGHT in mm")
      ->capture_default_str();
  describeBoard(app, &arguments);
  if (const auto code = parseArguments(app, argc, argv)) return *code;
  return runTool("make_board", [&] {
    const Board board(boardOf(arguments));
    const std::string pdf = boardPdf(board, pageFor(board, page));
    const std::string stem = output.size() > 4 && output.substr(output.size() - 4) == ".pdf"
                                 ? output.substr(0, output.size() - 4)
                                 : output;
    writeWholeFile(stem + ".pdf", pdf);
    writeWholeFile(stem + ".yaml", boardText(board.options()));
    std::cout << "Print " << stem << ".pdf at 100 %, measure its ruler, and glue it to something "
              << "flat. For calibrate_rig: --board " << stem << ".yaml\n";
  });
}
