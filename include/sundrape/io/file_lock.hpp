#pragma once
#include <filesystem>

namespace sundrape {

/// Keeps other processes that ask for the same lock away while it lives. The lock is a file NAME.lock beside what it
/// guards; it goes with the process, however that ends, and where the file system knows no locks there is none.
class FileLock {
 public:
  /// @param guarded  the file or folder
  /// @param wait     how long another one's lock is waited for [s]
  /// @throws FileError  another process has it, and does not let go in that time
  explicit FileLock(const std::filesystem::path& guarded, double wait = 0);
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  ~FileLock();

 private:
  /// One try. True if the lock is held, or cannot be had at all.
  [[nodiscard]] bool acquire();

  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace sundrape
