#include "calibration/board_coverage.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "text/joined.h"

namespace markerless_mocap {
namespace {

constexpr double kMoved = 0.05;  // of the image's width, mean over the corners in common
constexpr double kTilted = 20 * M_PI / 180;

size_t cellOf(const Eigen::Vector2d& pixel, const CameraToCalibrate& camera) {
  const int column = int((pixel.x() + 0.5) / camera.width * CameraCoverage::kColumns);
  const int row = int((pixel.y() + 0.5) / camera.height * CameraCoverage::kRows);
  return size_t(std::clamp(row, 0, CameraCoverage::kRows - 1) * CameraCoverage::kColumns +
                std::clamp(column, 0, CameraCoverage::kColumns - 1));
}

}  // namespace

double distanceBetween(const BoardCorners& a, const BoardCorners& b) {
  double sum = 0;
  int count = 0;
  for (size_t i = 0, k = 0; i < a.ids.size() && k < b.ids.size();) {
    if (a.ids[i] == b.ids[k]) {
      sum += (a.pixels[i++] - b.pixels[k++]).norm();
      ++count;
    } else {
      ++(a.ids[i] < b.ids[k] ? i : k);
    }
  }
  return count > 0 ? sum / count : INFINITY;
}

double tiltOf(const Board& board, const BoardCorners& corners) {
  const Eigen::Index n = Eigen::Index(corners.ids.size());
  if (n < 4) return 0.0;
  Eigen::MatrixX3d places(n, 3);
  Eigen::MatrixX2d pixels(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    places.row(i) << board.corners()[size_t(corners.ids[size_t(i)])].transpose(), 1;
    pixels.row(i) = corners.pixels[size_t(i)].transpose();
  }
  const Eigen::Matrix<double, 3, 2> affine = places.colPivHouseholderQr().solve(pixels);
  const Eigen::Vector2d lengths =
      Eigen::JacobiSVD<Eigen::Matrix2d>(affine.topRows<2>()).singularValues();
  return lengths[0] > 0 ? std::acos(std::clamp(lengths[1] / lengths[0], 0.0, 1.0)) : 0.0;
}

double CameraCoverage::covered() const {
  return double(std::count(cells.begin(), cells.end(), true)) / double(cells.size());
}

BoardCoverage::BoardCoverage(const Board& board, std::vector<CameraToCalibrate> cameras,
                             const CoverageGoals& goals)
    : board_(board),
      cameras_(std::move(cameras)),
      goals_(goals),
      coverage_(cameras_.size()),
      counted_(cameras_.size()) {
  for (size_t i = 0; i < cameras_.size(); ++i) {
    coverage_[i].name = cameras_[i].name;
    coverage_[i].shared.assign(cameras_.size(), 0);
  }
}

bool BoardCoverage::isNew(const BoardView& view) const {
  const double least = kMoved * cameras_[view.camera].width;
  const auto& before = counted_[view.camera];
  return std::all_of(before.begin(), before.end(), [&](const BoardCorners& corners) {
    return distanceBetween(corners, view.corners) > least;
  });
}

void BoardCoverage::count(const BoardView& view) {
  CameraCoverage& camera = coverage_[view.camera];
  ++camera.views;
  camera.tilted += tiltOf(board_, view.corners) > kTilted;
  counted_[view.camera].push_back(view.corners);
}

bool BoardCoverage::add(const std::vector<BoardView>& views) {
  std::vector<bool> is_new;
  for (const BoardView& view : views) {
    is_new.push_back(isNew(view));
    for (const Eigen::Vector2d& pixel : view.corners.pixels)
      coverage_[view.camera].cells[cellOf(pixel, cameras_[view.camera])] = true;
  }
  for (size_t i = 0; i < views.size(); ++i) {
    if (is_new[i]) count(views[i]);
    for (size_t k = 0; k < views.size(); ++k)
      if (k != i && (is_new[i] || is_new[k]) &&
          std::abs(views[i].time - views[k].time) < goals_.same_time)
        ++coverage_[views[i].camera].shared[views[k].camera];
  }
  return std::count(is_new.begin(), is_new.end(), true) > 0;
}

std::vector<bool> BoardCoverage::joinedToFirst() const {
  std::vector<bool> joined(coverage_.size(), false);
  std::vector<size_t> waiting = {0};
  joined[0] = true;
  while (!waiting.empty()) {
    const size_t at = waiting.back();
    waiting.pop_back();
    for (size_t i = 0; i < joined.size(); ++i)
      if (!joined[i] && coverage_[at].shared[i] >= goals_.shared) {
        joined[i] = true;
        waiting.push_back(i);
      }
  }
  return joined;
}

/// Thirds of the image in which less than half of the cells were met.
std::string BoardCoverage::emptyPlaces(const CameraCoverage& camera) const {
  static const char* const kPlaces[3][3] = {{"upper left", "top", "upper right"},
                                            {"left", "middle", "right"},
                                            {"lower left", "bottom", "lower right"}};
  std::vector<std::string> empty;
  int seen[3][3] = {}, all[3][3] = {};
  for (int row = 0; row < CameraCoverage::kRows; ++row)
    for (int column = 0; column < CameraCoverage::kColumns; ++column) {
      const int y = row * 3 / CameraCoverage::kRows, x = column * 3 / CameraCoverage::kColumns;
      ++all[y][x];
      seen[y][x] += camera.cells[size_t(row * CameraCoverage::kColumns + column)];
    }
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x)
      if (2 * seen[y][x] < all[y][x]) empty.push_back(kPlaces[y][x]);
  return joined(empty);
}

std::vector<std::string> BoardCoverage::missing() const {
  std::vector<std::string> todo;
  for (const CameraCoverage& camera : coverage_) {
    if (camera.views < goals_.views)
      todo.push_back(camera.name + " needs " + std::to_string(goals_.views - camera.views) +
                     " more places of the board");
    else if (camera.covered() < goals_.covered)
      todo.push_back(camera.name + " has not seen the board at: " + emptyPlaces(camera));
    if (camera.views >= goals_.views && camera.tilted < goals_.tilted)
      todo.push_back(camera.name + " needs the board tilted, " +
                     std::to_string(goals_.tilted - camera.tilted) + " more times");
  }
  std::vector<std::string> together, apart;
  const std::vector<bool> is_joined = joinedToFirst();
  for (size_t i = 0; i < coverage_.size(); ++i)
    (is_joined[i] ? together : apart).push_back(coverage_[i].name);
  if (!apart.empty())
    todo.push_back("show the board more often to one of " + joined(together) +
                   " and at the same time to one of " + joined(apart));
  return todo;
}

std::string BoardCoverage::table() const {
  std::string text;
  for (const CameraCoverage& camera : coverage_) {
    char line[200];
    std::snprintf(line, sizeof line,
                  "%-12s %3d of %d places, %2d of %d tilted, %3.0f of %.0f %% covered, shared:",
                  camera.name.c_str(), camera.views, goals_.views, camera.tilted, goals_.tilted,
                  100 * camera.covered(), 100 * goals_.covered);
    text += line;
    for (size_t i = 0; i < coverage_.size(); ++i)
      if (coverage_[i].name != camera.name)
        text += ' ' + coverage_[i].name + ' ' + std::to_string(camera.shared[i]);
    text += '\n';
  }
  return text;
}

}  // namespace markerless_mocap
