#include "sundrape/io/file_lock.hpp"

#include <cerrno>
#include <chrono>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "sundrape/io/file_error.hpp"

namespace sundrape {

using namespace std::chrono_literals;

FileLock::FileLock(const std::filesystem::path& guarded, double wait) : path_(guarded) {
  path_ += ".lock";
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(wait);
  while (!acquire()) {
    if (std::chrono::steady_clock::now() >= until)
      throw FileError(
          fmt::format("{}: another process is at work on it ({} is locked)", guarded.string(), path_.string()));
    std::this_thread::sleep_for(50ms);
  }
}

FileLock::~FileLock() {
  if (file_ < 0) return;
  unlink(path_.c_str());  // while it is still ours: whoever waits for it looks again which file the name stands for
  close(file_);
}

bool FileLock::acquire() {
  const int file = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) return true;  // a folder that cannot be written says so itself, and better
  if (flock(file, LOCK_EX | LOCK_NB) != 0) {
    const bool held = errno == EWOULDBLOCK || errno == EINTR;
    close(file);
    return !held;
  }
  struct stat ours {
  }, named{};
  if (fstat(file, &ours) != 0 || stat(path_.c_str(), &named) != 0 || ours.st_ino != named.st_ino) {
    close(file);  // its last owner has removed it since it was opened
    return false;
  }
  file_ = file;
  return true;
}

}  // namespace sundrape
