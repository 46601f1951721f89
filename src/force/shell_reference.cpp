#include "shell_reference.hpp"

#include <cmath>
#include <stdexcept>

#include <Eigen/Dense>

namespace sundrape {
namespace {

using Matrix3x6 = Eigen::Matrix<double, 3, 6>;

/// ¼Σξ_I v_I, ¼Σξ_Iη_I v_I, ¼Ση_I v_I
template <class V>
struct Modes {
  V a, b, c;

  explicit Modes(const std::array<V, 4>& v)
      : a(0.25 * (v[1] + v[2] - v[0] - v[3])),
        b(0.25 * (v[0] + v[2] - v[1] - v[3])),
        c(0.25 * (v[2] + v[3] - v[0] - v[1])) {}
  [[nodiscard]] V by_xi(double eta) const { return a + eta * b; }
  [[nodiscard]] V by_eta(double xi) const { return c + xi * b; }
};

ShellAxes axes_at(const Modes<Vector3>& x, const Modes<Eigen::Vector2d>& material, double xi, double eta) {
  const Vector3 a1 = x.by_xi(eta), a2 = x.by_eta(xi);
  ShellAxes f;
  f.normal = a1.cross(a2);
  // along the warp: x,w = x,ξ ξ,w + x,η η,w; without material coordinates along ξ
  Eigen::Matrix2d by_parent;
  by_parent << material.by_xi(eta), material.by_eta(xi);
  Vector3 warp = a1;
  if (std::abs(by_parent.determinant()) > 1e-9 * f.normal.norm()) {
    const Eigen::Vector2d parent_by_warp = by_parent.inverse().col(0);
    warp = parent_by_warp[0] * a1 + parent_by_warp[1] * a2;
  }
  const Vector3 e1 = warp.normalized(), e2 = f.normal.normalized().cross(e1);
  Eigen::Matrix2d covariant;  // A_α · e_i
  covariant << a1.dot(e1), a1.dot(e2), a2.dot(e1), a2.dot(e2);
  f.covariant = covariant.inverse().transpose();
  const auto& l = f.covariant;
  f.strain << l(0, 0) * l(0, 0), l(1, 0) * l(1, 0), l(0, 0) * l(1, 0),  //
      l(0, 1) * l(0, 1), l(1, 1) * l(1, 1), l(0, 1) * l(1, 1),          //
      2 * l(0, 0) * l(0, 1), 2 * l(1, 0) * l(1, 1), l(0, 0) * l(1, 1) + l(0, 1) * l(1, 0);
  return f;
}

/// Covariant strains (E₁₁, E₂₂, 2E₁₂) from the six numbers s, at (ξ, η).
Matrix3x6 compatible_strains(double xi, double eta) {
  Matrix3x6 r;
  r << 1, 0, 0, eta, 0, eta * eta,  //
      0, 1, 0, 0, xi, xi * xi,      //
      0, 0, 1, xi, eta, 2 * xi * eta;
  return r;
}

/// The same with E₁₁ tied at (0, ±1), E₂₂ at (±1, 0) and E₁₂ at the centre.
Matrix3x6 edge_tied_strains(double xi, double eta) {
  Matrix3x6 r;
  r << 1, 0, 0, eta, 0, 1,  //
      0, 1, 0, 0, xi, 1,    //
      0, 0, 1, 0, 0, 0;
  return r;
}

struct IntegrationPoint {
  double xi, eta;
  ShellAxes frame;
  double area;
};

/// Young's modulus times thickness of a strip cut along a direction [N/m].
double strip_stiffness(const Eigen::Matrix3d& membrane, const Eigen::Vector2d& direction) {
  const Eigen::Matrix3d s = membrane.inverse();
  const Eigen::Vector2d n = direction.normalized();
  const double c2 = n[0] * n[0], s2 = n[1] * n[1];
  return 1 / (s(0, 0) * c2 * c2 + (2 * s(0, 1) + s(2, 2)) * c2 * s2 + s(1, 1) * s2 * s2);
}

/// W = ½ A E₀ᵀ D E₀ + ½ factor (A E h/3) (ĥ₁²/|A|⁴ + ĥ₂²/|C|⁴) with ĥ₁ = a·γ, ĥ₂ = c·γ, γ = b − β₁ a − β₂ c.
Eigen::Matrix<double, 6, 6> centre_field(const Modes<Vector3>& x, const ShellAxes& centre, const ShellElement& element,
                                         const ShellSection& section, double area) {
  const Matrix3x6 strains = centre.strain * compatible_strains(0, 0);
  Eigen::Matrix<double, 6, 6> c = area * strains.transpose() * section.membrane * strains;
  Eigen::Matrix2d metric;
  metric << x.a.dot(x.a), x.a.dot(x.c), x.a.dot(x.c), x.c.dot(x.c);
  const Eigen::Vector2d beta = metric.inverse() * Eigen::Vector2d(x.a.dot(x.b), x.c.dot(x.b));
  Eigen::Matrix<double, 6, 1> h1, h2;
  h1 << -2 * beta[0], 0, -beta[1], 1, 0, 0;
  h2 << 0, -2 * beta[1], -beta[0], 0, 1, 0;
  const Eigen::Matrix2d axes = centre.covariant.inverse().transpose();  // rows: A_α in warp–weft axes
  const auto stiffness = [&](int alpha) {
    const double length2 = axes.row(alpha).squaredNorm();
    return element.hourglass_factor * area / 3 * strip_stiffness(section.membrane, axes.row(alpha)) /
           (length2 * length2);
  };
  c += stiffness(0) * h1 * h1.transpose() + stiffness(1) * h2 * h2.transpose();
  return c;
}

/// Stresses β₁ + β₄ (η − η̄), β₂ + β₅ (ξ − ξ̄), β₃ along the parent axes of the centre, condensed: C = Lᵀ H⁻¹ L.
Eigen::Matrix<double, 6, 6> mixed_field(const std::array<IntegrationPoint, 4>& points, const ShellAxes& centre,
                                        const ShellSection& section, double area) {
  double mean_xi = 0, mean_eta = 0;
  for (const auto& p : points) {
    mean_xi += p.area * p.xi / area;
    mean_eta += p.area * p.eta / area;
  }
  const Eigen::Matrix3d to_axes = centre.strain.transpose().inverse(), compliance = section.membrane.inverse();
  Eigen::Matrix<double, 5, 5> h = Eigen::Matrix<double, 5, 5>::Zero();
  Eigen::Matrix<double, 5, 6> l = Eigen::Matrix<double, 5, 6>::Zero();
  for (const auto& p : points) {
    Eigen::Matrix<double, 3, 5> parent = Eigen::Matrix<double, 3, 5>::Zero();
    parent.leftCols<3>().setIdentity();
    parent(0, 3) = p.eta - mean_eta;
    parent(1, 4) = p.xi - mean_xi;
    const Eigen::Matrix<double, 3, 5> stress = to_axes * parent;
    h += p.area * stress.transpose() * compliance * stress;
    l += p.area * stress.transpose() * p.frame.strain * compatible_strains(p.xi, p.eta);
  }
  return l.transpose() * h.ldlt().solve(l);
}

}  // namespace

ShellAxes centre_axes(const ShellElement& element) {
  return axes_at(Modes<Vector3>(element.position), Modes<Eigen::Vector2d>(element.material), 0, 0);
}

ShellReference shell_reference(const ShellElement& element, const ShellSection& section, MembraneField field) {
  const Modes<Vector3> x(element.position);
  const Modes<Eigen::Vector2d> material(element.material);
  const ShellAxes centre = axes_at(x, material, 0, 0);
  std::array<IntegrationPoint, 4> points;
  double area = 0;
  for (std::size_t g = 0; g < 4; ++g) {
    const double xi = g % 2 == 0 ? -integration_point : integration_point;
    const double eta = g < 2 ? -integration_point : integration_point;
    const ShellAxes frame = axes_at(x, material, xi, eta);
    const double jacobian = frame.normal.dot(centre.normal.normalized());
    if (!(jacobian > 0)) throw std::invalid_argument("a quad is not convex: its corners fold over");
    points[g] = {xi, eta, frame, frame.normal.norm()};
    area += points[g].area;
  }

  ShellReference r;
  r.membrane.setZero();
  r.shear.setZero();
  for (std::size_t g = 0; g < 4; ++g) {
    const auto& p = points[g];
    r.frame[g] = p.frame.strain;
    r.area[g] = p.area;
    if (field == MembraneField::bilinear || field == MembraneField::edge_tied) {
      const Matrix3x6 strains = p.frame.strain * (field == MembraneField::bilinear ? compatible_strains(p.xi, p.eta)
                                                                                   : edge_tied_strains(p.xi, p.eta));
      r.membrane += p.area * strains.transpose() * section.membrane * strains;
    }
    Eigen::Matrix<double, 2, 4> tied;  // covariant shears from those of the edges η = −1, η = 1, ξ = −1, ξ = 1
    tied << 0.5 * (1 - p.eta), 0.5 * (1 + p.eta), 0, 0, 0, 0, 0.5 * (1 - p.xi), 0.5 * (1 + p.xi);
    const Eigen::Matrix<double, 2, 4> shears = p.frame.covariant.transpose() * tied;
    r.shear += p.area * section.shear * shears.transpose() * shears;
  }
  if (field == MembraneField::centre) r.membrane = centre_field(x, centre, element, section, area);
  if (field == MembraneField::mixed) r.membrane = mixed_field(points, centre, section, area);
  return r;
}

}  // namespace sundrape
