#include "studies/reproduce/result_cache.h"

#include <cmath>
#include <cstdio>

#include "files/whole_file.h"
#include "ros/package_files.h"

namespace markerless_mocap {

std::string settingsHash(const Json& settings) {
  uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : jsonText(settings, -1)) hash = (hash ^ uint8_t(c)) * 0x100000001b3u;
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

ResultCache::ResultCache(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw std::runtime_error("cannot make " + folder_.string() + ": " + error.message());
}

std::filesystem::path ResultCache::file(const std::string& name, const Json& settings,
                                        const std::string& ending) const {
  return folder_ / (name + "-" + settingsHash(settings) + ending);
}

std::optional<Json> ResultCache::find(const std::string& name, const Json& settings) const {
  const std::string path = file(name, settings, ".json").string();
  if (!isThere(path)) return std::nullopt;
  Json kept = Json::parse(readText(path), nullptr, false);
  if (kept.is_discarded() || !kept.contains("result")) return std::nullopt;
  return kept["result"];
}

void ResultCache::keep(const std::string& name, const Json& settings, const Json& result) const {
  writeWholeFile(file(name, settings, ".json").string(),
                 jsonText({{"settings", settings}, {"result", result}}, -1));
}

double numberOf(const Json& value) {
  return value.is_number() ? value.get<double>() : NAN;
}

std::vector<double> numbersOf(const Json& array) {
  std::vector<double> out;
  for (const Json& value : array) out.push_back(numberOf(value));
  return out;
}

}  // namespace markerless_mocap
