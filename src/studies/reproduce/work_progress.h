#pragma once

#include <chrono>
#include <ostream>
#include <string>

namespace markerless_mocap {

/// Progress of a list of work with the remaining time: on a terminal a bar that is redrawn, else a
/// line for each piece.
class WorkProgress {
 public:
  /// \param total cost of all pieces \param out nullptr: no output
  WorkProgress(double total, std::ostream* out, bool terminal);
  /// A piece is done.
  void add(const std::string& name, double cost);
  /// Ends the line of the bar.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  double total_, done_ = 0.0;
  std::ostream* out_;
  bool terminal_;
  Clock::time_point started_ = Clock::now();
};

/// "2 h 5 min", "3 min", "20 s".
std::string durationText(double seconds);

}  // namespace markerless_mocap
