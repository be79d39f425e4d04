#include "checks/motion/clock_search.h"

#include <algorithm>
#include <cmath>

#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

constexpr int kFewRays = 40;
constexpr size_t kNone = size_t(-1);  // no part is left out

/// Where a parabola through the least value and its neighbours is least, in steps.
double vertexOf(const std::vector<double>& values, size_t least) {
  if (least == 0 || least + 1 >= values.size()) return double(least);
  const double bend = values[least - 1] - 2 * values[least] + values[least + 1];
  return double(least) + (bend > 0 ? 0.5 * (values[least - 1] - values[least + 1]) / bend : 0.0);
}

size_t leastOf(const std::vector<double>& values) {
  return size_t(std::min_element(values.begin(), values.end()) - values.begin());
}

/// Standard deviation of an estimate by those without a part each.
double jackknife(const std::vector<double>& without) {
  double mean = 0, square = 0;
  for (const double one : without) mean += one / double(without.size());
  for (const double one : without) square += std::pow(one - mean, 2);
  return std::sqrt(square * double(without.size() - 1) / double(without.size()));
}

}  // namespace

ClockSearch::ClockSearch(const RigSight& sight, const CameraModel& camera, const CameraState& state,
                         double largest, double step)
    : sight_(sight),
      camera_(camera),
      state_(state),
      step_(step),
      middle_((sight.moments.front() + sight.moments.back()) / 2) {
  const Sight pixels = sightOf(sight.tracks[camera.source], camera.calibration, camera.turn);
  const int steps = int(std::floor(largest / step));
  for (int i = -steps; i <= steps; ++i) add(pixels, i * step);
}

void ClockSearch::add(const Sight& pixels, double offset) {
  CameraModel shifted = camera_;
  shifted.offset += offset;
  const Rays rays = raysOf(sight_, shifted, pixels);
  std::vector<double> losses(rays.size(), NAN);
  for (size_t at = 0; at < rays.size(); ++at)
    if (rays[at] && state_.points[at] && state_.rays[at])
      losses[at] = lossOf(residualOf(*rays[at], *state_.points[at]));
  offsets_.push_back(offset);
  losses_.push_back(std::move(losses));
}

double ClockSearch::Sums::mean(size_t left_out) const {
  double sum = 0;
  int count = 0;
  for (size_t part = 0; part < kParts; ++part)
    if (part != left_out) {
      sum += loss[part];
      count += rays[part];
    }
  return count < kFewRays ? 1.0 : sum / count;
}

/// Between the offsets of the table.
void ClockSearch::addRay(size_t ray, double drift, Row* row) const {
  const size_t moment = ray / kBodyMarks, part = moment * kParts / sight_.moments.size();
  const double shift = drift * (sight_.moments[moment] - middle_) / step_;
  const double whole = std::floor(shift), rest = shift - whole;
  for (size_t i = 0; i < row->size(); ++i) {
    const double at = double(i) + whole;
    if (at < 0 || at + 1 >= double(offsets_.size()) + (rest == 0)) continue;
    const double low = losses_[size_t(at)][ray];
    const double high = rest == 0 ? low : losses_[size_t(at) + 1][ray];
    const double loss = (1 - rest) * low + rest * high;
    if (!std::isfinite(loss)) continue;
    (*row)[i].loss[part] += loss;
    ++(*row)[i].rays[part];
  }
}

ClockSearch::Row ClockSearch::rowOf(double drift) const {
  Row row(offsets_.size());
  for (size_t ray = 0; ray < losses_.front().size(); ++ray) addRay(ray, drift, &row);
  return row;
}

double ClockSearch::sharpness() const {
  std::vector<double> means;
  for (const Sums& sums : rowOf(0)) means.push_back(sums.mean(kNone));
  return nearestQuantile(means, 0.5) - means[leastOf(means)];
}

ClockError ClockSearch::best(const std::vector<Row>& rows, double drift_step,
                             size_t left_out) const {
  std::vector<double> least, offsets;  // of each drift
  for (const Row& row : rows) {
    std::vector<double> means;
    for (const Sums& sums : row) means.push_back(sums.mean(left_out));
    const size_t at = leastOf(means);
    least.push_back(means[at]);
    offsets.push_back(offsets_.front() + step_ * vertexOf(means, at));
  }
  const size_t at = leastOf(least), middle = rows.size() / 2;
  return {offsets[at], drift_step * (vertexOf(least, at) - double(middle)), 0};
}

ClockError ClockSearch::errorOf(const std::vector<Row>& rows, double drift_step) const {
  ClockError error = best(rows, drift_step, kNone);
  std::vector<double> without;
  for (size_t part = 0; part < kParts; ++part) {
    const ClockError others = best(rows, drift_step, part);
    without.push_back(rows.size() > 1 ? others.drift : others.offset);
  }
  error.deviation = jackknife(without);
  return error;
}

ClockError ClockSearch::offset() const {
  return errorOf({rowOf(0)}, 0);
}

ClockError ClockSearch::offsetAndDrift(double most_drift) const {
  const double half = (sight_.moments.back() - sight_.moments.front()) / 2;
  const double step = step_ / half;  // an offset's step at either end
  const int steps = int(std::ceil(most_drift / step));
  std::vector<Row> rows;
  for (int i = -steps; i <= steps; ++i) rows.push_back(rowOf(i * step));
  return errorOf(rows, step);
}

}  // namespace markerless_mocap
