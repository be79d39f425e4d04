#include "tools/common/progress.h"

#include <unistd.h>

#include <algorithm>
#include <utility>

namespace markerless_mocap {

Progress::Progress(std::string label, std::ostream* out, bool terminal)
    : label_(std::move(label)), out_(out), terminal_(terminal) {}

void Progress::update(double fraction) {
  if (!out_) return;
  const int percent = int(100.0 * std::clamp(fraction, 0.0, 1.0));
  const int step = terminal_ ? percent : percent / 10;
  if (step == shown_) return;
  shown_ = step;
  if (terminal_) {
    const int width = 40, full = percent * width / 100;
    *out_ << '\r' << label_ << " [" << std::string(full, '#') << std::string(width - full, ' ')
          << "] " << percent << " %" << std::flush;
  } else {
    *out_ << label_ << ' ' << step * 10 << " %" << std::endl;
  }
}

void Progress::finish() {
  update(1.0);
  if (out_ && terminal_) *out_ << std::endl;
}

bool isStderrTerminal() {
  return isatty(STDERR_FILENO) == 1;
}

}  // namespace markerless_mocap
