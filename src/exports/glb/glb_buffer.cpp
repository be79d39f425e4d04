#include "exports/glb/glb_buffer.h"

#include <algorithm>
#include <cstdint>

// glTF 2.0, https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
namespace markerless_mocap {
namespace {

void pad(char with, std::string* bytes) {
  bytes->resize((bytes->size() + 3) / 4 * 4, with);
}

void appendUint(size_t value, std::string* bytes) {
  const uint32_t number = uint32_t(value);
  bytes->append(reinterpret_cast<const char*>(&number), sizeof number);
}

std::string chunk(const std::string& bytes, const char* type) {
  std::string out;
  appendUint(bytes.size(), &out);
  out.append(type, 4);
  return out + bytes;
}

}  // namespace

int GlbBuffer::add(const void* data, size_t bytes, size_t count, int component, const char* type,
                   int target) {
  nlohmann::json view{{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes}};
  if (target) view["target"] = target;
  bytes_.append(static_cast<const char*>(data), bytes);
  pad('\0', &bytes_);
  accessors_.push_back({{"bufferView", views_.size()},
                        {"componentType", component},
                        {"count", count},
                        {"type", type}});
  views_.push_back(view);
  return int(accessors_.size()) - 1;
}

int GlbBuffer::addFloats(const std::vector<float>& values, size_t components, const char* type,
                         int target) {
  return add(values.data(), values.size() * sizeof(float), values.size() / components, kFloat, type,
             target);
}

int GlbBuffer::addBounded(const std::vector<float>& values, size_t components, const char* type,
                          int target) {
  const int accessor = addFloats(values, components, type, target);
  std::vector<float> low(values.begin(), values.begin() + std::ptrdiff_t(components)), high = low;
  for (size_t i = 0; i < values.size(); ++i) {
    low[i % components] = std::min(low[i % components], values[i]);
    high[i % components] = std::max(high[i % components], values[i]);
  }
  accessors_[size_t(accessor)]["min"] = low;
  accessors_[size_t(accessor)]["max"] = high;
  return accessor;
}

std::string GlbBuffer::file(nlohmann::json json) const {
  json["buffers"] = nlohmann::json::array({nlohmann::json{{"byteLength", bytes_.size()}}});
  json["bufferViews"] = views_;
  json["accessors"] = accessors_;
  std::string text = json.dump();
  pad(' ', &text);
  const std::string chunks = chunk(text, "JSON") + chunk(bytes_, "BIN\0");
  std::string out = "glTF";
  appendUint(2, &out);
  appendUint(12 + chunks.size(), &out);
  return out + chunks;
}

}  // namespace markerless_mocap
