#pragma once
#include <list>
#include <utility>

#include "sundrape/app/child_process.hpp"
#include "sundrape/app/executor.hpp"

namespace sundrape {

/// Children of this process, `jobs` at a time.
class LocalExecutor final : public Executor {
 public:
  explicit LocalExecutor(int jobs);

  [[nodiscard]] bool has_room() const override { return working_.size() < jobs_; }
  void submit(const Task& task) override;
  [[nodiscard]] std::vector<EndedTask> ended() override;
  void interrupt() override;

 private:
  std::size_t jobs_;
  std::list<std::pair<std::size_t, ChildProcess>> working_;
};

}  // namespace sundrape
