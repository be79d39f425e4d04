#include "studies/reproduce/programs.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "ros/package_files.h"

extern char** environ;

namespace markerless_mocap {
namespace {

namespace fs = std::filesystem;

std::string lastLine(const std::string& path) {
  std::istringstream lines(isThere(path) ? readText(path) : "");
  std::string line, last;
  while (std::getline(lines, line))
    if (!line.empty()) last = line;
  return last;
}

/// Waits for the program. \return its exit code
int execute(const std::vector<std::string>& words, const std::string& log_file) {
  std::vector<char*> raw;
  for (const std::string& word : words) raw.push_back(const_cast<char*>(word.c_str()));
  raw.push_back(nullptr);
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_addopen(&streams, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&streams, STDERR_FILENO, log_file.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0644);
  pid_t child = 0;
  const int failed = posix_spawn(&child, raw[0], &streams, nullptr, raw.data(), environ);
  posix_spawn_file_actions_destroy(&streams);
  if (failed != 0) throw std::runtime_error("cannot run " + words[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

}  // namespace

void runProgram(const std::string& name, const std::vector<std::string>& arguments,
                const std::string& log_file) {
  std::vector<std::string> words{(fs::read_symlink("/proc/self/exe").parent_path() / name)};
  words.insert(words.end(), arguments.begin(), arguments.end());
  if (execute(words, log_file) != 0)
    throw std::runtime_error(name + " failed: " + lastLine(log_file) + " (" + log_file + ")");
}

Json captureSettings(const Capture& capture) {
  Json settings{{"render", 1}};  // of this version of the studio
  for (const auto& [key, value] : capture.studio) settings[key] = value;
  return settings;
}

std::vector<PaperRun> renderRuns(std::vector<Capture>* captures, const ResultCache& cache) {
  std::vector<PaperRun> runs;
  for (Capture& capture : *captures) {
    Json settings = captureSettings(capture);
    capture.bag = cache.file(capture.name, settings, ".bag").string();
    std::vector<std::string> arguments{capture.bag, "--masks", "--images", "jpeg"};
    for (const auto& [key, value] : capture.studio) {
      arguments.push_back("--set");
      arguments.push_back(key + "=" + value);
    }
    const std::string bag = capture.bag;
    runs.push_back({"render_" + capture.name, settings, [arguments, bag] {
                      runProgram("render_capture", arguments, bag + ".log");
                      return Json(true);
                    }});
    if (!isThere(bag)) fs::remove(cache.file(runs.back().name, settings, ".json"));
  }
  return runs;
}

std::string resultBag(const PaperRun& run, const std::string& folder) {
  return ResultCache(folder).file(run.name, run.settings, ".bag").string();
}

PaperRun offlineRun(const Capture& capture, const OfflineStudy& study, const std::string& folder) {
  PaperRun run;
  run.name = study.name;
  run.settings = {{"capture", captureSettings(capture)},
                  {"arguments", study.arguments},
                  {"evaluate", study.evaluate_arguments}};
  run.settings["config"] = study.config.empty() ? "" : readText(study.config);
  const std::string out = resultBag(run, folder);
  std::vector<std::string> arguments{capture.bag, out};
  if (!study.config.empty()) arguments.insert(arguments.end(), {"--config", study.config});
  arguments.insert(arguments.end(), study.arguments.begin(), study.arguments.end());
  std::vector<std::string> measuring{out, "--truth", capture.bag, "--json", out + ".json"};
  measuring.insert(measuring.end(), study.evaluate_arguments.begin(),
                   study.evaluate_arguments.end());
  run.work = [arguments, measuring, out] {
    runProgram("mocap_offline", arguments, out + ".log");
    runProgram("evaluate", measuring, out + ".evaluate.log");
    return Json::parse(readText(out + ".json"));
  };
  return run;
}

}  // namespace markerless_mocap
