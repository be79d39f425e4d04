#include "contour/regions/hull_cells.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "region/mask_cells.h"

namespace markerless_mocap {
cv::Mat hullCells(const VisualHull& hull, const Camera& camera, int cell) {
  cv::Mat cells =
      cv::Mat::zeros((camera.height() - 1) / cell + 1, (camera.width() - 1) / cell + 1, CV_8UC1);
  for (const HullVoxel& voxel : hull.voxels)
    if (const auto pixel = camera.projectInside(hull.lattice.center(voxel.index)))
      cells.at<uchar>(std::clamp(int(pixel->y() + 0.5) / cell, 0, cells.rows - 1),
                      std::clamp(int(pixel->x() + 0.5) / cell, 0, cells.cols - 1)) = 255;
  cv::dilate(cells, cells, cv::Mat());
  return cells;
}

cv::Mat hullPixels(const VisualHull& hull, const Camera& camera) {
  const int cell = maskCellEdge(camera.width());
  const cv::Mat cells = hullCells(hull, camera, cell);
  cv::Mat pixels;
  cv::resize(cells, pixels, cells.size() * cell, 0, 0, cv::INTER_NEAREST);
  return pixels(cv::Rect(0, 0, camera.width(), camera.height()));
}

}  // namespace markerless_mocap
