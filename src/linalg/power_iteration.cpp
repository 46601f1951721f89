#include "sundrape/linalg/power_iteration.hpp"

#include <random>

namespace sundrape {

double largest_eigenvalue(const BlockMatrix& a, const Vector& row_mass) {
  constexpr int iterations = 200;
  const auto n = 3 * static_cast<Eigen::Index>(a.size());
  Vector x(n), y(n);
  std::mt19937 random(1);
  for (Eigen::Index k = 0; k < n; ++k)
    x[k] = static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 0.5;
  double eigenvalue = 0;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const double size = x.norm();
    if (size == 0) return 0;
    x /= size;
    a.multiply(x, y);
    for (Eigen::Index r = 0; r < row_mass.size(); ++r) y.segment<3>(3 * r) /= row_mass[r];
    eigenvalue = x.dot(y);
    x.swap(y);
  }
  return eigenvalue;
}

}  // namespace sundrape
