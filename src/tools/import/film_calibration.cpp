#include "tools/import/film_calibration.h"

#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

bool hasShapeOf(const cv::Size& a, const cv::Size& b) {
  return std::abs(double(a.width) * b.height - double(a.height) * b.width) <
         0.5 * (a.width + a.height);
}

bool isCutFrom(const cv::Size& film, const cv::Size& whole) {
  return film.width <= whole.width && film.height <= whole.height &&
         film.width >= 0.99 * whole.width && film.height >= 0.99 * whole.height;
}

/// Integer coordinates are pixel centres, so the image's corner is at -0.5.
void scale(CameraCalibration* camera, double factor) {
  camera->K.topRows<2>() *= factor;
  camera->K(0, 2) += (factor - 1.0) / 2.0;
  camera->K(1, 2) += (factor - 1.0) / 2.0;
}

}  // namespace

std::string text(const cv::Size& size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

void agreeInSize(CameraCalibration* camera, Film* film, std::vector<std::string>* notes) {
  const cv::Size calibrated(camera->width, camera->height);
  if (calibrated != film->size() && film->turned() % 180 != 0 &&
      calibrated == cv::Size(film->size().height, film->size().width)) {
    film->doNotTurn();
    notes->push_back("the film of " + camera->name +
                     " is not turned as its container says, as the calibration is of " +
                     text(calibrated));
  }
  const cv::Size size = film->size();
  camera->width = size.width;
  camera->height = size.height;
  if (calibrated.area() == 0 || calibrated == size) return;
  if (hasShapeOf(size, calibrated)) {
    scale(camera, double(size.width) / calibrated.width);
    notes->push_back("the calibration of " + camera->name + ", " + text(calibrated) +
                     ", is scaled to the film's " + text(size));
  } else if (isCutFrom(size, calibrated)) {
    notes->push_back("the film of " + camera->name + " is " + text(size) +
                     ", the calibration is of " + text(calibrated) +
                     ": it is taken as cut at the right and bottom");
  } else {
    throw std::invalid_argument("the film of " + camera->name + " is " + text(size) +
                                " pixels, the calibration is of " + text(calibrated));
  }
}

}  // namespace markerless_mocap
