#include "local_executor.hpp"

#include <algorithm>
#include <thread>

namespace sundrape {

LocalExecutor::LocalExecutor(int jobs)
    : jobs_(jobs > 0 ? static_cast<std::size_t>(jobs) : std::max(1U, std::thread::hardware_concurrency())) {}

void LocalExecutor::submit(const Task& task) { working_.emplace_back(task.id, ChildProcess(task.command, task.log)); }

std::vector<EndedTask> LocalExecutor::ended() {
  std::vector<EndedTask> all;
  for (auto work = working_.begin(); work != working_.end();) {
    if (const auto status = work->second.status()) {
      all.push_back({work->first, *status});
      work = working_.erase(work);
    } else {
      ++work;
    }
  }
  return all;
}

void LocalExecutor::interrupt() {
  for (auto& [id, child] : working_) child.interrupt();
}

}  // namespace sundrape
