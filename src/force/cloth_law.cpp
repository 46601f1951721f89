#include "sundrape/force/cloth_law.hpp"

namespace sundrape {
namespace {

constexpr double barrier_share = 0.5;  // d̂/h

}  // namespace

double ClothLaw::barrier_begin(double h) { return barrier_share * h; }

double ClothLaw::pressure(double d, double h) const {
  const double own = law_.pressure(gap(d, h)), limit = barrier_begin(h);
  if (d >= limit) return own;
  const double excess = limit / d - 1;
  return own + 3 * law_.stiffness() * limit * limit * limit * excess * excess / (d * d);
}

double ClothLaw::energy(double d, double h) const {
  const double own = law_.energy(gap(d, h)), limit = barrier_begin(h);
  if (d >= limit) return own;
  const double excess = limit / d - 1;
  return own + law_.stiffness() * limit * limit * excess * excess * excess;
}

double ClothLaw::slope(double d, double h) const {
  const double own = law_.slope(gap(d, h)), limit = barrier_begin(h);
  if (d >= limit) return own;
  const double excess = limit / d - 1;
  return own + 6 * law_.stiffness() * limit * limit * limit * excess * (limit / d + excess) / (d * d * d);
}

}  // namespace sundrape
