#include "sundrape/app/run_batch.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <list>
#include <map>
#include <thread>

#include <fmt/format.h>

#include "sundrape/app/child_process.hpp"
#include "sundrape/app/interrupt.hpp"
#include "sundrape/app/progress.hpp"
#include "sundrape/app/stop_request.hpp"
#include "sundrape/io/case_reader.hpp"
#include "sundrape/io/file_error.hpp"
#include "sundrape/io/result_reader.hpp"
#include "sundrape/version.hpp"

#include "last_line.hpp"

namespace sundrape {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

constexpr const char* this_program = "/proc/self/exe";  // the very one, even if its file has been replaced since

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
      : runs_(runs),
        options_(options),
        jobs_(options.jobs > 0 ? options.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))),
        outcomes_(runs.size()),
        progress_(options.verbosity) {}

  std::vector<BatchOutcome> run() {
    sort_out();
    const InterruptGuard guard;
    while (!(waiting_.empty() || asked_to_stop_) || !working_.empty()) {
      while (!asked_to_stop_ && !waiting_.empty() && static_cast<int>(working_.size()) < jobs_) start_next();
      std::this_thread::sleep_for(20ms);
      collect();
      if (InterruptGuard::requested() && !asked_to_stop_) {
        asked_to_stop_ = true;
        for (auto& [index, child] : working_) child.interrupt();
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
    fs::create_directories(options_.folder);
    const bool own = fs::exists(options_.folder / marker);
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const auto c = read_case(options_.case_file, runs_[i].sets);
      outcomes_[i].result = options_.folder / (runs_[i].name + ".h5");
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
    std::ofstream(options_.folder / marker) << "Results in this folder belong to a study or a crosscheck.\n";
    finished_ = runs_.size() - waiting_.size();
    if (finished_ > 0) progress_.say(fmt::format("{} of {} results are there already", finished_, runs_.size()));
  }

  void start_next() {
    const auto [index, resume] = waiting_.front();
    waiting_.pop_front();
    const auto result = outcomes_[index].result.string();
    std::vector<std::string> command{this_program, "run", options_.case_file.string(), "--quiet"};
    if (resume)
      command.insert(command.end(), {"--resume", result});
    else
      command.insert(command.end(), {"-o", result, "--force"});
    for (const auto& set : runs_[index].sets) command.insert(command.end(), {"--set", set});
    working_.emplace_back(index, ChildProcess(command, log_of(index)));
  }

  void collect() {
    for (auto work = working_.begin(); work != working_.end();) {
      const auto status = work->second.status();
      if (!status) {
        ++work;
        continue;
      }
      finish(work->first, *status);
      work = working_.erase(work);
      show(true);
    }
    show(false);
  }

  void finish(std::size_t index, int status) {
    auto& outcome = outcomes_[index];
    ++finished_;
    if (status == 0) {
      outcome.status = BatchStatus::done;
      std::error_code ignored;
      fs::remove(log_of(index), ignored);
      return;
    }
    outcome.status = status == 130 ? BatchStatus::interrupted : BatchStatus::failed;
    outcome.message =
        status > 128 && status != 130 ? fmt::format("killed by signal {}", status - 128) : last_line(log_of(index));
    if (outcome.message.empty()) outcome.message = fmt::format("exit status {}", status);
    if (outcome.status != BatchStatus::failed) return;
    ++failed_;
    progress_.say(fmt::format("{} failed: {}", runs_[index].name, outcome.message));
  }

  void show(bool changed) {
    if (!changed && !progress_.due()) return;
    if (options_.verbosity == Verbosity::quiet) return;
    auto text = fmt::format("{} of {} runs finished, {} running", finished_, runs_.size(), working_.size());
    if (failed_ > 0) text += fmt::format(", {} failed", failed_);
    progress_.show(text, static_cast<double>(finished_) / static_cast<double>(runs_.size()));
  }

  [[nodiscard]] fs::path log_of(std::size_t index) const { return options_.folder / (runs_[index].name + ".log"); }

  const std::vector<BatchRun>& runs_;
  const BatchOptions& options_;
  int jobs_;
  std::vector<BatchOutcome> outcomes_;
  Progress progress_;
  std::list<Waiting> waiting_;
  std::list<std::pair<std::size_t, ChildProcess>> working_;
  std::size_t finished_ = 0, failed_ = 0;
  bool asked_to_stop_ = false;
};

}  // namespace

std::vector<BatchOutcome> run_batch(const std::vector<BatchRun>& runs, const BatchOptions& options) {
  return Batch(runs, options).run();
}

}  // namespace sundrape
