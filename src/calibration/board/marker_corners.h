#pragma once

#include <map>
#include <opencv2/aruco.hpp>

#include "calibration/board.h"
#include "calibration/views.h"

namespace markerless_mocap {

/// Corners of the board's markers in the image: by index in Board::markers(), clockwise from the
/// marker's upper left corner.
using FoundMarkers = std::map<size_t, std::vector<cv::Point2f>>;

/// Finds the markers of a board in a grey image whose pattern is dark.
/// \param before where the board was in the image before: it is looked for around it first, which
///   suffices if all of the board is there; nullptr: not known
FoundMarkers findMarkers(const Board& board, const cv::Ptr<cv::aruco::Dictionary>& dictionary,
                         const cv::Mat& grey, const BoardCorners* before);

/// Inner corners of a chessboard next to markers that were found, to a fraction of a pixel.
BoardCorners cornersBetweenMarkers(const Board& board, const FoundMarkers& markers,
                                   const cv::Mat& grey);

/// The markers' own corners, to a fraction of a pixel.
BoardCorners refinedMarkerCorners(const FoundMarkers& markers, const cv::Mat& grey);

}  // namespace markerless_mocap
