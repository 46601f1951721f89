#pragma once
#include <chrono>
#include <ctime>

namespace sundrape {

/// Wall-clock and processor time that a run has taken, with what it took before it was resumed [s].
class RunClock {
 public:
  [[nodiscard]] double wall() const {
    return wall_before_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_start_).count();
  }
  [[nodiscard]] double cpu() const {
    return cpu_before_ + static_cast<double>(std::clock() - cpu_start_) / CLOCKS_PER_SEC;
  }
  void carry_over(double wall, double cpu) {
    wall_before_ = wall;
    cpu_before_ = cpu;
  }

 private:
  std::chrono::steady_clock::time_point wall_start_ = std::chrono::steady_clock::now();
  std::clock_t cpu_start_ = std::clock();
  double wall_before_ = 0, cpu_before_ = 0;
};

}  // namespace sundrape
