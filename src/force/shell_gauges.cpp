#include "sundrape/force/shell_gauges.hpp"

#include <algorithm>
#include <cmath>

#include "shell_reference.hpp"

namespace sundrape {
namespace {

/// (Δ/2)/sin(Δ/2) for a turn Δ over an element; t,ξ is half the chord between the directors of its two sides.
double geodesic_factor(double half_chord) {
  const double s = std::min(half_chord, 1.0);
  return s < 1e-6 ? 1 : std::asin(s) / s;
}

}  // namespace

double largest_principal_strain(const ShellReadings::Rows3& strains) {
  double largest = 0;
  for (Eigen::Index e = 0; e < strains.rows(); ++e) {
    const double mean = 0.5 * (strains(e, 0) + strains(e, 1)), half = 0.5 * (strains(e, 0) - strains(e, 1));
    largest = std::max(largest, mean + std::hypot(half, 0.5 * strains(e, 2)));
  }
  return largest;
}

/// Covariant measures at the centre.
struct ShellGauges::Gauge {
  Vector3 metric;         // ½|x,ξ|², ½|x,η|², x,ξ·x,η
  Eigen::Vector2d slant;  // x,ξ·t, x,η·t
  Vector3 bend;           // x,ξ·t,ξ, x,η·t,η, x,ξ·t,η + x,η·t,ξ
};

ShellGauges::ShellGauges(std::vector<ShellElement> elements, const ShellSection& section, const ShellOptions& options)
    : elements_(std::move(elements)), section_(section), options_(options) {}

ShellGauges::Gauge ShellGauges::gauge(const std::array<Vector3, 4>& x, const std::array<Vector3, 4>& t,
                                      bool spans) const {
  const auto by_xi = [](const auto& v) -> Vector3 { return 0.25 * (v[1] + v[2] - v[0] - v[3]); };
  const auto by_eta = [](const auto& v) -> Vector3 { return 0.25 * (v[2] + v[3] - v[0] - v[1]); };
  const auto by_both = [](const auto& v) -> Vector3 { return 0.25 * (v[0] + v[2] - v[1] - v[3]); };
  const Vector3 x1 = by_xi(x), x2 = by_eta(x), t1 = by_xi(t), t2 = by_eta(t);
  const Vector3 mean = 0.25 * (t[0] + t[1] + t[2] + t[3]);
  const bool geodesic = options_.curvature == CurvatureMeasure::geodesic;
  Gauge g;
  g.metric = {0.5 * x1.squaredNorm(), 0.5 * x2.squaredNorm(), x1.dot(x2)};
  g.slant = {x1.dot(mean) + by_both(x).dot(t2), x2.dot(mean) + by_both(x).dot(t1)};  // means of the tied edges
  const auto lateral = [&](const Vector3& chord) {                                   // as the kernel has it
    return geodesic && spans ? 1 / std::sqrt(1 - std::min(chord.squaredNorm(), 0.9)) : 1.0;
  };
  g.bend = {lateral(t2) * (geodesic ? geodesic_factor(t1.norm()) : 1) * x1.dot(t1),
            lateral(t1) * (geodesic ? geodesic_factor(t2.norm()) : 1) * x2.dot(t2), x1.dot(t2) + x2.dot(t1)};
  return g;
}

ShellReadings ShellGauges::read(ConstVectorRef q) const {
  const auto rows = static_cast<Eigen::Index>(elements_.size());
  ShellReadings r;
  for (auto* m : {&r.membrane_strain, &r.membrane_force, &r.curvature, &r.moment}) m->resize(rows, 3);
  for (auto* m : {&r.shear_strain, &r.shear_force}) m->resize(rows, 2);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const auto& e = elements_[static_cast<std::size_t>(row)];
    std::array<Vector3, 4> x, t;
    for (std::size_t k = 0; k < 4; ++k) {
      x[k] = point(q, e.nodes[k]);
      t[k] = point(q, e.directors[k]) / options_.director_length;
    }
    const auto now = gauge(x, t, e.spans), rest = gauge(e.position, e.director, e.spans);
    const auto axes = centre_axes(e);
    const Vector3 strain = axes.strain * (now.metric - rest.metric), curvature = axes.strain * (now.bend - rest.bend);
    const Eigen::Vector2d shear = axes.covariant.transpose() * (now.slant - rest.slant);
    r.membrane_strain.row(row) = strain;
    r.membrane_force.row(row) = section_.membrane * strain;
    r.shear_strain.row(row) = shear;
    r.shear_force.row(row) = section_.shear * shear;
    r.curvature.row(row) = curvature;
    r.moment.row(row) = section_.bending.at<double>(curvature).moment;
  }
  return r;
}

ShellReadings read(const std::vector<ShellGauges>& parts, ConstVectorRef q) {
  ShellReadings all = parts.front().read(q);
  const auto append = [](auto& rows, const auto& more) {
    rows.conservativeResize(rows.rows() + more.rows(), Eigen::NoChange);
    rows.bottomRows(more.rows()) = more;
  };
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const auto part = parts[k].read(q);
    append(all.membrane_strain, part.membrane_strain);
    append(all.membrane_force, part.membrane_force);
    append(all.shear_strain, part.shear_strain);
    append(all.shear_force, part.shear_force);
    append(all.curvature, part.curvature);
    append(all.moment, part.moment);
  }
  return all;
}

}  // namespace sundrape
