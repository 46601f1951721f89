#pragma once
#include <span>

#include "sundrape/types.hpp"

namespace sundrape {

/// Something that happens at an instant and changes rates discontinuously (an impact with restitution, a release).
class EventSource {
 public:
  virtual ~EventSource() = default;
  [[nodiscard]] virtual int count() const = 0;
  /// One number an event; it happens where its number falls through zero. State of all points; values: count().
  virtual void evaluate(const State& all, std::span<double> values) const = 0;
  /// Lets the events marked in `fired` happen: may change v (all points, 3P). True if it did.
  virtual bool happen(double time, ConstVectorRef q, VectorRef v, std::span<const int> fired) = 0;
  /// Called after every accepted step.
  virtual void accepted(const State& all) = 0;
  /// Energy that events have turned into heat so far [J].
  [[nodiscard]] virtual double dissipated() const = 0;
};

}  // namespace sundrape
