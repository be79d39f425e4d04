#pragma once

#include "calibration/board.h"
#include "calibration/lens.h"
#include "calibration/views.h"

namespace markerless_mocap {

/// First intrinsics of a camera with k1 and k2 from views that differ. Source: Zhang, A flexible
/// new technique for camera calibration (2000), as OpenCV has it. \param views of this camera, at
/// least three
Intrinsics startIntrinsics(const Board& board, const CameraToCalibrate& camera,
                           const std::vector<const BoardView*>& views);

/// First focal length of a fisheye, without distortion and with its axis in the middle: the one of
/// several at which the views show a flat board best. \param views of this camera
Intrinsics startFisheye(const Board& board, const CameraToCalibrate& camera,
                        const std::vector<const BoardView*>& views);

/// At most `count` of the views, spread over places and sizes in the image: each next view is the
/// one that differs most from those chosen before it.
std::vector<size_t> differentViews(const Board& board, const std::vector<const BoardView*>& views,
                                   size_t count);

}  // namespace markerless_mocap
