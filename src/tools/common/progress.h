#pragma once

#include <ostream>
#include <string>

namespace markerless_mocap {

/// How far a long run is: on a terminal a bar redrawn in place, else a line every ten percent.
class Progress {
 public:
  /// \param out where to write; nullptr: say nothing
  Progress(std::string label, std::ostream* out, bool terminal);
  /// \param share done, 0..1, never less than the last one
  void update(double fraction);
  /// Shows the whole as done and ends the bar's line.
  void finish();

 private:
  std::string label_;
  std::ostream* out_;
  bool terminal_;
  int shown_ = -1;  ///< last percentage (terminal) or tenth written
};

/// Whether standard error is a terminal.
bool isStderrTerminal();

}  // namespace markerless_mocap
