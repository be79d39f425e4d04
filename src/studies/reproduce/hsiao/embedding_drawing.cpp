#include "studies/reproduce/hsiao/embedding_drawing.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace markerless_mocap {
namespace {

constexpr int kMargin = 24, kTitle = 26;  // pixels
const cv::Scalar kInk(40, 40, 40), kPaper(255, 255, 255);

/// Maps (right, up) to pixels of a panel that shows a box.
class Frame {
 public:
  Frame(const Eigen::Vector2d& low, const Eigen::Vector2d& high) : middle_(0.5 * (low + high)) {
    scale_ = (kPanel - 2 * kMargin) / std::max((high - low).maxCoeff(), 1e-12);
  }
  cv::Point place(const Eigen::Vector2d& at) const {
    const Eigen::Vector2d offset = scale_ * (at - middle_);
    return {int(std::lround(kPanel / 2 + offset.x())), int(std::lround(kPanel / 2 - offset.y()))};
  }
  double scale() const { return scale_; }

 private:
  Eigen::Vector2d middle_;
  double scale_;
};

}  // namespace

std::vector<int> branchOfNodes(const std::vector<Branch>& branches, size_t nodes) {
  std::vector<int> branch(nodes, 0);
  for (size_t b = 0; b < branches.size(); ++b) {
    for (const uint32_t node : branches[b].nodes) branch[node] = int(b) + 1;
  }
  return branch;
}

cv::Scalar branchColor(int branch) {
  static const cv::Scalar kColors[] = {{200, 200, 200}, {60, 60, 220},  {60, 170, 40},
                                       {220, 120, 30},  {30, 170, 230}, {190, 60, 180}};
  return kColors[branch % 6];
}

cv::Mat drawEmbedding(const Eigen::MatrixXd& vectors, int first, const std::vector<int>& branch) {
  Eigen::MatrixXd shown = Eigen::MatrixXd::Zero(vectors.rows(), 3);
  const Eigen::Index count = std::clamp<Eigen::Index>(vectors.cols() - first, 0, 3);
  shown.leftCols(count) = vectors.middleCols(first, count);
  Eigen::Matrix<double, 3, 2> view;
  view << 0.87, -0.35, -0.60, -0.50, 0.05, 0.87;  // right and up of each axis
  const Eigen::MatrixXd flat = shown * view;
  const Eigen::Matrix<double, 3, 2> axes =
      (0.5 * shown.cwiseAbs().colwise().maxCoeff().transpose()).asDiagonal() * view;
  Eigen::MatrixXd all(flat.rows() + 4, 2);
  all << flat, axes, Eigen::RowVector2d::Zero();
  const Frame frame(all.colwise().minCoeff().transpose(), all.colwise().maxCoeff().transpose());
  cv::Mat panel(kPanel, kPanel, CV_8UC3, kPaper);
  for (Eigen::Index node = 0; node < flat.rows(); ++node) {
    cv::circle(panel, frame.place(flat.row(node).transpose()), 2, branchColor(branch[size_t(node)]),
               cv::FILLED, cv::LINE_AA);
  }
  for (int axis = 0; axis < 3; ++axis) {
    const cv::Point end = frame.place(axes.row(axis).transpose());
    cv::arrowedLine(panel, frame.place({0, 0}), end, kInk, 1, cv::LINE_AA, 0, 0.06);
    cv::putText(panel, std::to_string(first + axis + 1), end + cv::Point(4, -4),
                cv::FONT_HERSHEY_SIMPLEX, 0.45, kInk, 1, cv::LINE_AA);
  }
  return panel;
}

cv::Mat drawPoints(const Eigen::MatrixXd& points, double size,
                   const std::vector<cv::Scalar>& color) {
  const Frame frame(points.colwise().minCoeff().transpose(),
                    points.colwise().maxCoeff().transpose());
  const int half = std::max(1, int(0.5 * size * frame.scale()));
  cv::Mat panel(kPanel, kPanel, CV_8UC3, kPaper);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const cv::Point at = frame.place(points.row(i).transpose());
    cv::rectangle(panel, at - cv::Point(half, half), at + cv::Point(half, half), color[size_t(i)],
                  cv::FILLED);
  }
  return panel;
}

cv::Mat panelRow(const std::vector<cv::Mat>& panels, const std::vector<std::string>& titles) {
  cv::Mat row(kPanel + kTitle, kPanel * int(panels.size()), CV_8UC3, kPaper);
  for (size_t i = 0; i < panels.size(); ++i) {
    panels[i].copyTo(row(cv::Rect(int(i) * kPanel, kTitle, kPanel, kPanel)));
    cv::putText(row, titles[i], {int(i) * kPanel + 10, 18}, cv::FONT_HERSHEY_SIMPLEX, 0.5, kInk, 1,
                cv::LINE_AA);
  }
  return row;
}

}  // namespace markerless_mocap
