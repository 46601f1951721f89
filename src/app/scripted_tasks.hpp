#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sundrape/app/executor.hpp"

namespace sundrape {

/// Text as one word of a shell's command.
[[nodiscard]] std::string shell_word(const std::string& text);

/// What a program said and how it ended.
struct Answer {
  int status = 0;
  std::string out;  // standard output and error
};
/// Calls a program found as a shell would find it, and waits for it. @param log  where its answer may be kept meanwhile
[[nodiscard]] Answer ask(std::vector<std::string> command, const std::filesystem::path& log);
/// Whether a program of that name is on the path.
[[nodiscard]] bool is_on_path(const std::string& program);

/// Tasks as shell scripts in a folder that their machines share, numbered from 1. Each leaves its exit status in a file
/// that appears at once as a whole.
class ScriptedTasks {
 public:
  explicit ScriptedTasks(std::filesystem::path folder) : folder_(std::move(folder)) {}

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// Writes a task's script. @throws FileError
  void write(int number, const Task& task) const;
  /// The exit status that a task left; nothing if it has not ended.
  [[nodiscard]] std::optional<int> status(int number) const;
  /// Name and key of the task that a script of an earlier process is for; empty if there is none.
  [[nodiscard]] std::pair<std::string, std::string> owner(int number) const;

 private:
  [[nodiscard]] std::filesystem::path file(int number, const char* ending) const;
  std::filesystem::path folder_;
};

}  // namespace sundrape
