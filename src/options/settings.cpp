#include "options/settings.h"

#include <algorithm>
#include <stdexcept>

#include "options/option_check.h"
#include "options/option_texts.h"

namespace markerless_mocap {
namespace {

using Member = std::variant<bool*, int*, double*, std::string*>;

/// A member that is a setting, with the end of its name.
struct Slot {
  std::string suffix;
  Member member;
};

struct SlotsOf {
  template <class T>
  std::vector<Slot> operator()(T* member) const {
    return {{"", member}};
  }
  std::vector<Slot> operator()(const OptionField::Range& range) const {
    return {{"_min", range.min}, {"_max", range.max}};
  }
  std::vector<Slot> operator()(Eigen::Vector3d* v) const {
    return {{"_x", &v->x()}, {"_y", &v->y()}, {"_z", &v->z()}};
  }
  std::vector<Slot> operator()(std::vector<std::string>*) const { return {}; }
};

std::vector<Slot> slotsOf(const OptionField& field) {
  return std::visit(SlotsOf(), field.value);
}

std::string textOf(const Setting::Value& value) {
  Setting copy{"", "", value};
  return std::visit([](auto& v) { return valueText({"", "", &v}); }, copy.value);
}

/// Returns false if the value is of another type.
bool assign(const Setting::Value& value, const Member& member) {
  if (const auto* whole = std::get_if<int>(&value); whole && std::get_if<double*>(&member)) {
    *std::get<double*>(member) = *whole;
    return true;
  }
  return std::visit(
      [&](auto* to) {
        const auto* from = std::get_if<std::decay_t<decltype(*to)>>(&value);
        if (from) *to = *from;
        return from != nullptr;
      },
      member);
}

template <class T>
void copyMember(const T* from, T* to) {
  *to = *from;
}
void copyMember(const OptionField::Range& from, const OptionField::Range& to) {
  *to.min = *from.min;
  *to.max = *from.max;
}

}  // namespace

std::string settingPrefix(std::string path) {
  std::replace(path.begin(), path.end(), '/', '_');
  return path;
}

std::vector<std::string> settingNames(const std::string& prefix, const OptionField& field) {
  std::vector<std::string> names;
  for (const Slot& slot : slotsOf(field)) names.push_back(prefix + field.key + slot.suffix);
  return names;
}

void SettingVisitor::visitField(const OptionField& field) {
  if (!fixed_.count(path_ + field.key)) visitSetting(path_, field);
}

void SettingVisitor::visitSection(const char* key, const char*, const Fields& fields) {
  if (fixed_.count(path_ + key)) return;
  const std::string outer = path_;
  path_ += std::string(key) + "/";
  fields(*this);
  path_ = outer;
}

void FixedFields::visitField(const OptionField& field) {
  if (inside_ || fixed_.count(path_ + field.key)) values_.push_back(field.value);
}

void FixedFields::visitSection(const char* key, const char*, const Fields& fields) {
  const std::string outer = path_;
  const bool was_inside = inside_;
  inside_ = inside_ || fixed_.count(path_ + key);
  path_ += std::string(key) + "/";
  fields(*this);
  path_ = outer;
  inside_ = was_inside;
}

void FixedFields::take(const FixedFields& from) const {
  for (size_t i = 0; i < values_.size(); ++i)
    std::visit([&](auto to) { copyMember(std::get<decltype(to)>(from.values_[i]), to); },
               values_[i]);
}

void SettingLister::visitSetting(const std::string& path, const OptionField& field) {
  const std::vector<std::string> names = settingNames(settingPrefix(path), field);
  const std::vector<Slot> slots = slotsOf(field);
  for (size_t i = 0; i < slots.size(); ++i)
    settings.push_back({names[i], field.meaning,
                        std::visit([](auto* v) { return Setting::Value(*v); }, slots[i].member),
                        field.min_value, field.max_value, field.allowed});
}

void SettingChanger::visitSetting(const std::string& path, const OptionField& field) {
  const std::vector<std::string> names = settingNames(settingPrefix(path), field);
  const std::vector<Slot> slots = slotsOf(field);
  const std::string where = stage_ + "/" + path + field.key;
  bool changed = false;
  for (size_t i = 0; i < slots.size(); ++i) {
    const auto change = changes_.find(names[i]);
    if (change == changes_.end()) continue;
    if (!assign(change->second, slots[i].member))
      throwNotAllowed(where, textOf(change->second), allowedText(field));
    changes_.erase(change);
    changed = true;
  }
  if (changed) checkOption(where, field);
}

void SettingChanger::finish() const {
  if (changes_.empty()) return;
  throw std::invalid_argument(stage_ + " has no setting " + changes_.begin()->first +
                              " that can be changed while it runs");
}

}  // namespace markerless_mocap
