#pragma once
#include <chrono>
#include <string>

#include "sundrape/app/run.hpp"

namespace sundrape {

/// One line about a long run, rewritten in place on a terminal and printed now and then elsewhere.
class Progress {
 public:
  explicit Progress(Verbosity verbosity);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Whether it is time for another line; asking is cheap.
  [[nodiscard]] bool due() const;
  /// @param fraction  of the work that is done, in [0, 1]; adds the time left. Negative: unknown.
  void show(const std::string& line, double fraction);
  /// A line that stays.
  void say(const std::string& line);
  /// A line that stays, of those who want to see everything.
  void detail(const std::string& line);

 private:
  using Clock = std::chrono::steady_clock;
  void clear_line();

  Verbosity verbosity_;
  bool terminal_;
  bool line_open_ = false;
  Clock::time_point start_, last_;
};

}  // namespace sundrape
