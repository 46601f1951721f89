#pragma once
#include <cstdint>
#include <random>

namespace sundrape {

/// Random numbers uniform in ±1, the same on every platform: the standard generators are, the standard distributions
/// are not, so the upper 53 bits are taken as a fraction.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : bits_(seed) {}
  double operator()() { return 2 * (static_cast<double>(bits_() >> 11U) * 0x1p-53) - 1; }

 private:
  std::mt19937_64 bits_;
};

}  // namespace sundrape
