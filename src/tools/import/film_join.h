#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/import/film.h"

namespace markerless_mocap {

/// How the frames of one camera lay to their frame sets.
struct JoinStatistics {
  int used = 0, left_out = 0, missing = 0;  ///< frames, frames, frame sets
  double largest = 0.0, sum = 0.0;          ///< s, absolute distances in time
};

/// Joins films of any rates to frame sets at the times of the slowest one: of each other film the
/// frame nearest in time, if it is within half the slowest film's interval or three quarters of its
/// own. No frame is used twice.
class FilmJoin {
 public:
  /// \param offsets s, added to the times of each film
  /// \param fps rate of the frame sets; 0: that of the slowest film
  /// Throws std::runtime_error if a film's rate is not known.
  FilmJoin(std::vector<Film> films, std::vector<double> offsets, double fps);

  double fps() const { return fps_; }
  /// Time of the frame set, seconds, and one frame per film, empty where missing; nothing once a
  /// film has ended.
  struct Joined {
    double time = 0.0;
    std::vector<FilmFrame> frames;
  };
  std::optional<Joined> next();
  int expectedFrameSets() const;
  const std::vector<JoinStatistics>& statistics() const { return statistics_; }

 private:
  /// The film's next frame, which was not used yet; empty after the last.
  struct Reader {
    Film film;
    double offset;
    std::optional<FilmFrame> ahead;
    void advance();
  };

  std::optional<double> nextTime();
  FilmFrame nearest(size_t film, double time);

  std::vector<Reader> readers_;
  std::vector<JoinStatistics> statistics_;
  size_t slowest_ = 0;
  double fps_ = 0.0;
  bool own_rate_ = false;  ///< frame sets at the times of the slowest film
  std::optional<double> last_;
};

}  // namespace markerless_mocap
