#pragma once

#include <ros/console.h>

#include <exception>
#include <string>

namespace markerless_mocap {

/// Runs a nodelet's start. What it refuses is said once; the exception then makes the loader give
/// up, which ends a standalone node with exit code 1 and leaves a manager's other nodelets alone.
template <class StartT>
void guardedStart(const std::string& name, StartT start) {
  try {
    start();
  } catch (const std::exception& error) {
    ROS_FATAL_STREAM(name << ": " << error.what());
    throw;
  }
}

}  // namespace markerless_mocap
