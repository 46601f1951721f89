#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace sundrape {

/// One process of a batch.
struct Task {
  std::size_t id = 0;
  std::string name;                  // its own within the batch
  std::string key;                   // of what it computes: two tasks of one key and name do the same
  std::vector<std::string> command;  // program and arguments
  std::filesystem::path log;         // takes what it says
};

/// How a task has ended: its exit status, 128 + the signal that killed it, or `lost`.
struct EndedTask {
  static constexpr int lost = -1;  // nobody knows: its machine or its worker is gone
  std::size_t id = 0;
  int status = lost;
};

/// Where the processes of a batch run.
class Executor {
 public:
  virtual ~Executor() = default;
  /// Whether it takes another task now.
  [[nodiscard]] virtual bool has_room() const = 0;
  virtual void submit(const Task& task) = 0;
  /// Tasks that have ended since it was asked last.
  [[nodiscard]] virtual std::vector<EndedTask> ended() = 0;
  /// Asks all to write their checkpoints and stop; they end some time after.
  virtual void interrupt() = 0;
};

enum class ExecutorKind { local, slurm, dask };

struct ExecutorOptions {
  ExecutorKind kind = ExecutorKind::local;
  int jobs = 0;                // at a time; 0: one a processor here, as many as there are workers elsewhere
  std::string slurm_options;   // of sbatch, as one writes them
  std::string dask_scheduler;  // address; empty: workers on this machine
};

/// @param folder  of the batch, which all machines that run its tasks see under this name
/// @throws std::invalid_argument  what it needs is not there; the message says what to install
[[nodiscard]] std::unique_ptr<Executor> make_executor(const ExecutorOptions& options,
                                                      const std::filesystem::path& folder);

}  // namespace sundrape
