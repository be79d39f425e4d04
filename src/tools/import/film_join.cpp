#include "tools/import/film_join.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr double kSlower = 0.98;  // rates that differ by less are the same

/// How far a frame may be from its frame set, s. Frames of a film that is half an interval out of
/// step are a little nearer now, a little farther then.
double slopOf(const Film& film, double frame_sets_per_second) {
  constexpr double kOutOfStep = 0.75;  // of the film's own interval
  return std::max(0.5 / frame_sets_per_second, kOutOfStep / film.fps());
}

}  // namespace

void FilmJoin::Reader::advance() {
  ahead = film.next();
  if (ahead) ahead->time += offset;
}

FilmJoin::FilmJoin(std::vector<Film> films, std::vector<double> offsets, double fps)
    : statistics_(films.size()), fps_(fps), own_rate_(!(fps > 0.0)) {
  for (size_t i = 0; i < films.size(); ++i) {
    if (!(films[i].fps() > 0.0))
      throw std::runtime_error("the film " + films[i].path() +
                               " does not contain its frame rate (--fps)");
    readers_.push_back({std::move(films[i]), offsets[i], std::nullopt});
    readers_.back().advance();
    if (readers_[i].film.fps() < kSlower * readers_[slowest_].film.fps()) slowest_ = i;
  }
  if (own_rate_) fps_ = readers_[slowest_].film.fps();
}

int FilmJoin::expectedFrameSets() const {
  return int(readers_[slowest_].film.frames() * fps_ / readers_[slowest_].film.fps());
}

std::optional<double> FilmJoin::nextTime() {
  double start = -INFINITY;  // from where all films run
  for (const Reader& reader : readers_) {
    if (!reader.ahead) return std::nullopt;
    start = std::max(start, reader.ahead->time);
  }
  if (!own_rate_) return last_ ? *last_ + 1.0 / fps_ : start;
  const double slop = 0.5 / fps_;
  Reader& slowest = readers_[slowest_];
  while (!last_ && slowest.ahead && slowest.ahead->time < start - slop) {
    slowest.advance();
    ++statistics_[slowest_].left_out;
  }
  if (!slowest.ahead) return std::nullopt;
  return slowest.ahead->time;
}

FilmFrame FilmJoin::nearest(size_t film, double time) {
  Reader& reader = readers_[film];
  JoinStatistics& counts = statistics_[film];
  const double slop = slopOf(reader.film, fps_);
  std::optional<FilmFrame> best;
  while (reader.ahead && reader.ahead->time <= time + slop) {
    if (best && std::abs(reader.ahead->time - time) > std::abs(best->time - time)) break;
    if (best || reader.ahead->time < time - slop) ++counts.left_out;
    if (reader.ahead->time >= time - slop) best = std::move(reader.ahead);
    reader.advance();
  }
  if (!best) {
    ++counts.missing;
    return {};
  }
  ++counts.used;
  counts.sum += std::abs(best->time - time);
  counts.largest = std::max(counts.largest, std::abs(best->time - time));
  return *best;
}

std::optional<FilmJoin::Joined> FilmJoin::next() {
  const std::optional<double> time = nextTime();
  if (!time) return std::nullopt;
  Joined joined;
  joined.time = *time;
  for (size_t i = 0; i < readers_.size(); ++i) joined.frames.push_back(nearest(i, *time));
  last_ = time;
  return joined;
}

}  // namespace markerless_mocap
