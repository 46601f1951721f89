#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace sundrape {

/// Another program that runs at the same time, with what it prints going to a file.
///
/// It is a process group of its own, so that Ctrl-C on the terminal reaches its parent alone, which decides; should the
/// parent be killed, it is asked to stop. Its libraries are told to compute with one thread unless the environment says
/// otherwise. Destroying a running one stops it.
class ChildProcess {
 public:
  /// @param command  program and arguments
  /// @throws std::system_error  it cannot be started, or the log not be written
  ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& log);
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;

  /// How it ended, without waiting for it: its exit status, or 128 + the signal that killed it. Nothing: it runs.
  [[nodiscard]] std::optional<int> status();
  /// Asks it to stop, as Ctrl-C would.
  void interrupt() const;

 private:
  pid_t pid_ = -1;
  std::optional<int> status_;
};

}  // namespace sundrape
