#pragma once

#include <ros/console.h>

#include <cstdlib>
#include <exception>
#include <string>

namespace markerless_mocap {

/// Ends the process at once, without destructors, as other threads may wait for this one.
[[noreturn]] inline void endProcess(const std::string& where, const std::string& why) {
  ROS_FATAL_STREAM(where << " has failed: " << why << "; the process ends");
  std::_Exit(1);
}

/// Runs the work of a thread or callback; an exception ends the process with a sentence.
template <class WorkT>
void runOrEndProcess(const std::string& where, const WorkT& work) {
  try {
    work();
  } catch (const std::exception& error) {
    endProcess(where, error.what());
  } catch (...) {
    endProcess(where, "unknown error");
  }
}

}  // namespace markerless_mocap
