#pragma once
#include <algorithm>
#include <ctime>
#include <limits>

namespace sundrape {

/// Processor time since its construction [s]: other programs on the machine lengthen it less than the wall clock's.
class CpuClock {
 public:
  [[nodiscard]] double seconds() const { return static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

 private:
  std::clock_t start_ = std::clock();
};

/// Least processor time of some calls of `work` [s].
template <class Work>
double least_cpu(int calls, const Work& work) {
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < calls; ++k) {
    const CpuClock clock;
    work();
    least = std::min(least, clock.seconds());
  }
  return least;
}

}  // namespace sundrape
