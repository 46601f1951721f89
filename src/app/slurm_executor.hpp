#pragma once
#include <chrono>
#include <map>
#include <set>

#include "sundrape/app/executor.hpp"

#include "scripted_tasks.hpp"

namespace sundrape {

/// Job arrays of Slurm. Tasks tell of their end by files; the queue is asked which of them are still there.
///
/// Jobs bear a name made of the batch's folder, so that a process that is started after another one was killed finds
/// its jobs, and takes those over that do what it would do.
class SlurmExecutor final : public Executor {
 public:
  SlurmExecutor(const ExecutorOptions& options, const std::filesystem::path& folder);

  [[nodiscard]] bool has_room() const override { return true; }  // Slurm's queue has
  void submit(const Task& task) override;
  [[nodiscard]] std::vector<EndedTask> ended() override;
  void interrupt() override;

 private:
  using Clock = std::chrono::steady_clock;
  struct Place {
    int array = 0, number = 0;  // our own count of arrays, and the script in it
    auto operator<=>(const Place&) const = default;
  };
  struct Working {
    std::size_t id = 0;
    int missed = 0;  // how often the queue has not known it
  };

  [[nodiscard]] ScriptedTasks scripts(int array) const;
  /// Tasks that wait or run; nothing if the queue does not answer.
  [[nodiscard]] std::optional<std::set<Place>> queued() const;
  void adopt();
  void send();
  void send_array(const std::vector<Task>& tasks);
  void cancel(const std::set<Place>& places) const;
  void look_for_the_lost(std::vector<EndedTask>& ended);

  ExecutorOptions options_;
  std::filesystem::path folder_;
  std::string job_name_;
  int arrays_ = 0;                        // sent so far, those of earlier processes included
  std::map<Place, std::string> orphans_;  // jobs of an earlier process, by what they do
  std::vector<Task> unsent_;
  std::map<Place, Working> working_;
  Clock::time_point last_look_;
};

}  // namespace sundrape
