#include "tools/common/bag_io.h"

#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "files/whole_file.h"
#include "tools/common/bag_records.h"
#include "tools/common/run_tool.h"

namespace markerless_mocap {

void openForReading(const std::string& path, rosbag::Bag& bag) {
  if (path.empty()) throw std::runtime_error("the name of the bag to read is empty");
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status)) throw std::runtime_error("there is no bag " + path);
  if (!std::filesystem::is_regular_file(status))
    throw std::runtime_error(path + " is a folder, pipe or device, allowed are bags");
  if (!areBagRecordsSound(path))
    throw std::runtime_error(path + " is not a bag or was cut off or damaged");
  try {
    bag.open(path, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw std::runtime_error(path + " has no index: the recording was cut off; rosbag reindex " +
                             path + " may repair it");
  } catch (const std::exception&) {  // rosbag's own words help nobody
    throw std::runtime_error(path + " is not a bag or was cut off");
  }
}

BagWriter::BagWriter(std::string path, rosbag::CompressionType compression)
    : path_(std::move(path)),
      active_path_(activePathOf(path_)),
      bag_(std::make_unique<rosbag::Bag>()) {
  checkTarget(path_);
  lock_ = std::make_unique<OutputLock>(path_);
  try {
    bag_->open(active_path_, rosbag::bagmode::Write);
  } catch (const rosbag::BagException&) {
    abandon();
    std::error_code ignored;
    const bool is_full = std::filesystem::remove(active_path_, ignored);
    throw std::runtime_error(
        "cannot write " + path_ +
        (is_full ? ": the disk is full" : ": its folder is missing or may not be written"));
  }
  bag_->setCompression(compression);
}

BagWriter::~BagWriter() {
  if (committed_) return;
  try {
    if (bag_) bag_->close();
  } catch (const std::exception&) {
    abandon();  // the file is removed in any case
  }
  std::error_code ignored;
  std::filesystem::remove(active_path_, ignored);
}

void BagWriter::abandon() {
  // Its destructor closes again, throws again and ends the process.
  static_cast<void>(bag_.release());
}

void BagWriter::fail(int error) {
  abandon();
  const std::string reason = reasonOfFailedWrite(error);
  throw std::runtime_error(
      "cannot write " + path_ +
      (reason.empty() && error ? ": " + std::string(std::strerror(error)) : reason));
}

void BagWriter::check(const std::string& topic, const ros::Time& stamp) const {
  if (isInterrupted()) throw std::runtime_error("interrupted, " + path_ + " is not written");
  if (!bag_) throw std::runtime_error("cannot write " + path_);
  if (stamp < ros::TIME_MIN)
    throw std::runtime_error("a message of " + topic + " has the stamp 0, bags hold later ones");
}

void BagWriter::commit() {
  errno = 0;
  try {
    bag_->close();
  } catch (const rosbag::BagException&) {
    fail(errno);
  }
  std::error_code error;
  std::filesystem::rename(active_path_, path_, error);
  if (error) throw std::runtime_error("cannot write " + path_ + ": " + error.message());
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
