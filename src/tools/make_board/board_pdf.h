#pragma once

#include <string>

#include "calibration/board.h"

namespace markerless_mocap {

/// A page, mm.
struct Page {
  double width = 297.0, height = 210.0;
};

/// A4, A3, A2, A1, A0 or letter, lying or standing, whichever holds the board; or "WIDTHxHEIGHT" in
/// mm. Throws std::invalid_argument if there is no such page or if the board with its margin and
/// its ruler does not fit: the message says which page would do.
Page pageFor(const Board& board, const std::string& name);

/// The board as a PDF at true size, with a ruler and its description below. The ruler tells whether
/// a printer has scaled the page.
std::string boardPdf(const Board& board, const Page& page);

}  // namespace markerless_mocap
