#pragma once

#include <ros/transport_hints.h>

#include <cstdint>

namespace markerless_mocap {

/// Messages that a publisher queues while another process does not get CPU time.
constexpr uint32_t kPublisherQueue = 16;

/// Disables Nagle's algorithm for a subscription between processes. The algorithm delays the end of
/// a message until earlier data is acknowledged, by up to 40 ms.
inline ros::TransportHints lowLatencyTransport() {
  return ros::TransportHints().tcpNoDelay();
}

}  // namespace markerless_mocap
