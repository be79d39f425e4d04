#include "tools/make_board/board_pdf.h"

#include <gtest/gtest.h>

#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

TEST(BoardPdf, HasTheBoardAtTrueSize) {
  BoardOptions options;
  const Board board(options);
  const Page page = pageFor(board, "A4");
  EXPECT_EQ(page.width, 297);
  const std::string pdf = boardPdf(board, page);
  EXPECT_EQ(pdf.substr(0, 8), "%PDF-1.4");
  EXPECT_NE(pdf.find("/MediaBox [0 0 841.8898 595.2756]"), std::string::npos);
  // A square of 35 mm is 99.2126 points.
  EXPECT_NE(pdf.find("99.2126 99.2126 re"), std::string::npos);
  const size_t table = std::stoul(pdf.substr(pdf.find("startxref\n") + 10));
  EXPECT_EQ(pdf.substr(table, 4), "xref");
}

TEST(BoardPdf, PageThatIsTooSmallIsTold) {
  BoardOptions options;
  options.square = 0.06;
  options.marker = 0.045;
  const Board board(options);
  EXPECT_EQ(errorTextOf([&] { pageFor(board, "A4"); }),
            "the board needs 436 x 332 mm with its margin and ruler, A4 is 297 x 210 mm");
  EXPECT_EQ(errorTextOf([&] { pageFor(board, "100x-1"); }),
            "the board needs 436 x 332 mm with its margin and ruler, the page is 100 x -1 mm");
  EXPECT_EQ(pageFor(board, "A2").width, 594);
  EXPECT_NE(errorTextOf([&] { pageFor(board, "B7"); }).find("there is no page B7"),
            std::string::npos);
}

}  // namespace
}  // namespace markerless_mocap
