#pragma once
#include <chrono>
#include <optional>

#include "sundrape/app/interrupt.hpp"

namespace sundrape {

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
