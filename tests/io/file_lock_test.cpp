#include "sundrape/io/file_lock.hpp"

#include <chrono>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sundrape/io/file_error.hpp"

#include "result_samples.hpp"

namespace sundrape {
namespace {

using namespace std::chrono_literals;

/// A process that holds the lock until it is killed, or for a time.
pid_t holder(const std::filesystem::path& guarded, std::chrono::milliseconds time) {
  int ready[2];
  EXPECT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    {
      const FileLock lock(guarded);
      EXPECT_EQ(write(ready[1], "!", 1), 1);
      std::this_thread::sleep_for(time);
    }
    _exit(0);
  }
  char byte = 0;
  EXPECT_EQ(read(ready[0], &byte, 1), 1);
  close(ready[0]);
  close(ready[1]);
  return child;
}

TEST(FileLock, KeepsOthersAwayUntilItsOwnerLetsGo) {
  const samples::TemporaryFolder folder;
  const auto guarded = folder.path() / "result.h5";
  const pid_t child = holder(guarded, 300ms);
  EXPECT_THROW(FileLock{guarded}, FileError);
  { const FileLock waited(guarded, 10); }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "result.h5.lock"));  // nothing is left lying about
  waitpid(child, nullptr, 0);
}

TEST(FileLock, GoesWithItsOwnerHoweverThatEnds) {
  const samples::TemporaryFolder folder;
  const auto guarded = folder.path() / "result.h5";
  const pid_t child = holder(guarded, 60s);
  EXPECT_THROW(FileLock(guarded, 0.05), FileError);
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_NO_THROW(FileLock{guarded});
}

TEST(FileLock, IsForEveryFileItsOwn) {
  const samples::TemporaryFolder folder;
  const FileLock one(folder.path() / "a"), other(folder.path() / "b");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "a.lock"));
}

}  // namespace
}  // namespace sundrape
