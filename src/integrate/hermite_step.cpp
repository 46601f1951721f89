#include "hermite_step.hpp"

#include <utility>

namespace sundrape {

void HermiteStep::start_from(End end) { begin_ = end_ = std::move(end); }

void HermiteStep::advance(double time, ConstVectorRef y, ConstVectorRef rates) {
  std::swap(begin_, end_);
  end_.time = time;
  end_.y = y;
  end_.rates = rates;
}

void HermiteStep::interpolate(double time, VectorRef y) const {
  const double h = end_.time - begin_.time;
  const double s = h > 0 ? (time - begin_.time) / h : 1, r = 1 - s;
  y = r * r * (1 + 2 * s) * begin_.y + s * s * (3 - 2 * s) * end_.y + h * s * r * (r * begin_.rates - s * end_.rates);
}

void HermiteStep::extrapolate(double time, VectorRef y) const {
  const double h = end_.time - begin_.time, ahead = time - end_.time;
  y = end_.y + ahead * end_.rates;
  if (h <= 0) return;
  const double s = ahead / h;
  y += s * s * (begin_.y - end_.y + h * end_.rates);
}

}  // namespace sundrape
