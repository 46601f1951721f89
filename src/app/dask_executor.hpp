#pragma once
#include <cstdio>
#include <map>
#include <memory>

#include "sundrape/app/executor.hpp"

#include "scripted_tasks.hpp"

namespace sundrape {

/// Workers of Dask distributed: a Python program beside this one hands tasks to the scheduler, and tells of their end
/// by files. It stops them when this process is gone.
class DaskExecutor final : public Executor {
 public:
  DaskExecutor(const ExecutorOptions& options, const std::filesystem::path& folder);

  [[nodiscard]] bool has_room() const override { return true; }  // the scheduler's queue has
  void submit(const Task& task) override;
  [[nodiscard]] std::vector<EndedTask> ended() override;
  void interrupt() override;

 private:
  struct CloseRunner {
    void operator()(std::FILE* pipe) const;
  };

  void start_runner();

  ExecutorOptions options_;
  ScriptedTasks scripts_;
  std::string python_;
  std::unique_ptr<std::FILE, CloseRunner> runner_;  // its standard input
  std::map<int, std::size_t> working_;              // ids by the numbers of scripts
  int written_ = 0;
};

}  // namespace sundrape
