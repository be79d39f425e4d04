#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace markerless_mocap {

/// The binary chunk of a glTF file and the accessors to it.
class GlbBuffer {
 public:
  static constexpr int kByte = 5121, kUint = 5125, kFloat = 5126;  ///< component types

  /// Adds `count` elements and returns their accessor.
  /// \param type "SCALAR", "VEC3", "VEC4" or "MAT4"
  /// \param target 34962: of vertices, 34963: of indices, 0: neither
  int add(const void* data, size_t bytes, size_t count, int component, const char* type,
          int target = 0);
  int addFloats(const std::vector<float>& values, size_t components, const char* type,
                int target = 0);
  /// As addFloats(), with the smallest and the largest of each component.
  int addBounded(const std::vector<float>& values, size_t components, const char* type,
                 int target = 0);

  /// The file. \param json without buffers, bufferViews and accessors
  std::string file(nlohmann::json json) const;

 private:
  std::string bytes_;
  nlohmann::json views_ = nlohmann::json::array(), accessors_ = nlohmann::json::array();
};

}  // namespace markerless_mocap
