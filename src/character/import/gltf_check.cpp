#include "character/import/gltf_check.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

namespace markerless_mocap {
namespace {

using nlohmann::json;

constexpr size_t kMaxDepth = 500;
constexpr size_t kHead = 20;  // bytes of a binary file before its JSON, whose length is at 12

/// The JSON of the file; discarded if there is none.
json contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(file)), {});
  if (bytes.size() > kHead && bytes.compare(0, 4, "glTF") == 0) {
    uint32_t length = 0;
    std::memcpy(&length, bytes.data() + 12, sizeof(length));
    bytes = bytes.substr(kHead, length);
  }
  return json::parse(bytes, nullptr, false);
}

/// An array of objects; empty if there is none.
std::vector<json> objectsOf(const json& root, const char* key) {
  std::vector<json> objects;
  if (const auto found = root.find(key); found != root.end() && found->is_array())
    for (const json& entry : *found) objects.push_back(entry.is_object() ? entry : json::object());
  return objects;
}

std::vector<std::vector<size_t>> childrenOf(const std::vector<json>& nodes) {
  std::vector<std::vector<size_t>> children(nodes.size());
  for (size_t i = 0; i < nodes.size(); ++i)
    if (const auto found = nodes[i].find("children"); found != nodes[i].end())
      for (const json& child : *found)
        if (child.is_number_unsigned() && child.get<size_t>() < nodes.size())
          children[i].push_back(child.get<size_t>());
  return children;
}

/// Whether a chain of nodes is longer than kMaxDepth, as one that is a circle.
bool isTooDeep(const std::vector<std::vector<size_t>>& children) {
  std::vector<size_t> depth(children.size(), 1), changed(children.size());
  for (size_t i = 0; i < changed.size(); ++i) changed[i] = i;
  while (!changed.empty()) {
    const size_t node = changed.back();
    changed.pop_back();
    if (depth[node] > kMaxDepth) return true;
    for (const size_t child : children[node]) {
      if (depth[child] > depth[node]) continue;
      depth[child] = depth[node] + 1;
      changed.push_back(child);
    }
  }
  return false;
}

}  // namespace

void checkGltf(const std::string& path) {
  const json root = contentOf(path);
  if (!root.is_object()) return;
  const std::vector<json> skins = objectsOf(root, "skins");
  for (size_t i = 0; i < skins.size(); ++i)
    if (!skins[i].contains("inverseBindMatrices"))
      throw std::invalid_argument(path + ": its skin " + std::to_string(i) +
                                  " has no inverseBindMatrices, export it with them");
  if (isTooDeep(childrenOf(objectsOf(root, "nodes"))))
    throw std::invalid_argument(path + ": its nodes are nested more than " +
                                std::to_string(kMaxDepth) + " deep, or in a circle");
}

}  // namespace markerless_mocap
