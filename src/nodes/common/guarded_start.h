#pragma once

#include <ros/console.h>

#include <cstdlib>
#include <exception>
#include <string>

namespace markerless_mocap {

/// Environment variable of this process with the sentence of the last start that was refused: its
/// host has no other connection to a nodelet.
constexpr const char* kRefusalVariable = "MARKERLESS_MOCAP_REFUSAL";

/// Runs the start of a nodelet. An exception is logged once and thrown again. The loader then gives
/// up: a standalone node ends with exit code 1, or tries again without repeating the sentence;
/// other nodelets of a manager continue.
template <class StartT>
void guardedStart(const std::string& name, StartT start) {
  try {
    start();
  } catch (const std::exception& error) {
    const std::string sentence = name + ": " + error.what();
    const char* before = std::getenv(kRefusalVariable);
    if (!before || sentence != before) ROS_FATAL_STREAM(sentence);
    setenv(kRefusalVariable, sentence.c_str(), 1);
    throw;
  }
}

}  // namespace markerless_mocap
