#include "sundrape/app/run_batch.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <list>
#include <thread>

#include <fmt/format.h>

#include "sundrape/app/interrupt.hpp"
#include "sundrape/app/progress.hpp"
#include "sundrape/app/stop_request.hpp"
#include "sundrape/io/case_reader.hpp"
#include "sundrape/io/file_error.hpp"
#include "sundrape/io/file_lock.hpp"
#include "sundrape/io/result_reader.hpp"
#include "sundrape/version.hpp"

#include "last_line.hpp"

namespace sundrape {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

enum class Earlier { nothing, done, resumable };

constexpr const char* marker = ".sundrape-batch";  // in folders whose results may be written anew

/// What an earlier batch left in a file, if it is of this very case. Relaxations are not gone on with: their fictitious
/// motion would have lost its momentum and could end elsewhere.
Earlier earlier_result(const fs::path& file, const Case& c, bool may_resume) {
  if (!fs::exists(file)) return Earlier::nothing;
  try {
    const ResultReader result(file);
    if (result.case_text() != c.text || result.inputs() != c.inputs || result.version() != version())
      return Earlier::nothing;
    if (result.status() == "done") return Earlier::done;
    const bool out_of_time = result.status() == "failed" && says_out_of_time(result.message());
    const bool stopped = may_resume && (result.status() != "failed" || out_of_time);
    return stopped && c.analysis != Analysis::relaxation && result.checkpoint() ? Earlier::resumable : Earlier::nothing;
  } catch (const FileError&) {  // broken: run again
    return Earlier::nothing;
  }
}

class Batch {
 public:
  Batch(const std::vector<BatchRun>& runs, const BatchOptions& options)
      : runs_(runs), options_(options), folder_(options.folder), outcomes_(runs.size()), progress_(options.verbosity) {}

  std::vector<BatchOutcome> run() {
    fs::create_directories(folder_);
    const FileLock lock(folder_ / marker);  // two batches in one folder would run everything twice
    sort_out();
    const InterruptGuard guard;
    const auto executor = make_executor(options_.executor, folder_);
    while (!(waiting_.empty() || asked_to_stop_) || working_ > 0) {
      while (!asked_to_stop_ && !waiting_.empty() && executor->has_room()) start_next(*executor);
      std::this_thread::sleep_for(5ms);
      collect(*executor);
      if (InterruptGuard::requested() && !asked_to_stop_) {
        asked_to_stop_ = true;
        executor->interrupt();
      }
    }
    return std::move(outcomes_);
  }

 private:
  struct Waiting {
    std::size_t index;
    bool resume;
  };

  /// Checks every run's case before the first one starts, and looks which results are there.
  void sort_out() {
    const bool own = fs::exists(folder_ / marker);
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const auto c = read_case(options_.case_file, runs_[i].sets);
      keys_.push_back(fmt::format("{:016x}", std::hash<std::string>()(c.text + c.inputs + version())));
      outcomes_[i].result = folder_ / (runs_[i].name + ".h5");
      const auto earlier = earlier_result(outcomes_[i].result, c, options_.resume);
      if (earlier == Earlier::nothing && !own && fs::exists(outcomes_[i].result))
        throw FileError(
            fmt::format("{}: exists already and is of no earlier study or crosscheck: choose another folder "
                        "(-o), or move it away",
                        outcomes_[i].result.string()));
      if (earlier == Earlier::done) {
        outcomes_[i].status = BatchStatus::done;
        outcomes_[i].reused = true;
      } else {
        waiting_.push_back({i, earlier == Earlier::resumable});
      }
    }
    std::ofstream(folder_ / marker) << "Results in this folder belong to a study or a crosscheck.\n";
    tries_.resize(runs_.size());
    finished_ = runs_.size() - waiting_.size();
    if (finished_ > 0) progress_.say(fmt::format("{} of {} results are there already", finished_, runs_.size()));
  }

