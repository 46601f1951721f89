#include "scripted_tasks.hpp"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "sundrape/app/child_process.hpp"

#include "write_text.hpp"

namespace sundrape {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text)
    if (c == '\'')
      word += R"('\'')";
    else
      word += c;
  return word + "'";
}

Answer ask(std::vector<std::string> command, const fs::path& log) {
  command.insert(command.begin(), "/usr/bin/env");
  ChildProcess child(command, log);
  while (!child.status()) std::this_thread::sleep_for(5ms);
  std::ifstream stream(log);
  std::ostringstream text;
  text << stream.rdbuf();
  return {*child.status(), text.str()};
}

bool is_on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((fs::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

fs::path ScriptedTasks::file(int number, const char* ending) const {
  return folder_ / fmt::format("{}{}", number, ending);
}

void ScriptedTasks::write(int number, const Task& task) const {
  fs::remove(file(number, ".status"));
  write_text(file(number, ".owner"), task.name + "\n" + task.key);
  std::string command;
  for (const auto& word : task.command) command += shell_word(word) + " ";
  const auto status = file(number, ".status").string();
  // Signals are for the command, not for the shell, which has to say how it ended. Shells have what runs in their
  // background ignore SIGINT.
  write_text(file(number, ".sh"),
             fmt::format(R"(cd {folder} || exit
trap 'kill -TERM $child 2>/dev/null' INT TERM
{command}> {log} 2>&1 &
child=$!
wait $child
status=$?
while kill -0 $child 2>/dev/null; do
  wait $child
  status=$?
done
echo $status > {status}.tmp
mv {status}.tmp {status}
)",
                         fmt::arg("folder", shell_word(fs::current_path().string())), fmt::arg("command", command),
                         fmt::arg("log", shell_word(task.log.string())), fmt::arg("status", shell_word(status))));
}

std::optional<int> ScriptedTasks::status(int number) const {
  std::ifstream stream(file(number, ".status"));
  int status = 0;
  if (!(stream >> status)) return std::nullopt;
  return status;
}

std::pair<std::string, std::string> ScriptedTasks::owner(int number) const {
  std::ifstream stream(file(number, ".owner"));
  std::string name, key;
  std::getline(stream, name);
  std::getline(stream, key);
  return {name, key};
}

}  // namespace sundrape
