#include "tools/common/bag_records.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

namespace markerless_mocap {
namespace {

using Fields = std::map<std::string, std::string>;

constexpr uint32_t kMaxHeader = 16u << 20;  // bytes; the message definition lies in the data

/// A length and so many bytes.
bool readBlock(std::ifstream& file, uint32_t max, std::string* block) {
  uint32_t bytes = 0;
  if (!file.read(reinterpret_cast<char*>(&bytes), sizeof(bytes)) || bytes > max) return false;
  block->resize(bytes);
  return bool(file.read(block->data(), bytes));
}

/// The fields name=value of a header, each after its length.
bool readFields(const std::string& header, Fields* fields) {
  size_t at = 0;
  while (at < header.size()) {
    uint32_t bytes = 0;
    if (header.size() - at < sizeof(bytes)) return false;
    std::memcpy(&bytes, &header[at], sizeof(bytes));
    at += sizeof(bytes);
    if (header.size() - at < bytes) return false;
    const std::string field = header.substr(at, bytes);
    const size_t equals = field.find('=');
    if (equals == std::string::npos || equals == 0) return false;
    (*fields)[field.substr(0, equals)] = field.substr(equals + 1);
    at += bytes;
  }
  return fields->count("op") != 0;
}

bool isConnection(const Fields& fields) {
  return fields.at("op") == "\x07";
}

/// Whether the file begins as a bag that was closed; stands behind the version then.
bool hasIndex(std::ifstream& file) {
  std::string version, header;
  Fields fields;
  if (!std::getline(file, version) || version != "#ROSBAG V2.0") return false;
  const auto first = file.tellg();
  if (!readBlock(file, kMaxHeader, &header) || !readFields(header, &fields)) return false;
  const std::string& position = fields["index_pos"];
  file.seekg(first);
  return position != std::string(sizeof(uint64_t), '\0');
}

/// Reads one record and stands behind it. The data of a connection are fields, too.
bool readRecord(std::ifstream& file, uint64_t file_bytes) {
  std::string header, data;
  Fields fields;
  if (!readBlock(file, kMaxHeader, &header) || !readFields(header, &fields)) return false;
  if (isConnection(fields)) {
    Fields connection{{"op", ""}};
    return readBlock(file, kMaxHeader, &data) && readFields(data, &connection);
  }
  uint32_t bytes = 0;
  if (!file.read(reinterpret_cast<char*>(&bytes), sizeof(bytes))) return false;
  if (uint64_t(file.tellg()) + bytes > file_bytes) return false;
  return bool(file.seekg(bytes, std::ios::cur));
}

}  // namespace

bool areBagRecordsSound(const std::string& path) {
  std::error_code error;
  const uint64_t file_bytes = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !hasIndex(file)) return true;
  while (file && uint64_t(file.tellg()) < file_bytes)
    if (!readRecord(file, file_bytes)) return false;
  return bool(file);
}

}  // namespace markerless_mocap
