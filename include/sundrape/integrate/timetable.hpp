#pragma once
#include "sundrape/types.hpp"

namespace sundrape {

/// What happens to the supports of a system at times known beforehand: grippers close and open.
class Timetable {
 public:
  virtual ~Timetable() = default;
  /// When something happens next [s]; infinite if nothing does.
  [[nodiscard]] virtual double next() const = 0;
  /// Lets everything happen that is due at a state of all points; it may change the system's supports.
  /// @throws IntegrationFailure
  virtual void happen(const State& all) = 0;
};

}  // namespace sundrape
