#include "skeleton/labelling/model_reader.h"

#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr const char* kNumber = "a finite number";
constexpr const char* kMap = "a map";

YAML::Node parsed(const std::string& yaml, const std::string& where) {
  try {
    return YAML::Load(yaml);
  } catch (const YAML::Exception& fault) {
    throw std::invalid_argument(where + " is not YAML: " + fault.msg);
  }
}

bool isFinite(const YAML::Node& node, double* value) {
  return YAML::convert<double>::decode(node, *value) && std::isfinite(*value);
}

}  // namespace

ModelReader::ModelReader(const std::string& yaml, const std::string& where)
    : ModelReader(parsed(yaml, where), where, "") {
  if (!node_.IsMap()) throw std::invalid_argument(where + " must be " + kMap);
}

ModelReader::ModelReader(const YAML::Node& node, const std::string& file, const std::string& path)
    : node_(node), file_(file), path_(path) {}

void ModelReader::fail(const std::string& key, const std::string& fault) const {
  throw std::invalid_argument(file_ + ": " + path_ + key + ' ' + fault);
}

YAML::Node ModelReader::take(const std::string& key, const char* expected) {
  known_.insert(key);
  const YAML::Node node = node_[key];
  if (!node) fail(key, std::string("is missing, it must be ") + expected);
  return node;
}

ModelReader ModelReader::map(const std::string& key) {
  const YAML::Node node = take(key, kMap);
  if (!node.IsMap()) fail(key, std::string("must be ") + kMap);
  return ModelReader(node, file_, path_ + key + '/');
}

double ModelReader::number(const std::string& key) {
  double value = 0.0;
  if (!isFinite(take(key, kNumber), &value)) fail(key, std::string("must be ") + kNumber);
  return value;
}

PiecewiseLinear ModelReader::curve(const std::string& key) {
  constexpr const char* kKnots = "at least two finite numbers";
  ModelReader section = map(key);
  PiecewiseLinear curve{section.number("low"), section.number("high"), {}};
  if (!(curve.low < curve.high)) section.fail("high", "must be above low");
  const YAML::Node knots = section.take("knots", kKnots);
  for (const YAML::Node& knot : knots) {
    double value = 0.0;
    if (!isFinite(knot, &value)) section.fail("knots", std::string("must be ") + kKnots);
    curve.knots.push_back(value);
  }
  if (curve.knots.size() < 2) section.fail("knots", std::string("must be ") + kKnots);
  section.finish();
  return curve;
}

void ModelReader::finish() const {
  std::set<std::string> seen;
  for (const auto& entry : node_) {
    const std::string key = entry.first.as<std::string>("");
    if (!known_.count(key)) fail(key, "is not a key of this file");
    if (!seen.insert(key).second) fail(key, "is given twice");
  }
}

}  // namespace markerless_mocap
