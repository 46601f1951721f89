#include "cubic_spline_grid.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace sundrape {
namespace {

using Four = Eigen::Array4d;

/// The four cubic B-splines that do not vanish at t ∈ [0, 1) between two points of the grid, and their derivatives.
struct Basis {
  Four value, slope, bend;

  explicit Basis(double t) {
    const double s = 1 - t;
    value << s * s * s / 6, (4 + t * t * (3 * t - 6)) / 6, (4 + s * s * (3 * s - 6)) / 6, t * t * t / 6;
    slope << -s * s / 2, t * (1.5 * t - 2), -s * (1.5 * s - 2), t * t / 2;
    bend << s, 3 * t - 2, 3 * s - 2, t;
  }
};

double dot(const Four& a, const Four& b) { return (a * b).sum(); }

}  // namespace

CubicSplineGrid::CubicSplineGrid(const VoxelGrid& grid, std::vector<double> values)
    : grid_(grid), values_(std::move(values)) {
  if (values_.size() != grid.size()) throw std::invalid_argument("a grid needs one value for each of its points");
}

bool CubicSplineGrid::covers(const Vector3& x) const {
  const Vector3 u = (x - grid_.origin) / grid_.spacing;
  for (int k = 0; k < 3; ++k)
    if (!(u[k] >= 1 && u[k] < grid_.count[static_cast<std::size_t>(k)] - 2)) return false;
  return true;
}

Distance CubicSplineGrid::at(const Vector3& x) const {
  const Vector3 u = (x - grid_.origin) / grid_.spacing, low = u.array().floor();
  const Basis by_x(u.x() - low.x()), by_y(u.y() - low.y()), by_z(u.z() - low.z());
  const auto line = static_cast<std::ptrdiff_t>(grid_.length(2)),
             plane = static_cast<std::ptrdiff_t>(grid_.length(1)) * line;
  const double* first = &values_[grid_.number(static_cast<int>(low.x()) - 1, static_cast<int>(low.y()) - 1,
                                              static_cast<int>(low.z()) - 1)];
  // Four neighbours along z at a time, summed over x and y with every product of derivatives that is needed.
  Four f = Four::Zero(), f_x = f, f_y = f, f_xx = f, f_xy = f, f_yy = f;
  for (int i = 0; i < 4; ++i) {
    Four g = Four::Zero(), g_y = g, g_yy = g;
    for (int j = 0; j < 4; ++j) {
      const Four values = Eigen::Map<const Four>(first + i * plane + j * line);
      g += by_y.value[j] * values;
      g_y += by_y.slope[j] * values;
      g_yy += by_y.bend[j] * values;
    }
    f += by_x.value[i] * g;
    f_x += by_x.slope[i] * g;
    f_xx += by_x.bend[i] * g;
    f_y += by_x.value[i] * g_y;
    f_xy += by_x.slope[i] * g_y;
    f_yy += by_x.value[i] * g_yy;
  }
  const double xy = dot(f_xy, by_z.value), xz = dot(f_x, by_z.slope), yz = dot(f_y, by_z.slope);
  Distance d{.gap = dot(f, by_z.value),
             .normal = {dot(f_x, by_z.value), dot(f_y, by_z.value), dot(f, by_z.slope)},
             .curvature = {}};
  d.curvature << dot(f_xx, by_z.value), xy, xz,  //
      xy, dot(f_yy, by_z.value), yz,             //
      xz, yz, dot(f, by_z.bend);
  d.normal /= grid_.spacing;
  d.curvature /= grid_.spacing * grid_.spacing;
  return d;
}

}  // namespace sundrape
