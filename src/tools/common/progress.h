#pragma once

#include <ostream>
#include <string>

namespace markerless_mocap {

/// Progress of a long run: on a terminal a bar that is redrawn, else one line per ten percent.
class Progress {
 public:
  /// \param out output stream; nullptr: no output
  Progress(std::string label, std::ostream* out, bool terminal);
  /// \param fraction done, 0 to 1; must not decrease
  void update(double fraction);
  /// Shows 100 % and ends the line of the bar.
  void finish();

 private:
  std::string label_;
  std::ostream* out_;
  bool terminal_;
  int shown_ = -1;  ///< last percentage (terminal) or tenth written
};

/// True if the standard error stream is a terminal.
bool isStderrTerminal();

}  // namespace markerless_mocap
