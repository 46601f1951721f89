#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "sundrape/force/contact_law.hpp"
#include "sundrape/force/contact_points.hpp"
#include "sundrape/force/force_term.hpp"
#include "sundrape/force/obstacle.hpp"

namespace sundrape {

/// How the cloth stands to its obstacles at one instant.
struct ContactReport {
  int contacts = 0;                   // pairs of a contact point and an obstacle that press on each other
  double deepest_penetration = 0;     // max(0, −gap) over all of them [m]
  std::vector<Vector3> total_forces;  // on the cloth, one an obstacle [N]
};

/// Frictionless contact of a sheet's points with rigid obstacles, by penalty.
///
/// Every point carries the pressure of the contact law on its area: with gap g, normal n = ∇g and curvature
/// H = ∇∇g,  W = A ∫p dd,  f = A p n,  ∂f/∂x = A (−p' n nᵀ + p H); nodes share them by the point's weights.
///
/// Shapes: N nodes, so q and forces have 3N entries; each contact point is an element of up to four points.
class ObstacleContact final : public ForceTerm {
 public:
  /// @throws std::invalid_argument  a negative area, or an empty pointer
  ObstacleContact(std::vector<std::shared_ptr<const Obstacle>> obstacles, std::vector<ContactPoint> points,
                  ContactLaw law);

  [[nodiscard]] std::string_view name() const override { return "obstacle contact"; }
  [[nodiscard]] EnergyKind kind() const override { return EnergyKind::contact; }
  [[nodiscard]] double energy(const State& state) const override;
  void add_force(const State& state, VectorRef force) const override;
  void add_tangent(const State& state, double dq, double dv, Assembler& tangent) const override;
  void declare_pattern(Pattern& pattern) const override;

  [[nodiscard]] const ContactLaw& law() const { return law_; }
  [[nodiscard]] ContactReport report(const State& state) const;
  /// The smallest gap over all obstacles [m] and the normal there; an infinite gap and no normal without obstacles.
  [[nodiscard]] std::pair<double, Vector3> closest(const Vector3& x) const;

 private:
  struct Body {
    std::shared_ptr<const Obstacle> obstacle;
    Eigen::AlignedBox3d reach;  // outside of it there is no force
  };

  /// Calls visit(contact point, obstacle number, distance) for every pair within reach of each other.
  template <class Visit>
  void visit_pairs(const State& state, Visit&& visit) const;

  std::vector<Body> bodies_;
  std::vector<ContactPoint> points_;
  ContactLaw law_;
};

}  // namespace sundrape
