#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "sundrape/force/contact_law.hpp"
#include "sundrape/force/contact_points.hpp"
#include "sundrape/force/contact_report.hpp"
#include "sundrape/force/force_term.hpp"
#include "sundrape/force/friction_law.hpp"
#include "sundrape/force/obstacle.hpp"
#include "sundrape/force/path_course.hpp"

namespace sundrape {

/// An obstacle, how rough it is and where it moves.
struct ContactBody {
  std::shared_ptr<const Obstacle> obstacle = {};  // where it stands at the start
  double friction = 0;                            // μ
  std::optional<PathCourse> course = {};          // from there
};

/// What of an obstacle is nearest to a point.
struct ClosestSurface {
  double gap;        // [m]; infinite without obstacles
  Vector3 normal;    // out of the obstacle; zero without obstacles
  std::size_t body;  // which obstacle
};

/// Contact of a sheet's points with rigid obstacles, by penalty, and Coulomb's friction on them.
///
/// Every point carries the pressure of the contact law on its area: with gap g, normal n = ∇g and curvature
/// H = ∇∇g,  W = A ∫p dd,  f = A p n,  ∂f/∂x = A (−p' n nᵀ + p H); nodes share them by the point's weights. Against the
/// velocity v of the point along the surface, which may move itself, friction acts with −μ A p (φ(|v|)/|v|) v; statics,
/// where nothing has a velocity, do not see it.
///
/// Newton's iteration on friction's true tangent jumps from sliding one way to sliding the other way. What goes into
/// the matrix unless asked otherwise is the secant φ/|v|, at least as large: the iteration then converges from
/// everywhere (docs/friction.md). Only solvers for unsymmetric matrices get ∂f/∂x of friction.
///
/// Shapes: N nodes, so q and forces have 3N entries; each contact point is an element of up to four points.
class ObstacleContact final : public ForceTerm {
 public:
  /// @throws std::invalid_argument  a negative area or coefficient of friction, or an empty pointer
  ObstacleContact(std::vector<ContactBody> bodies, std::vector<ContactPoint> points, ContactLaw law,
                  FrictionLaw friction = FrictionLaw(1e-4), FrictionMatrix matrix = FrictionMatrix::secant);

  [[nodiscard]] std::string_view name() const override { return "obstacle contact"; }
  [[nodiscard]] EnergyKind kind() const override { return EnergyKind::contact; }
  [[nodiscard]] double energy(const State& state) const override;
  [[nodiscard]] double dissipated_power(const State& state) const override;
  [[nodiscard]] double external_power(const State& state) const override;  // of obstacles that move
  void add_force(const State& state, VectorRef force) const override;
  void add_tangent(const State& state, double dq, double dv, Assembler& tangent) const override;
  void declare_pattern(Pattern& pattern) const override;

  [[nodiscard]] const ContactLaw& law() const { return law_; }
  [[nodiscard]] const FrictionLaw& friction_law() const { return friction_law_; }
  [[nodiscard]] bool has_friction() const { return largest_friction() > 0; }
  [[nodiscard]] double largest_friction() const;  // μ
  [[nodiscard]] ContactReport report(const State& state) const;
  /// On the cloth, with friction, one an obstacle [N].
  [[nodiscard]] std::vector<Vector3> total_forces(const State& state) const;
  /// The surface with the smallest gap over all obstacles, where these are at the state's time.
  [[nodiscard]] ClosestSurface closest(const State& when, const Vector3& x) const;
  [[nodiscard]] std::size_t bodies() const { return bodies_.size(); }
  [[nodiscard]] bool moves(std::size_t body) const { return bodies_[body].course.has_value(); }
  /// How far an obstacle has been carried from where it stood at the start.
  [[nodiscard]] RigidPlacement carried(std::size_t body, const State& when) const;

 private:
  /// One pair within reach of each other.
  struct Pair {
    std::size_t point, body;
    Distance distance;
    Vector3 normal;    // of unit length
    Vector3 position;  // of the point [m]
    double push;       // A p [N]
    RigidRate motion;  // of the body
  };

  template <class Visit>
  void visit_pairs(const State& state, Visit&& visit) const;
  /// Velocity of a pair's point as seen from the body [m/s], and of that what is along the body's surface.
  [[nodiscard]] Vector3 relative(const Pair& pair, const State& state) const;
  [[nodiscard]] Vector3 sliding(const Pair& pair, const State& state) const;
  [[nodiscard]] Vector3 friction(const Pair& pair, const State& state) const;
  [[nodiscard]] Matrix3 friction_tangent(const Pair& pair, const State& state, double dq, double dv, bool whole) const;

  std::vector<ContactBody> bodies_;
  std::vector<Eigen::AlignedBox3d> reach_;  // of each body at the start; outside of it there is no force
  std::vector<ContactPoint> points_;
  ContactLaw law_;
  FrictionLaw friction_law_;
  FrictionMatrix friction_matrix_;
};

}  // namespace sundrape
