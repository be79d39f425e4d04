#pragma once

#include <array>
#include <opencv2/core/mat.hpp>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/products/pose_tree.h"
#include "markerless_mocap/products/visual_hull.h"
#include "studies/reproduce/paper.h"

namespace markerless_mocap {

/// BGR, by TreePart.
using TreeColors = std::array<cv::Scalar, kTreePartCount>;
/// Left green, right red.
const TreeColors& sideColors();

/// The hull, the nodes of the tree and its extremities in the person's part of a view; CV_8UC3. A
/// tree that is not valid is grey.
cv::Mat drawTree(const Camera& camera, const VisualHull& hull, const PoseTree& tree,
                 const TreeColors& nodes = sideColors());

/// Hulls, skeletons and pose trees of four frames as one camera sees them, as in Figures 5 and 6:
/// {"jpeg": base64}. Above as published, below with the learned labelling.
Json drawTrees(const Capture& capture, int edge);

}  // namespace markerless_mocap
