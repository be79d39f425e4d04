#include "studies/reproduce/reproduce.h"

#include <algorithm>

#include "files/whole_file.h"
#include "studies/reproduce/programs.h"

namespace markerless_mocap {
namespace {

std::string quoted(std::string text) {
  for (size_t at = 0; (at = text.find('"', at)) != std::string::npos; at += 2)
    text.insert(at, 1, '"');
  return '"' + text + '"';
}

std::vector<Capture> capturesOf(const Paper& paper, const Overrides& studio) {
  std::vector<Capture> captures = paper.captures();
  for (Capture& capture : captures)
    for (const auto& change : studio) {
      auto& own = capture.studio;
      const auto same = [&](const auto& entry) { return entry.first == change.first; };
      own.erase(std::remove_if(own.begin(), own.end(), same), own.end());
      own.push_back(change);
    }
  return captures;
}

}  // namespace

const char* verdictName(Verdict verdict) {
  static const char* kNames[] = {"holds", "holds partly", "does not hold", "not measured"};
  return kNames[size_t(verdict)];
}

std::string claimsCsv(const std::vector<Claim>& claims) {
  std::string out = "place,sentence,ours,verdict\n";
  for (const Claim& claim : claims)
    out += quoted(claim.place) + ',' + quoted(claim.sentence) + ',' + quoted(claim.ours) + ',' +
           verdictName(claim.verdict) + '\n';
  return out;
}

Page paperPage(const std::string& title, const std::vector<Claim>& claims, const Page& body) {
  Page page(title);
  std::vector<std::vector<std::string>> rows;
  for (const Claim& claim : claims)
    rows.push_back({claim.place, claim.sentence, claim.ours, verdictName(claim.verdict)});
  page.heading("What the paper says, and what is found here");
  page.table({"place", "the paper", "here", "verdict"}, rows);
  Json content = body.content();
  for (Json& part : content["parts"]) page.add(std::move(part));
  return page;
}

std::vector<Claim> reproduce(const Paper& paper, const ReproduceRequest& request,
                             const Overrides& studio, const RunListOptions& options) {
  const ResultCache cache(request.folder / "cache");
  std::vector<Capture> captures = capturesOf(paper, studio);
  const std::vector<PaperRun> films = renderRuns(&captures, cache);
  executeRuns(films, cache, options);
  const Results results = executeRuns(paper.runs(captures), cache, options);
  Page body("");
  const std::vector<Claim> claims = paper.report(results, &body);
  writeWholeFile((request.folder / "index.html").string(),
                 paperPage(paper.title(), claims, body).html());
  writeWholeFile((request.folder / "claims.csv").string(), claimsCsv(claims));
  Json all = Json::object();
  for (const auto& [name, result] : results) all[name] = result;
  writeWholeFile((request.folder / "results.json").string(), jsonText(all, -1));
  return claims;
}

}  // namespace markerless_mocap
