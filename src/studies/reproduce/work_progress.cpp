#include "studies/reproduce/work_progress.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {

std::string durationText(double seconds) {
  if (seconds < 100.0) return std::to_string(int(std::lround(seconds))) + " s";
  const int minutes = int(std::lround(seconds / 60.0));
  if (minutes < 100) return std::to_string(minutes) + " min";
  return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

WorkProgress::WorkProgress(double total, std::ostream* out, bool terminal)
    : total_(total), out_(out), terminal_(terminal) {}

void WorkProgress::add(const std::string& name, double cost) {
  done_ += cost;
  if (!out_) return;
  const double fraction = std::clamp(done_ / std::max(total_, 1e-9), 0.0, 1.0);
  const double seconds = std::chrono::duration<double>(Clock::now() - started_).count();
  const std::string left =
      durationText(fraction > 0.0 ? seconds * (1.0 - fraction) / fraction : 0.0);
  const std::string percent = std::to_string(int(100.0 * fraction)) + " %";
  if (!terminal_) {
    *out_ << percent << ", about " << left << " left: " << name << std::endl;
    return;
  }
  constexpr int kWidth = 30;
  const int full = int(kWidth * fraction);
  *out_ << "\r\033[K[" << std::string(size_t(full), '#') << std::string(size_t(kWidth - full), ' ')
        << "] " << percent << ", about " << left << " left: " << name << std::flush;
}

void WorkProgress::finish() {
  if (out_ && terminal_ && done_ > 0.0) *out_ << std::endl;
}

}  // namespace markerless_mocap