  void start_next(Executor& executor) {
    const auto [index, resume] = waiting_.front();
    waiting_.pop_front();
    const auto result = outcomes_[index].result.string();
    // a run of an earlier batch that was killed may still be ending its step
    std::vector<std::string> command{this_program(), "run", options_.case_file.string(), "--quiet", "--wait", "60"};
    if (resume)
      command.insert(command.end(), {"--resume", result});
    else
      command.insert(command.end(), {"-o", result, "--force"});
    for (const auto& set : runs_[index].sets) command.insert(command.end(), {"--set", set});
    executor.submit(
        {.id = index, .name = runs_[index].name, .key = keys_[index], .command = command, .log = log_of(index)});
    ++tries_[index];
    ++working_;
  }

  void collect(Executor& executor) {
    for (const auto& [index, status] : executor.ended()) {
      --working_;
      finish(index, status);
      show(true);
    }
    show(false);
  }

  void finish(std::size_t index, int status) {
    auto& outcome = outcomes_[index];
    if (status == 0) {
      ++finished_;
      outcome.status = BatchStatus::done;
      std::error_code ignored;
      fs::remove(log_of(index), ignored);
      return;
    }
    const bool lost = status == EndedTask::lost || status > 128;  // also 130: somebody stopped it, and it was not us
    if (asked_to_stop_ && lost) return;                           // which leaves it as interrupted
    outcome.message = status == EndedTask::lost ? "its process was lost"
                      : status == 130           ? "stopped by a signal"
                      : lost                    ? fmt::format("killed by signal {}", status - 128)
                                                : last_line(log_of(index));
    if (outcome.message.empty()) outcome.message = fmt::format("exit status {}", status);
    if (lost && tries_[index] <= options_.retries) {
      progress_.say(fmt::format("{}: {}; trying again", runs_[index].name, outcome.message));
      outcome.message.clear();
      const auto c = read_case(options_.case_file, runs_[index].sets);
      waiting_.push_back({index, earlier_result(outcome.result, c, options_.resume) == Earlier::resumable});
      return;
    }
    ++finished_;
    outcome.status = BatchStatus::failed;
    if (lost && tries_[index] > 1) outcome.message += fmt::format(", {} times", tries_[index]);
    ++failed_;
    progress_.say(fmt::format("{} failed: {}", runs_[index].name, outcome.message));
  }

  void show(bool changed) {
    if (!changed && !progress_.due()) return;
    if (options_.verbosity == Verbosity::quiet) return;
    auto text = fmt::format("{} of {} runs finished, {} {}", finished_, runs_.size(), working_,
                            options_.executor.kind == ExecutorKind::local ? "running" : "queued or running");
    if (failed_ > 0) text += fmt::format(", {} failed", failed_);
    progress_.show(text, static_cast<double>(finished_) / static_cast<double>(runs_.size()));
  }

  /// The very program that runs, even if its file has been replaced since; elsewhere by its name.
  [[nodiscard]] std::string this_program() const {
    constexpr const char* self = "/proc/self/exe";
    return options_.executor.kind == ExecutorKind::local ? self : fs::read_symlink(self).string();
  }
  [[nodiscard]] fs::path log_of(std::size_t index) const { return folder_ / (runs_[index].name + ".log"); }

  const std::vector<BatchRun>& runs_;
  const BatchOptions& options_;
  fs::path folder_;
  std::vector<BatchOutcome> outcomes_;
  Progress progress_;
  std::list<Waiting> waiting_;
  std::vector<std::string> keys_;  // of what each run computes
  std::vector<int> tries_;
  std::size_t working_ = 0, finished_ = 0, failed_ = 0;
  bool asked_to_stop_ = false;
};

}  // namespace

std::vector<BatchOutcome> run_batch(const std::vector<BatchRun>& runs, const BatchOptions& options) {
  return Batch(runs, options).run();
}

}  // namespace sundrape
