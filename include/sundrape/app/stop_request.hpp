#pragma once
#include <chrono>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "sundrape/app/interrupt.hpp"

namespace sundrape {

/// What a run says that its time limit [s] has ended: where, and what to try; `table` is that of the analysis.
[[nodiscard]] inline std::string out_of_time_message(double limit, const std::string& where, const char* table) {
  return fmt::format("time limit of {:g} s reached {}: continue with --resume, or raise {}.time_limit", limit, where,
                     table);
}
/// Whether a failed run's message is such a one.
[[nodiscard]] inline bool says_out_of_time(const std::string& message) { return message.starts_with("time limit"); }

/// Whether a run is to end before it is done: a signal, or the wall clock.
class StopRequest {
 public:
  /// @param time_limit  from now on [s]; none: no limit
  explicit StopRequest(std::optional<double> time_limit) : time_limit_(time_limit), start_(Clock::now()) {}

  [[nodiscard]] bool wanted() {
    if (time_limit_ && std::chrono::duration<double>(Clock::now() - start_).count() > *time_limit_) out_of_time_ = true;
    return out_of_time_ || InterruptGuard::requested();
  }
  /// Whether it was the clock that the last wanted() went by.
  [[nodiscard]] bool out_of_time() const { return out_of_time_; }

 private:
  using Clock = std::chrono::steady_clock;
  std::optional<double> time_limit_;
  Clock::time_point start_;
  bool out_of_time_ = false;
};

}  // namespace sundrape
