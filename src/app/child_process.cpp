#include "sundrape/app/child_process.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

namespace sundrape {
namespace {

[[noreturn]] void fail(const std::string& what) { throw std::system_error(errno, std::generic_category(), what); }

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  list.reserve(texts.size() + 1);
  for (auto& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

/// This process's environment with one thread for every library that does not know better.
std::vector<std::string> environment() {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) all.emplace_back(*entry);
  for (const char* name : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"})
    if (std::getenv(name) == nullptr) all.push_back(std::string(name) + "=1");
  return all;
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& log) {
  const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (out < 0) fail(log.string());
  auto words = command, settings = environment();
  const auto arguments = pointers(words), variables = pointers(settings);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) {  // only calls that are safe between fork and exec
    setpgid(0, 0);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
    if (getppid() != parent) _exit(127);
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    execve(arguments[0], arguments.data(), variables.data());
    _exit(127);
  }
  const int problem = errno;
  close(out);
  errno = problem;
  if (pid_ < 0) fail(command.front());
}

ChildProcess::~ChildProcess() {
  if (pid_ < 0 || status()) return;
  kill(pid_, SIGTERM);
  while (!status()) usleep(10000);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)), status_(other.status_) {}

std::optional<int> ChildProcess::status() {
  if (status_ || pid_ < 0) return status_;
  int how = 0;
  const pid_t ended = waitpid(pid_, &how, WNOHANG);
  if (ended == pid_) status_ = WIFEXITED(how) ? WEXITSTATUS(how) : 128 + WTERMSIG(how);
  if (ended < 0 && errno == ECHILD) status_ = 127;  // somebody else has waited for it
  return status_;
}

void ChildProcess::interrupt() const {
  if (pid_ > 0 && !status_) kill(pid_, SIGINT);
}

}  // namespace sundrape
