#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

namespace markerless_mocap {

constexpr uintmax_t kMaxTextBytes = 16u << 20;  ///< of a configuration, rig, body or URDF

constexpr uintmax_t kMaxTableBytes = 1u << 30;  ///< of the times of films

/// Throws std::runtime_error unless the path is a regular file of at most `max_bytes`: pipes block
/// and devices never end.
/// \param subject how the sentence names the file, for example "the rig a.yaml"
inline void checkRegularFile(const std::string& path, const std::string& subject,
                             uintmax_t max_bytes) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (path.empty()) throw std::runtime_error("cannot read a file: its name is empty");
  if (!std::filesystem::exists(status))
    throw std::runtime_error("cannot read " + subject + ": there is no such file");
  if (!std::filesystem::is_regular_file(status))
    throw std::runtime_error("cannot read " + subject +
                             ": it is a folder, pipe or device, allowed are files");
  const uintmax_t bytes = std::filesystem::file_size(path, error);
  if (!error && bytes > max_bytes)
    throw std::runtime_error("cannot read " + subject + ": it has " + std::to_string(bytes >> 20) +
                             " MB, allowed are " + std::to_string(max_bytes >> 20) + " MB");
}

/// The text of a file. Throws std::runtime_error as checkRegularFile() for kMaxTextBytes, or if it
/// cannot be read.
inline std::string readTextFile(const std::string& path, const std::string& subject) {
  checkRegularFile(path, subject, kMaxTextBytes);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + subject + ": this user may not");
  std::string text;
  char block[1 << 14];
  // Counted again: files of /proc say that they are empty.
  while (file && text.size() <= kMaxTextBytes) {
    file.read(block, sizeof(block));
    text.append(block, size_t(file.gcount()));
  }
  if (!file.eof() || text.size() > kMaxTextBytes)
    throw std::runtime_error("cannot read " + subject);
  return text;
}

}  // namespace markerless_mocap
