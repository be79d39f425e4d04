#pragma once

#include <ros/publisher.h>

#include <boost/make_shared.hpp>
#include <utility>

namespace markerless_mocap {

/// Publishes a message so that nodelets of the same manager share it without a copy.
template <class MessageT>
void publishShared(const ros::Publisher& publisher, MessageT message) {
  publisher.publish(boost::make_shared<const MessageT>(std::move(message)));
}

}  // namespace markerless_mocap
