#include "tools/calibrate_rig/film_starts.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "text/joined.h"

namespace markerless_mocap {
namespace {

constexpr double kTogether = 0.15;  // s: less is found by the stamps' check

bool beganTogether(const FilmClocks& clocks) {
  return std::all_of(clocks.offsets.begin(), clocks.offsets.end(),
                     [](double offset) { return std::abs(offset) < kTogether; });
}

/// Median of what was searched of a camera's film, s.
double intervalOf(const FoundBoards& boards, size_t camera) {
  const std::vector<double>& times = boards.times[camera];
  if (times.size() < 2 || boards.images[camera] < 2) return 0.0;
  return (times.back() - times.front()) / double(boards.images[camera] - 1);
}

/// Common times at which a camera saw the board, ascending.
std::vector<double> seenAt(const FoundBoards& boards, const std::vector<double>& offsets,
                           size_t camera) {
  std::vector<double> seen;
  for (const BoardView& view : boards.views)
    if (view.camera == camera && !view.alone) seen.push_back(view.time + offsets[camera]);
  std::sort(seen.begin(), seen.end());
  return seen;
}

bool isNear(const std::vector<double>& ascending, double time, double reach) {
  const auto next = std::lower_bound(ascending.begin(), ascending.end(), time - reach);
  return next != ascending.end() && *next <= time + reach;
}

/// Times at which two cameras or more see the board, evenly spread.
std::vector<double> sharedTimes(const std::vector<std::vector<double>>& seen,
                                const std::vector<double>& reach, size_t most) {
  std::set<double> shared;
  for (size_t a = 0; a < seen.size(); ++a)
    for (const double time : seen[a])
      for (size_t b = 0; b < seen.size(); ++b)
        if (b != a && isNear(seen[b], time, reach[b])) shared.insert(time);
  const std::vector<double> all(shared.begin(), shared.end());
  if (all.size() <= most) return all;
  std::vector<double> chosen;
  for (size_t k = 0; k < most; ++k) chosen.push_back(all[k * all.size() / most]);
  return chosen;
}

/// The image nearest to a time and those before and after it.
void addNeighbours(const std::vector<double>& times, double time, std::set<size_t>* numbers) {
  const auto next = std::lower_bound(times.begin(), times.end(), time);
  size_t nearest = size_t(next - times.begin());
  if (nearest == times.size() || (nearest > 0 && time - times[nearest - 1] < times[nearest] - time))
    --nearest;
  for (size_t k = nearest == 0 ? 0 : nearest - 1; k <= nearest + 1 && k < times.size(); ++k)
    numbers->insert(k);
}

std::string uncertainFilms(const CalibrationInput& input, const FilmClocks& clocks) {
  std::string names;
  for (size_t i = 0; i < input.cameras.size(); ++i)
    if (!(clocks.certainty[i] >= kCertainOffset)) addWord(&names, input.cameras[i].name);
  return names;
}

}  // namespace

std::string findStarts(FilmStart start, CalibrationInput* input) {
  if (start == FilmStart::kTogether || input->cameras.size() < 2) return "";
  const FilmClocks clocks = searchClocks(*input);
  if (start == FilmStart::kApart) {
    input->estimate_offsets = true;
    input->clocks = clocks;
    return "";
  }
  if (clocks.certain()) {
    if (beganTogether(clocks)) return "";
    input->estimate_offsets = true;
    input->clocks = clocks;
    return "The films did not begin together, by the motion of the board (--synchronised says "
           "that they did).";
  }
  if (clocks.for_none * kCertainOffset > 1) return "";
  return "When the film of " + uncertainFilms(*input, clocks) +
         " began is not certain by the motion of the board; it is taken to have begun with the "
         "others. If it did not, give a table of times (--times), or film again: move the board in "
         "no rhythm, where two cameras see it.";
}

std::vector<std::vector<size_t>> imagesTogether(const FoundBoards& boards,
                                                const std::vector<double>& offsets,
                                                int most_images) {
  constexpr size_t kImagesOfATime = 3;
  std::vector<std::vector<double>> seen;
  std::vector<double> reach;
  for (size_t i = 0; i < boards.cameras.size(); ++i) {
    seen.push_back(seenAt(boards, offsets, i));
    reach.push_back(0.75 * intervalOf(boards, i));
  }
  std::vector<std::set<size_t>> numbers(boards.cameras.size());
  for (const double time : sharedTimes(seen, reach, size_t(most_images) / kImagesOfATime))
    for (size_t i = 0; i < numbers.size(); ++i)
      if (isNear(seen[i], time, reach[i]))
        addNeighbours(boards.times[i], time - offsets[i], &numbers[i]);
  std::vector<std::vector<size_t>> lists;
  for (const auto& of_camera : numbers) lists.emplace_back(of_camera.begin(), of_camera.end());
  return lists;
}

bool haveOneRate(const FoundBoards& boards) {
  constexpr double kSame = 0.01;
  for (size_t i = 1; i < boards.cameras.size(); ++i)
    if (std::abs(intervalOf(boards, i) / intervalOf(boards, 0) - 1) > kSame) return false;
  return true;
}

bool areSparse(const FoundBoards& boards) {
  for (size_t i = 0; i < boards.times.size(); ++i)
    if (size_t(boards.images[i]) < boards.times[i].size()) return true;
  return false;
}

}  // namespace markerless_mocap
