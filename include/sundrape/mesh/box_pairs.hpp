#pragma once
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace sundrape {

/// The pairs (i, j), i < j, of boxes that overlap or touch, in ascending order.
///
/// Hybrid of sweeps and streamed segment trees (Zomorodian, Edelsbrunner 2002; CGAL): n log³ n at worst, and near n log
/// n for boxes of one size. Boxes that are not finite are not allowed.
[[nodiscard]] std::vector<std::pair<int, int>> overlapping_pairs(std::span<const Eigen::AlignedBox3d> boxes);

}  // namespace sundrape
