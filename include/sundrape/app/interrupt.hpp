#pragma once

namespace sundrape {

/// While one lives, Ctrl-C and SIGTERM only set a flag, so that a run can end its step and write a checkpoint; a second
/// signal kills as usual.
class InterruptGuard {
 public:
  InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  ~InterruptGuard();

  [[nodiscard]] static bool requested();
};

}  // namespace sundrape
