#pragma once

#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace markerless_mocap {

/// Writes messages in the wire format of protocol buffers, as much of it as small ONNX files need.
class ProtoMessage {
 public:
  ProtoMessage& number(int field, uint64_t value) {
    varint(uint64_t(field) << 3);
    varint(value);
    return *this;
  }
  ProtoMessage& text(int field, const std::string& bytes) {
    varint(uint64_t(field) << 3 | 2);
    varint(bytes.size());
    bytes_ += bytes;
    return *this;
  }
  ProtoMessage& nested(int field, const ProtoMessage& message) {
    return text(field, message.bytes_);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  void varint(uint64_t value) {
    for (; value >= 0x80; value >>= 7) bytes_ += char(value | 0x80);
    bytes_ += char(value);
  }

  std::string bytes_;
};

/// A net of a few layers as an ONNX file (opset 11). Field numbers are those of onnx.proto.
class OnnxNet {
 public:
  explicit OnnxNet(const std::vector<int>& input_shape) {
    graph_.text(2, "net").nested(11, valueInfo("image", input_shape));
  }

  /// A convolution by one pixel. \param weights row by row: one row per output plane, one column
  /// per input plane
  OnnxNet& conv1x1(const std::string& from, const std::string& to,
                   const std::vector<std::vector<float>>& weights, const std::vector<float>& bias) {
    std::vector<float> flat;
    for (const auto& row : weights) flat.insert(flat.end(), row.begin(), row.end());
    graph_.nested(5, tensor(to + "_w", {int(weights.size()), int(weights[0].size()), 1, 1}, flat));
    graph_.nested(5, tensor(to + "_b", {int(bias.size())}, bias));
    ProtoMessage node = nodeOf("Conv", {from, to + "_w", to + "_b"}, to);
    graph_.nested(1, node.nested(5, integers("kernel_shape", {1, 1})));
    return *this;
  }
  OnnxNet& sigmoid(const std::string& from, const std::string& to) {
    graph_.nested(1, nodeOf("Sigmoid", {from}, to));
    return *this;
  }
  OnnxNet& transpose(const std::string& from, const std::string& to, const std::vector<int>& axes) {
    graph_.nested(1, nodeOf("Transpose", {from}, to).nested(5, integers("perm", axes)));
    return *this;
  }
  OnnxNet& output(const std::string& name, const std::vector<int>& shape) {
    graph_.nested(12, valueInfo(name, shape));
    return *this;
  }
  void write(const std::string& path) const {
    ProtoMessage model;
    model.number(1, 6).nested(8, ProtoMessage().text(1, "").number(2, 11)).nested(7, graph_);
    std::ofstream(path, std::ios::binary) << model.bytes();
  }

 private:
  static constexpr int kFloat = 1;

  static ProtoMessage valueInfo(const std::string& name, const std::vector<int>& shape) {
    ProtoMessage sizes;
    for (const int size : shape) sizes.nested(1, ProtoMessage().number(1, uint64_t(size)));
    const ProtoMessage tensor = ProtoMessage().number(1, kFloat).nested(2, sizes);
    return ProtoMessage().text(1, name).nested(2, ProtoMessage().nested(1, tensor));
  }
  static ProtoMessage tensor(const std::string& name, const std::vector<int>& shape,
                             const std::vector<float>& values) {
    ProtoMessage tensor;
    for (const int size : shape) tensor.number(1, uint64_t(size));
    std::string raw(values.size() * sizeof(float), '\0');
    std::memcpy(&raw[0], values.data(), raw.size());
    return tensor.number(2, kFloat).text(8, name).text(9, raw);
  }
  static ProtoMessage integers(const std::string& name, const std::vector<int>& values) {
    constexpr int kIntegers = 7;
    ProtoMessage attribute;
    attribute.text(1, name);
    for (const int value : values) attribute.number(8, uint64_t(value));
    return attribute.number(20, kIntegers);
  }
  static ProtoMessage nodeOf(const std::string& type, const std::vector<std::string>& inputs,
                             const std::string& output) {
    ProtoMessage node;
    for (const std::string& input : inputs) node.text(1, input);
    return node.text(2, output).text(3, "make_" + output).text(4, type);
  }

  ProtoMessage graph_;
};

}  // namespace markerless_mocap
