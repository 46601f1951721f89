#include "sundrape/app/progress.hpp"

#include <cstdio>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

namespace sundrape {
namespace {

std::string left(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

}  // namespace

Progress::Progress(Verbosity verbosity)
    : verbosity_(verbosity), terminal_(isatty(STDOUT_FILENO) == 1), start_(Clock::now()), last_(start_) {}

Progress::~Progress() { clear_line(); }

bool Progress::due() const {
  if (verbosity_ == Verbosity::quiet) return false;
  using namespace std::chrono_literals;
  return Clock::now() - last_ >
         (terminal_ || verbosity_ == Verbosity::verbose ? Clock::duration(200ms) : Clock::duration(5s));
}

void Progress::show(const std::string& line, double fraction) {
  last_ = Clock::now();
  std::string text = line;
  const double elapsed = std::chrono::duration<double>(last_ - start_).count();
  if (fraction > 0.01)
    text += fmt::format(", {:.0f} % done, {} left", 100 * fraction, left(elapsed * (1 - fraction) / fraction));
  if (terminal_) {
    fmt::print("\r\033[K{}", text);
    line_open_ = true;
  } else {
    fmt::print("{}\n", text);
  }
  std::fflush(stdout);
}

void Progress::say(const std::string& line) {
  if (verbosity_ == Verbosity::quiet) return;
  clear_line();
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

void Progress::detail(const std::string& line) {
  if (verbosity_ == Verbosity::verbose) say(line);
}

void Progress::clear_line() {
  if (line_open_) fmt::print("\r\033[K");
  line_open_ = false;
}

}  // namespace sundrape
