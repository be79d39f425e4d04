#pragma once

#include <ros/console.h>

#include <exception>
#include <string>

namespace markerless_mocap {

/// Runs the start of a nodelet. An exception is logged once and thrown again. The loader then gives
/// up: a standalone node ends with exit code 1, other nodelets of a manager continue.
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
