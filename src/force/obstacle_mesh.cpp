#include "sundrape/force/obstacle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "cubic_spline_grid.hpp"
#include "voxel_distances.hpp"

namespace sundrape {
namespace {

constexpr double most_points = 500e6 / sizeof(double);
constexpr double least_band = 4, usual_band = 6;  // [voxels]

/// Points from the middle of a side to the end of the grid. Beyond the band there are three more, so that the spline is
/// constant where it ends.
double half_count(double size, double voxel_size, double band) {
  return std::ceil((0.5 * size + band) / voxel_size) + 3;
}

double number_of_points(const Vector3& size, double voxel_size, double band) {
  double product = 1;
  for (const double side : size) product *= 2 * half_count(side, voxel_size, band) + 1;
  return product;
}

/// The smallest voxel whose grid is not too large, up to half a per cent larger.
double finest_voxel(const Vector3& size, double band_voxels) {
  double fine = 0, coarse = 0.25 * size.maxCoeff();
  while (coarse - fine > 0.005 * coarse) {
    const double middle = 0.5 * (fine + coarse);
    (number_of_points(size, middle, band_voxels * middle) > most_points ? fine : coarse) = middle;
  }
  return coarse;
}

void require_fit(const Vector3& size, double voxel_size, double band) {
  if (!(voxel_size > 0 && std::isfinite(voxel_size)))
    throw std::invalid_argument("the voxel size of a mesh obstacle must be positive");
  if (!(band >= least_band * voxel_size * (1 - 1e-12) && std::isfinite(band)))
    throw std::invalid_argument(fmt::format("the band of a mesh obstacle must be at least 4 voxels, {:.3g} mm wide",
                                            1e3 * least_band * voxel_size));
  constexpr double as_printed = 1.005;  // what the message says will do must do
  const double coarsest = 0.25 * size.minCoeff();
  const bool too_coarse = voxel_size > as_printed * coarsest,
             too_fine = number_of_points(size, voxel_size, band) > most_points;
  if (!too_coarse && !too_fine) return;
  const double finest = finest_voxel(size, band / voxel_size);
  const auto body =
      fmt::format("a body of {:.3g} mm × {:.3g} mm × {:.3g} mm", 1e3 * size.x(), 1e3 * size.y(), 1e3 * size.z());
  const auto problem =
      fmt::format("voxels of {:.3g} mm are too {} for {}", 1e3 * voxel_size, too_coarse ? "coarse" : "fine", body);
  if (finest > coarsest)
    throw std::invalid_argument(fmt::format("{}, and no others would do: it is too thin for its size", problem));
  throw std::invalid_argument(fmt::format("{}: between {:.3g} mm (500 MB) and {:.3g} mm (4 voxels across) will do",
                                          problem, 1e3 * as_printed * finest, 1e3 * coarsest));
}

/// Symmetric about the middle of the body, so that a symmetric body has a symmetric field.
VoxelGrid grid_around(const Eigen::AlignedBox3d& box, double voxel_size, double band) {
  VoxelGrid grid{box.center(), voxel_size, {}};
  for (int k = 0; k < 3; ++k) {
    const double half = half_count(box.sizes()[k], voxel_size, band);
    grid.origin[k] -= half * voxel_size;
    grid.count[static_cast<std::size_t>(k)] = 2 * static_cast<int>(half) + 1;
  }
  return grid;
}

/// From a point near it, by Newton's iteration along the normal [m].
double way_to_surface(const CubicSplineGrid& field, const Vector3& start, double voxel_size) {
  constexpr int most = 20;
  constexpr double close = 1e-3, flat = 0.1;  // of a voxel; of a normal
  Vector3 x = start;
  for (int k = 0; k < most && field.covers(x); ++k) {
    const auto d = field.at(x);
    if (std::abs(d.gap) < close * voxel_size) return (x - start).norm();
    if (d.normal.norm() < flat) break;
    x -= d.gap * d.normal / d.normal.squaredNorm();
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

MeshObstacle::MeshObstacle(const TriangleMesh& mesh, double voxel_size, double band) : band_(band) {
  check_closed(mesh);
  bounds_ = sundrape::bounds(mesh);
  require_fit(bounds_.sizes(), voxel_size, band);
  const auto grid = grid_around(bounds_, voxel_size, band);
  gap_ = std::make_unique<CubicSplineGrid>(grid, voxel_distances(mesh, grid, band));
  for (const auto& x : mesh.vertices) rounding_ = std::max(rounding_, way_to_surface(*gap_, x, voxel_size));
}

MeshObstacle::MeshObstacle(const TriangleMesh& mesh, double voxel_size)
    : MeshObstacle(mesh, voxel_size, usual_band * voxel_size) {}

MeshObstacle::~MeshObstacle() = default;
MeshObstacle::MeshObstacle(MeshObstacle&&) noexcept = default;
MeshObstacle& MeshObstacle::operator=(MeshObstacle&&) noexcept = default;

Distance MeshObstacle::distance(const Vector3& x) const {
  if (!gap_->covers(x)) return {.gap = band_, .normal = Vector3::Zero(), .curvature = Matrix3::Zero()};
  return gap_->at(x);
}

}  // namespace sundrape
