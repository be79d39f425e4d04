#include <algorithm>
#include <nlohmann/json.hpp>

#include "text/joined.h"
#include "tools/check/check_recording.h"

namespace markerless_mocap {
namespace {

double lengthOf(const SeenRig& rig) {
  int64_t first = std::numeric_limits<int64_t>::max(), last = 0;
  for (const SeenCamera& camera : rig.cameras)
    for (const SeenImage& image : camera.images) {
      first = std::min(first, image.received_ns);
      last = std::max(last, image.received_ns);
    }
  return last > first ? 1e-9 * double(last - first) : 0.0;
}

int count(const Findings& findings, Severity severity) {
  return int(std::count_if(findings.begin(), findings.end(),
                           [&](const Finding& finding) { return finding.severity == severity; }));
}

std::string counted(int number, const std::string& noun) {
  return std::to_string(number) + " " + noun + (number == 1 ? "" : "s");
}

}  // namespace

CheckResult resultOf(const SeenRig& rig, const std::string& source) {
  CheckResult result;
  result.source = source;
  for (const SeenCamera& camera : rig.cameras) result.cameras.push_back(camera.name);
  result.seconds = lengthOf(rig);
  result.findings = checkRig(rig);
  result.not_checked = notChecked(rig);
  return result;
}

bool isAnythingWrong(const CheckResult& result) {
  return count(result.findings, Severity::kError) + count(result.findings, Severity::kWarning) > 0;
}

void print(const CheckResult& result, std::ostream& out) {
  for (const Finding& finding : result.findings)
    out << toString(finding.severity) << ": " << finding.what
        << (finding.camera.empty() ? "" : " (" + finding.camera + ")") << "\n  " << finding.evidence
        << "\n  -> " << finding.remedy << '\n';
  for (const std::string& sentence : result.not_checked) out << "not checked: " << sentence << '\n';
  const int errors = count(result.findings, Severity::kError);
  const int warnings = count(result.findings, Severity::kWarning);
  out << counted(int(result.cameras.size()), "camera") << " (" << joined(result.cameras) << "), "
      << std::lround(result.seconds) << " s: ";
  if (errors + warnings == 0)
    out << "nothing wrong was found\n";
  else
    out << counted(errors, "error") << ", " << counted(warnings, "warning") << '\n';
}

std::string jsonOf(const CheckResult& result) {
  nlohmann::ordered_json root;
  root["source"] = result.source;
  root["cameras"] = result.cameras;
  root["seconds"] = result.seconds;
  root["ok"] = !isAnythingWrong(result);
  root["findings"] = nlohmann::ordered_json::array();
  for (const Finding& finding : result.findings)
    root["findings"].push_back({{"what", finding.what},
                                {"camera", finding.camera},
                                {"severity", toString(finding.severity)},
                                {"evidence", finding.evidence},
                                {"remedy", finding.remedy}});
  root["not_checked"] = result.not_checked;
  return root.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace markerless_mocap
