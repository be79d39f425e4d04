#include "tools/calibrate_rig/still_board.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "calibration/still_board.h"
#include "text/joined.h"

namespace markerless_mocap {
namespace {

void checkLenses(const CalibrationInput& input) {
  std::string lacking;
  for (const CameraToCalibrate& camera : input.cameras)
    if (!camera.given) addWord(&lacking, camera.name);
  if (!lacking.empty())
    throw std::invalid_argument(
        "the board lies still in all films, which tells where cameras stand whose lenses are "
        "known, "
        "but no lenses: give those of " +
        lacking + " by --lenses, or move the board");
}

void turnAsTheFloorTells(const Board& board, const std::vector<FilmSource>& films,
                         CalibrationInput* input, std::string* remark) {
  std::vector<cv::Mat> images;
  for (const BoardView& view : input->views) {
    const std::string& name = input->cameras[view.camera].name;
    const auto film = std::find_if(films.begin(), films.end(),
                                   [&](const FilmSource& one) { return one.camera == name; });
    images.push_back(imagesOf(*film, 1).front());
  }
  const FloorTurns turns = turnsByFloor(board, input->cameras, input->views, images);
  if (!(turns.certainty >= kCertainTurns)) return;
  for (size_t i = 0; i < input->views.size(); ++i) {
    std::vector<Eigen::Vector2d>& pixels = input->views[i].corners.pixels;
    if (turns.turned[i]) std::reverse(pixels.begin(), pixels.end());
  }
  input->turns_known = true;
  char text[200];
  std::snprintf(text, sizeof text,
                "The board looks the same turned by half a turn; the floor around it tells how it "
                "lies before each camera (%.0f standard deviations).",
                turns.certainty);
  *remark = text;
}

}  // namespace

bool liesStill(const Board& board, const FoundBoards& boards) {
  std::vector<BoardView> views = boards.views;
  return !views.empty() &&
         mergeStillViews(board.corners().size(), board.looksSameTurned(), &views) &&
         views.size() == boards.cameras.size();
}

bool useStillBoard(const std::vector<FilmSource>& films, CalibrationInput* input,
                   std::string* remark) {
  const Board board(input->board);
  const bool same_turned = board.looksSameTurned();
  if (!mergeStillViews(board.corners().size(), same_turned, &input->views)) return false;
  checkLenses(*input);
  input->check_clocks = false;
  input->estimate_offsets = false;
  const bool alone = std::any_of(input->views.begin(), input->views.end(),
                                 [](const BoardView& view) { return view.alone; });
  if (same_turned && !alone) turnAsTheFloorTells(board, films, input, remark);
  return true;
}

}  // namespace markerless_mocap
