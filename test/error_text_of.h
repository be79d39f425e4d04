#pragma once

#include <stdexcept>
#include <string>

namespace markerless_mocap {

/// The sentence that a call refuses with; empty if it does not refuse.
template <class ErrorT = std::invalid_argument, class CallT>
std::string errorTextOf(const CallT& call) {
  try {
    call();
  } catch (const ErrorT& error) {
    return error.what();
  }
  return "";
}

}  // namespace markerless_mocap
