#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "segmentation/branch.h"

namespace markerless_mocap {

/// Number of the branch of each node, from 1; 0 if none.
std::vector<int> branchOfNodes(const std::vector<Branch>& branches, size_t nodes);

/// BGR colour of a branch; grey for 0.
cv::Scalar branchColor(int branch);

/// Width and height of a panel, pixels.
constexpr int kPanel = 420;

/// Draws three columns of an embedding, from `first` on, as a point cloud in an oblique view.
/// Missing columns are 0.
cv::Mat drawEmbedding(const Eigen::MatrixXd& vectors, int first, const std::vector<int>& branch);

/// Draws points in the plane (one row each: right, up) as squares of this size, later ones on top.
/// The panel shows all points.
cv::Mat drawPoints(const Eigen::MatrixXd& points, double size,
                   const std::vector<cv::Scalar>& color);

/// Panels side by side, each with a title above.
cv::Mat panelRow(const std::vector<cv::Mat>& panels, const std::vector<std::string>& titles);

}  // namespace markerless_mocap
