#include "studies/reproduce/bakken/bakken_results.h"

#include <cmath>
#include <numeric>

#include "studies/reproduce/result_cache.h"
#include "tools/common/number_format.h"

namespace markerless_mocap {
namespace {

constexpr const char* kHandsAndFeet[] = {"left_hand", "right_hand", "left_foot", "right_foot"};

double meanOf(const std::vector<double>& values) {
  return values.empty()
             ? NAN
             : std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

}  // namespace

LabelResult::LabelResult(const Results& results, const std::string& capture, int edge,
                         const std::string& variant) {
  const auto run = results.find("labels_" + capture + "_" + std::to_string(edge));
  if (run == results.end()) return;
  film_ = &run->second;
  variant_ = &film_->at(variant);
  right_ = numbers("right");
  valid_ = numbers("valid");
}

std::vector<double> LabelResult::numbers(const std::string& key) const {
  return variant_ ? numbersOf(variant_->at(key)) : std::vector<double>();
}

std::vector<double> LabelResult::seconds() const {
  return film_ ? numbersOf(film_->at("seconds")) : std::vector<double>();
}

double LabelResult::right() const {
  return meanOf(right_);
}

double LabelResult::correct() const {
  return meanOf(numbers("correct"));
}

double LabelResult::rightWhere(bool raised) const {
  std::vector<double> there;
  const std::vector<double> hands = film_ ? numbersOf(film_->at("raised")) : std::vector<double>();
  for (size_t f = 0; f < hands.size(); ++f)
    if ((hands[f] != 0.0) == raised) there.push_back(right_[f]);
  return meanOf(there);
}

double LabelResult::raised() const {
  return film_ ? meanOf(numbersOf(film_->at("raised"))) : NAN;
}

double LabelResult::valid() const {
  return meanOf(valid_);
}

double LabelResult::wrongButValid() const {
  return valid() - right();
}

SummaryStatistics LabelResult::error(const std::string& extremity) const {
  std::vector<double> errors = numbers(extremity);
  for (size_t f = 0; f < errors.size(); ++f)
    if (right_[f] == 0.0) errors[f] = NAN;
  return summaryStatistics(errors);
}

std::vector<double> LabelResult::curve() const {
  std::vector<double> mean(frames(), 0.0);
  for (const char* extremity : kHandsAndFeet) {
    const std::vector<double> errors = numbers(extremity);
    for (size_t f = 0; f < mean.size(); ++f) mean[f] += right_[f] == 0.0 ? NAN : 0.25 * errors[f];
  }
  return mean;
}

std::vector<std::string> capturesIn(const Results& results) {
  std::vector<std::string> names;
  for (const char* name : {"whirl", "walk", "walk_spin", "run_crouch_jump", "ballet"})
    if (results.count("labels_" + std::string(name) + "_128")) names.emplace_back(name);
  return names;
}

std::vector<std::string> peopleIn(const Results& results) {
  std::vector<std::string> names;
  for (const auto& [run, result] : results)
    if (run.rfind("labels_people_", 0) == 0 && run.size() > 4 &&
        run.substr(run.size() - 4) == "_128")
      names.push_back(run.substr(7, run.size() - 11));
  return names;
}

SummaryStatistics stageTime(const Results& results, const std::string& capture, int edge,
                            const std::string& stage) {
  const auto run = results.find("times_" + capture + "_" + std::to_string(edge));
  if (run == results.end()) return summaryStatistics({});
  if (stage != "sum") return summaryStatistics(numbersOf(run->second.at(stage)));
  std::vector<double> sum = numbersOf(run->second.at("hull"));
  for (const char* other : {"thinning", "tree"}) {
    const std::vector<double> more = numbersOf(run->second.at(other));
    for (size_t f = 0; f < sum.size(); ++f) sum[f] += more[f];
  }
  return summaryStatistics(sum);
}

std::string meanAndDeviation(const SummaryStatistics& values, int decimals) {
  if (values.count == 0) return "-";
  const std::string format = "%." + std::to_string(decimals) + "f";
  return formatNumber(format.c_str(), values.mean) + " (" +
         formatNumber(format.c_str(), values.deviation) + ")";
}

}  // namespace markerless_mocap
