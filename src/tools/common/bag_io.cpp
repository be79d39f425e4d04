#include "tools/common/bag_io.h"

#include <filesystem>
#include <stdexcept>
#include <utility>

namespace markerless_mocap {

void openForReading(const std::string& path, rosbag::Bag& bag) {
  if (!std::filesystem::is_regular_file(path)) throw std::runtime_error("there is no bag " + path);
  try {
    bag.open(path, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw std::runtime_error(path + " has no index: the recording was cut off; rosbag reindex " +
                             path + " may repair it");
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(path + " is not a bag or was cut off (" + error.what() + ")");
  }
}

BagWriter::BagWriter(std::string path, rosbag::CompressionType compression)
    : path_(std::move(path)), active_path_(path_ + ".active") {
  try {
    bag_.open(active_path_, rosbag::bagmode::Write);
  } catch (const rosbag::BagException&) {
    throw std::runtime_error("cannot write " + active_path_);
  }
  bag_.setCompression(compression);
}

BagWriter::~BagWriter() {
  if (committed_) return;
  try {
    bag_.close();
  } catch (const rosbag::BagException&) {
    // The file is removed in any case.
  }
  std::error_code ignored;
  std::filesystem::remove(active_path_, ignored);
}

void BagWriter::commit() {
  bag_.close();
  std::filesystem::rename(active_path_, path_);
  committed_ = true;
}

boost::shared_ptr<ros::M_string> BagWriter::latchedHeader(const std::string& topic,
                                                          const std::string& type,
                                                          const std::string& md5sum,
                                                          const std::string& definition) {
  return boost::make_shared<ros::M_string>(ros::M_string{{"topic", topic},
                                                         {"type", type},
                                                         {"md5sum", md5sum},
                                                         {"message_definition", definition},
                                                         {"latching", "1"}});
}

}  // namespace markerless_mocap
