#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

/// What libFuzzer calls with each input, and fuzz/replay_main.cpp with each file of the corpus.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace markerless_mocap {

inline std::string textOf(const uint8_t* data, size_t size) {
  return std::string(reinterpret_cast<const char*>(data), size);
}

/// Input may be refused by these exceptions only; all else is a fault of ours.
template <class Read>
void refusesOrReads(const Read& read) {
  try {
    read();
  } catch (const std::invalid_argument&) {
  }
}

}  // namespace markerless_mocap
