#pragma once

#include <stdexcept>
#include <string>

namespace markerless_mocap {

/// What a call refuses with; empty if it does not refuse.
template <class CallT>
std::string sentenceOf(CallT call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace markerless_mocap
