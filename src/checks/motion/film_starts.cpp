#include "checks/film_starts.h"

#include "checks/motion/person_clocks.h"
#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

PersonTrack trackOf(const FilmedPerson& film) {
  PersonTrack track;
  track.seconds = film.seconds;
  for (const Outline& outline : film.outlines) track.outlines.push_back(&outline);
  track.width = film.calibration.width;
  track.height = film.calibration.height;
  std::vector<double> intervals;
  for (size_t i = 1; i < film.seconds.size(); ++i)
    intervals.push_back(film.seconds[i] - film.seconds[i - 1]);
  track.period = nearestQuantile(intervals, 0.5);
  return track;
}

}  // namespace

FilmClocks personClocks(const std::vector<FilmedPerson>& films, double largest) {
  std::vector<PersonTrack> tracks;
  RigModel model;
  for (const FilmedPerson& film : films) {
    tracks.push_back(trackOf(film));
    model.push_back({});
    model.back().calibration = film.calibration;
    model.back().source = model.size() - 1;
  }
  return searchPersonClocks(tracks, model, largest);
}

}  // namespace markerless_mocap
