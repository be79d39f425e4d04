#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

namespace markerless_mocap {

/// One picture of a film.
struct FilmFrame {
  double time = 0.0;  ///< seconds, of the first frame 0 unless there is a table of times
  cv::Mat image;
  cv::Mat mask;  ///< as it is stored; empty without masks
};

/// The frames of one camera: a video, or a folder with images in the order of their names. A video
/// is turned as its container says, and has the container's times, whatever its rate is.
class Film {
 public:
  /// \param fps of a folder of images
  /// Throws std::runtime_error if there are no frames.
  Film(const std::string& path, double fps);
  ~Film();
  Film(Film&&) noexcept;

  const std::string& path() const { return path_; }
  cv::Size size() const { return size_; }
  double fps() const { return fps_; }  ///< 0: the container does not say it
  int frames() const;                  ///< as the container says; 0: unknown
  /// As the container says, degrees: the images are turned already.
  int turned() const;
  /// Gives images as they are stored from now on, not turned.
  void doNotTurn();
  bool turns() const { return turns_; }
  /// The k-th mask of a video or a folder of images belongs to the k-th frame. Throws
  /// std::runtime_error if there are none; next() does if they end before the film.
  void addMasks(const std::string& path);
  /// Replaces the times of the frames; frames beyond the last are left out.
  void setTimes(std::vector<double> times);

  /// The same film from its beginning, turned and with masks as this one, with its own times.
  Film again() const;
  /// Passes over one frame; false after the last one.
  bool skip();
  /// The next frame; empty after the last one. Throws std::runtime_error if an image cannot be
  /// read.
  std::optional<FilmFrame> next();

 private:
  struct Source;
  double ownTime();  ///< of the frame that was read last
  std::string path_, masks_path_;
  bool turns_ = true;
  double fps_ = 0.0;
  double start_ = 0.0;  ///< time of the first frame in the container; editors leave some there
  cv::Size size_;
  std::unique_ptr<Source> source_, masks_;
  std::optional<std::vector<double>> times_;
  size_t next_ = 0;
  double last_time_ = 0.0;
};

/// A film and its name, that of the file or of the camera's folder without ending.
struct NamedFilm {
  std::string name, path;
};

/// Videos that are named, and what lies in folders that are named, in the order of names: videos,
/// folders with images, folders with one video. Throws std::runtime_error if there are none.
std::vector<NamedFilm> filmsIn(const std::vector<std::string>& inputs);

}  // namespace markerless_mocap
