#pragma once

#include <ros/transport_hints.h>

#include <cstdint>

namespace markerless_mocap {

/// Messages that a publisher keeps for another process that has not got the cores for a moment.
constexpr uint32_t kPublisherQueue = 16;

/// For subscriptions between processes: a publisher sends the end of a message at once. Nagle's
/// algorithm would hold it back until what went before is acknowledged, up to 40 ms.
inline ros::TransportHints lowLatencyTransport() {
  return ros::TransportHints().tcpNoDelay();
}

}  // namespace markerless_mocap
