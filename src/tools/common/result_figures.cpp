#include "tools/common/result_figures.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace markerless_mocap {

void ResultFigures::Mean::add(double value) {
  if (!std::isfinite(value)) return;
  sum += value;
  ++count;
}

void ResultFigures::add(int64_t stamp_ns, PoseStatus status, double overlap,
                        const std::array<double, kPartCount>& part_sigma_m) {
  if (frame_sets_++ == 0) first_ns_ = stamp_ns;
  last_ns_ = stamp_ns;
  if (status == PoseStatus::kLost) return;
  ++(status == PoseStatus::kTracked ? tracked_ : reinitialized_);
  overlap_.add(overlap);
  for (const double sigma_m : part_sigma_m) expected_error_m_.add(sigma_m);
}

std::string ResultFigures::json() const {
  nlohmann::ordered_json out{{"frame_sets", frame_sets_},
                             {"seconds", 1e-9 * double(last_ns_ - first_ns_)},
                             {"tracked", tracked_},
                             {"reinitialized", reinitialized_},
                             {"lost", frame_sets_ - tracked_ - reinitialized_},
                             {"silhouette_overlap", nullptr},
                             {"expected_error_m", nullptr},
                             {"calibration", calibration_finding_}};
  if (overlap_.count > 0) out["silhouette_overlap"] = overlap_.sum / double(overlap_.count);
  if (expected_error_m_.count > 0)
    out["expected_error_m"] = expected_error_m_.sum / double(expected_error_m_.count);
  return out.dump(1) + "\n";
}

}  // namespace markerless_mocap
