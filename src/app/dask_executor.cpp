#include "dask_executor.hpp"

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

#include <fmt/format.h>

#include "dask_runner.hpp"
#include "write_text.hpp"

namespace sundrape {
namespace {

namespace fs = std::filesystem;

/// A Python that has Dask distributed: the one on the path, or the system's.
std::string find_python(const fs::path& log) {
  for (const std::string python : {"python3", "/usr/bin/python3"})
    if (ask({python, "-c", "import distributed"}, log).status == 0) return python;
  throw std::invalid_argument(
      "--executor dask: no python3 here has Dask distributed: install it (Debian's package is python3-distributed), or "
      "use --executor local");
}

}  // namespace

void DaskExecutor::CloseRunner::operator()(std::FILE* pipe) const { pclose(pipe); }

DaskExecutor::DaskExecutor(const ExecutorOptions& options, const fs::path& folder)
    : options_(options), scripts_(fs::absolute(folder) / ".dask") {
  fs::remove_all(scripts_.folder());
  fs::create_directories(scripts_.folder());
  python_ = find_python(scripts_.folder() / "python.txt");
  if (options_.dask_scheduler.empty())
    if (const char* address = std::getenv("DASK_SCHEDULER_ADDRESS")) options_.dask_scheduler = address;
  std::signal(SIGPIPE, SIG_IGN);  // a runner that has ended is noticed by the tasks that it loses
  start_runner();
}

void DaskExecutor::start_runner() {
  const auto program = scripts_.folder() / "runner.py";
  write_text(program, dask_runner);
  fs::remove(scripts_.folder() / "ended");
  // a session of its own: Ctrl-C is for us to pass on
  const auto command =
      fmt::format("exec setsid {} {} {} {} {} >> {} 2>&1", shell_word(python_), shell_word(program.string()),
                  shell_word(scripts_.folder().string()), shell_word(options_.dask_scheduler), options_.jobs,
                  shell_word((scripts_.folder() / "runner.log").string()));
  runner_.reset(popen(command.c_str(), "we"));
  if (!runner_)
    throw std::system_error(errno, std::generic_category(), "the Python program for Dask cannot be started");
}

void DaskExecutor::submit(const Task& task) {
  const int number = ++written_;
  scripts_.write(number, task);
  working_.emplace(number, task.id);
  fmt::print(runner_.get(), "{}\n", number);
  std::fflush(runner_.get());
}

std::vector<EndedTask> DaskExecutor::ended() {
  std::vector<EndedTask> all;
  const bool gone = fs::exists(scripts_.folder() / "ended");  // before the files are looked at, which come first
  for (auto work = working_.begin(); work != working_.end();) {
    const auto status = scripts_.status(work->first);
    if (status || gone) {
      all.push_back({work->second, status.value_or(EndedTask::lost)});
      work = working_.erase(work);
    } else {
      ++work;
    }
  }
  if (gone) {
    runner_.reset();
    start_runner();
  }
  return all;
}

void DaskExecutor::interrupt() { write_text(scripts_.folder() / "stop", ""); }

}  // namespace sundrape
