#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>
#include <thread>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "result_samples.hpp"

namespace sundrape {
namespace {

Checkpoint checkpoint_of(std::uint64_t frame) {
  return {
      .arrays = {{"q", std::vector<double>(3000, static_cast<double>(frame))}, {"time", {static_cast<double>(frame)}}}};
}

/// Writes frames, steps, probes, warnings and checkpoints until it is killed.
[[noreturn]] void write_until_killed(const std::filesystem::path& file) {
  const auto header =
      samples::header(/*cells=*/12, /*expected_frames=*/4);  // so that it outgrows its space soon and often
  ResultWriter writer(file, header);
  for (std::uint64_t frame = 0;; ++frame) {
    samples::append(writer, header, frame);
    if (frame % 3 == 0) writer.write_checkpoint(checkpoint_of(frame));
    if (frame % 7 == 0) writer.add_warning("frame " + std::to_string(frame));
    if (frame == 300) {  // an end is killed as well
      writer.finish(ResultStatus::done);
      ::_exit(0);
    }
  }
}

void start_and_kill(const std::filesystem::path& file, std::chrono::microseconds after) {
  const pid_t writer = ::fork();
  ASSERT_GE(writer, 0);
  if (writer == 0) write_until_killed(file);
  std::this_thread::sleep_for(after);
  ::kill(writer, SIGKILL);
  int status = 0;
  ASSERT_EQ(::waitpid(writer, &status, 0), writer);
}

/// What a checkpoint must look like, if there is one.
void expect_whole_checkpoint(const ResultReader& reader) {
  const auto checkpoint = reader.checkpoint();
  if (!checkpoint) return;
  const double frame = checkpoint->arrays.at("time").at(0);
  for (const double value : checkpoint->arrays.at("q")) ASSERT_EQ(value, frame);
  EXPECT_EQ(checkpoint->frames, static_cast<std::uint64_t>(frame) + 1);
  EXPECT_LE(checkpoint->frames, reader.frames());
  EXPECT_LE(checkpoint->steps, reader.steps());
}

/// The first interpreter that has h5py; empty if none.
std::string python_with_h5py() {
  for (std::string python : {"python3", "/usr/bin/python3"})
    if (std::system((python + " -c 'import h5py, numpy' 2>/dev/null").c_str()) == 0) return python;
  return {};
}

TEST(ResultWriterKilledVerification, LeavesAReadableFileWithRightFramesAtAnyOf150Moments) {
  // A kill is the same in memory as on a disk, but a busy disk would keep most writers waiting in their first fsync.
  const std::filesystem::path memory = "/dev/shm";
  const samples::TemporaryFolder folder(std::filesystem::exists(memory) ? memory
                                                                        : std::filesystem::temp_directory_path());
  std::mt19937 random(20);  // moments differ between machines anyhow
  std::uniform_int_distribution<int> microseconds(500, 150000);
  std::size_t frames = 0;
  int with_file = 0, with_frames = 0, with_checkpoint = 0, while_replacing = 0;
  for (int kill = 0; kill < 150; ++kill) {
    const auto file = folder.path() / ("killed-" + std::to_string(kill) + ".h5");
    ASSERT_NO_FATAL_FAILURE(start_and_kill(file, std::chrono::microseconds(microseconds(random))));
    while_replacing += std::filesystem::exists(file.string() + ".tmp");
    if (!std::filesystem::exists(file)) continue;  // killed before the file had its name
    ++with_file;
    const ResultReader reader(file);
    frames += reader.frames();
    with_frames += reader.frames() > 0;
    with_checkpoint += reader.checkpoint().has_value();
    EXPECT_EQ(samples::complaint(reader), "") << file;
    ASSERT_NO_FATAL_FAILURE(expect_whole_checkpoint(reader));
    EXPECT_GE(reader.steps() + 5, 5 * reader.frames()) << "steps are published before the frame that they lead to";
  }
  std::printf(
      "150 kills: %d files with %zu frames, %d with any, %d with a checkpoint, %d killed while a new file was "
      "written\n",
      with_file, frames, with_frames, with_checkpoint, while_replacing);
  EXPECT_GE(with_frames, 100);
  EXPECT_GE(frames, 1000U) << "the writers hardly came beyond their start";
  EXPECT_GE(while_replacing, 5) << "too few kills hit a replacement to prove anything about it";

  const auto python = python_with_h5py();
  if (python.empty()) GTEST_SKIP() << "no Python with h5py: checked with the C++ reader only";
  const auto command = python + " " + SUNDRAPE_SOURCE_DIR + "/tests/io/read_with_h5py.py " + folder.path().string();
  EXPECT_EQ(std::system(command.c_str()), 0);
}

}  // namespace
}  // namespace sundrape
