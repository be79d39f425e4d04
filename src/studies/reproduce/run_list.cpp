#include "studies/reproduce/run_list.h"

#include <tbb/task_arena.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "studies/reproduce/work_progress.h"
#include "tools/common/bags_in_threads.h"

namespace markerless_mocap {
namespace {

/// The runs of one pass, executed by several threads.
class Workers {
 public:
  Workers(const ResultCache& cache, const RunListOptions& options, WorkProgress* progress,
          Results* results)
      : cache_(cache), options_(options), progress_(progress), results_(results) {}

  void execute(const std::vector<const PaperRun*>& runs, int threads) {
    const BagsInThreads bags;
    std::atomic<size_t> next{0};
    std::vector<std::thread> workers;
    for (int i = 0; i < threads; ++i)
      workers.emplace_back([&] {
        for (size_t at = next++; at < runs.size() && !options_.interrupted(); at = next++)
          execute(*runs[at]);
      });
    for (std::thread& worker : workers) worker.join();
  }
  const std::string& failure() const { return failure_; }

 private:
  void execute(const PaperRun& run) {
    try {
      Json result;
      if (run.alone) {
        result = run.work();
      } else {
        tbb::task_arena one_thread(1);
        one_thread.execute([&] { result = run.work(); });
      }
      cache_.keep(run.name, run.settings, result);
      const std::lock_guard<std::mutex> lock(mutex_);
      (*results_)[run.name] = std::move(result);
      progress_->add(run.name, run.cost);
    } catch (const std::exception& error) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (failure_.empty()) failure_ = run.name + ": " + error.what();
      progress_->add(run.name + " failed", run.cost);
    }
  }

  const ResultCache& cache_;
  const RunListOptions& options_;
  WorkProgress* progress_;
  Results* results_;
  std::mutex mutex_;
  std::string failure_;
};

void requireNames(const std::vector<PaperRun>& runs) {
  std::set<std::string> names;
  for (const PaperRun& run : runs)
    if (!names.insert(run.name).second)
      throw std::invalid_argument("two runs are named " + run.name);
}

}  // namespace

Results executeRuns(const std::vector<PaperRun>& runs, const ResultCache& cache,
                    const RunListOptions& options) {
  requireNames(runs);
  Results results;
  std::vector<const PaperRun*> beside, alone;
  double cost = 0.0;
  for (const PaperRun& run : runs) {
    if (!options.again)
      if (std::optional<Json> kept = cache.find(run.name, run.settings)) {
        results[run.name] = std::move(*kept);
        continue;
      }
    (run.alone ? alone : beside).push_back(&run);
    cost += run.cost;
  }
  WorkProgress progress(cost, options.notes, options.terminal);
  Workers workers(cache, options, &progress, &results);
  workers.execute(beside, options.at_once);
  workers.execute(alone, 1);
  progress.finish();
  if (options.interrupted()) throw std::runtime_error("interrupted; what is done is kept");
  if (!workers.failure().empty()) throw std::runtime_error(workers.failure());
  return results;
}

}  // namespace markerless_mocap
