#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "segmentation/branch.h"

namespace markerless_mocap {

/// Number of the branch each node belongs to, from 1; 0 for none.
std::vector<int> branchOfNodes(const std::vector<Branch>& branches, size_t nodes);

/// BGR colour of a branch; grey for 0.
cv::Scalar branchColor(int branch);

/// A square panel of so many pixels.
constexpr int kPanel = 420;

/// Three columns of an embedding from `first` on as a cloud seen from between its axes, which start
/// at the origin. Columns that are not there count as 0.
cv::Mat drawEmbedding(const Eigen::MatrixXd& vectors, int first, const std::vector<int>& branch);

/// Points in the plane (a row each, right and up) as squares of that size, the later over the
/// earlier; the frame holds all.
cv::Mat drawPoints(const Eigen::MatrixXd& points, double size,
                   const std::vector<cv::Scalar>& color);

/// Panels side by side, a title over each.
cv::Mat panelRow(const std::vector<cv::Mat>& panels, const std::vector<std::string>& titles);

}  // namespace markerless_mocap
