#pragma once

#include <string>

namespace markerless_mocap {

/// Whether the lengths of the bag's records, and of the fields of their headers, agree with the
/// file: rosbag reads headers by these lengths without a bound. Format:
/// http://wiki.ros.org/Bags/Format/2.0. What lies in chunks is not looked at. True for what is no
/// bag or has no index, too: rosbag tells these.
bool areBagRecordsSound(const std::string& path);

}  // namespace markerless_mocap
