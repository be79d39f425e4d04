#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

namespace markerless_mocap {

/// One image of a camera.
struct TimedImage {
  cv::Mat image;      ///< CV_8UC1 or CV_8UC3; empty after the last one
  double time = 0.0;  ///< s, clock of the camera
};

/// The images of one camera in the order of time: a video, a folder of pictures, a topic of a bag.
class ImageFilm {
 public:
  virtual ~ImageFilm() = default;
  /// The next image; empty after the last one. Throws std::runtime_error on a damaged file.
  virtual TimedImage next() = 0;
  /// Passes over one image and gives its time, s; nothing after the last one.
  virtual std::optional<double> skip() = 0;
  /// Number of images, as far as the file tells; 0 if unknown.
  virtual int count() const = 0;
};

/// Where a camera's images are.
struct FilmSource {
  std::string camera;
  std::string path;   ///< video, folder or bag
  std::string topic;  ///< of a bag; else empty
};

/// The cameras of the inputs: a bag (every camera of it), a video, a folder with one folder or
/// video per camera, or a folder of pictures. The cameras are named after their topics, folders or
/// videos. \param video file that is taken from each camera's folder; empty: pictures, or its only
/// video Throws std::runtime_error; the message says what was not found.
std::vector<FilmSource> findFilms(const std::vector<std::string>& inputs, const std::string& video);

/// Opens a film. Pictures have the times 0, 1, 2 ... Throws std::runtime_error.
std::unique_ptr<ImageFilm> openFilm(const FilmSource& source);

}  // namespace markerless_mocap
