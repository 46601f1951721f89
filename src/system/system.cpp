#include "sundrape/system/system.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

namespace sundrape {

System::System(Vector mass, std::vector<std::unique_ptr<ForceTerm>> terms, Unknowns unknowns, Vector rest,
               std::vector<PrescribedMotion> motions)
    : mass_(std::move(mass)),
      terms_(std::move(terms)),
      unknowns_(std::move(unknowns)),
      rest_(std::move(rest)),
      motions_(std::move(motions), unknowns_.points()) {
  if (mass_.size() != unknowns_.points() || rest_.size() != 3 * mass_.size())
    throw std::invalid_argument("masses, supports and coordinates differ in their number of points");
  if (!(mass_.minCoeff() >= 0)) throw std::invalid_argument("a point has a negative mass [kg]");
  row_mass_.resize(unknowns_.rows());
  for (int r = 0; r < unknowns_.rows(); ++r)
    row_mass_[r] = mass_[unknowns_.point_of_row()[static_cast<std::size_t>(r)]];
  declare();
}

void System::declare() const {
  Pattern pattern(unknowns_.row_of_point());
  for (const auto& term : terms_) term->declare_pattern(pattern);
  auto built = pattern.build();
  structure_ = std::move(built.structure);
  tables_ = std::move(built.tables);
  ++structures_;
}

long System::adapt(const State& all) const {
  bool as_before = true;
  for (const auto& term : terms_) as_before = term->adapt(all) && as_before;
  if (!as_before) declare();
  return structures_;
}

bool System::watches_passages() const {
  return std::ranges::any_of(terms_, [](const auto& term) { return term->watches_passages(); });
}

std::optional<Passage> System::passage(const State& from, const State& to) const {
  for (const auto& term : terms_)
    if (auto found = term->passage(from, to)) return found;
  return std::nullopt;
}

bool System::settles(const State& before, const State& after) const {
  return std::ranges::all_of(terms_, [&](const auto& term) { return term->settles(before, after); });
}

void System::take_hold(std::size_t motion, const std::vector<int>& points, const std::vector<int>& directors,
                       const State& all) {
  if (motions_.carries(motion)) throw std::logic_error("a gripper that is closed cannot take hold");
  std::vector<int> taken, turned;
  const auto with_row = [&](int p) { return unknowns_.row_of_point()[static_cast<std::size_t>(p)] >= 0; };
  std::ranges::copy_if(points, std::back_inserter(taken), with_row);
  std::ranges::copy_if(directors, std::back_inserter(turned), with_row);
  for (const int p : taken)
    for (int c = 0; c < 3; ++c)
      if (motions_[motion].components[static_cast<std::size_t>(c)]) unknowns_.hold(p, c);
  for (const int p : turned)
    for (int c = 0; c < 3; ++c) unknowns_.hold(p, c);
  motions_.carry_instead(motion, std::move(taken), std::move(turned), all.time, all.q, rest_);
}

void System::let_go(std::size_t motion, const State& all) {
  const auto& before = motions_[motion];
  for (const int p : before.points)
    for (int c = 0; c < 3; ++c)
      if (before.components[static_cast<std::size_t>(c)]) unknowns_.let_go(p, c);
  for (const int p : before.directions)
    for (int c = 0; c < 3; ++c) unknowns_.let_go(p, c);
  motions_.carry_instead(motion, {}, {}, all.time, all.q, rest_);
}

void System::go_on_from(const State& all) { motions_.rest_from(all.time, all.q, rest_); }

void System::expand(double time, ConstVectorRef rows_q, ConstVectorRef rows_v, VectorRef q, VectorRef v) const {
  q = rest_;
  v.setZero();
  unknowns_.scatter(rows_q, q);
  unknowns_.scatter(rows_v, v);
  if (!motions_.empty()) motions_.place(time, rest_, q, v);
}

bool System::has_symmetric_tangent() const {
  return std::ranges::all_of(terms_, [](const auto& term) { return term->has_symmetric_tangent(); });
}

void System::force(const State& all, VectorRef f) const {
  f.setZero();
  for (const auto& term : terms_) term->add_force(all, f);
}

void System::add_tangent(const State& all, double dq, double dv, BlockMatrix& matrix) const {
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    Assembler assembler(matrix, tables_[k]);
    terms_[k]->add_tangent(all, dq, dv, assembler);
  }
}

void System::hold(BlockMatrix& matrix) const {
  for (const auto& [row, component] : unknowns_.held_components()) {
    const double size = matrix.lower(structure_.diagonal(row)).diagonal().cwiseAbs().maxCoeff();
    matrix.hold(row, component, size > 0 ? size : 1.0);
  }
}

void System::hold(BlockMatrix& matrix, double value) const {
  for (const auto& [row, component] : unknowns_.held_components()) matrix.hold(row, component, value);
}

Vector System::strain_energy(const State& all) const {
  Vector of_points = Vector::Zero(mass_.size());
  for (const auto& term : terms_) term->add_strain_energy(all, of_points);
  return of_points;
}

Energies System::energies(const State& all) const {
  Energies e;
  e.kinetic = kinetic_energy(all);
  for (const auto& term : terms_) term->add_energies(all, e);
  return e;
}

double System::kinetic_energy(const State& all) const {
  double kinetic = 0;
  for (int i = 0; i < mass_.size(); ++i) kinetic += 0.5 * mass_[i] * point(all.v, i).squaredNorm();
  return kinetic;
}

double System::held_kinetic_energy(const State& all) const {
  double kinetic = 0;
  for (int i = 0; i < mass_.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (unknowns_.is_held(i, k)) kinetic += 0.5 * mass_[i] * all.v[3 * i + k] * all.v[3 * i + k];
  return kinetic;
}

double System::support_power(const State& all) const {
  Vector f(all.q.size());
  force(all, f);
  return -unknowns_.held_dot(f, all.v);
}

double System::dissipated_power(const State& all) const {
  double power = 0;
  for (const auto& term : terms_) power += term->dissipated_power(all);
  return power;
}

double System::external_power(const State& all) const {
  double power = 0;
  for (const auto& term : terms_) power += term->external_power(all);
  return power;
}

double System::external_force_norm(const State& all) const {
  Vector still = Vector::Zero(all.v.size()), f = Vector::Zero(all.q.size()), rows(unknowns_.size());
  for (const auto& term : terms_)
    if (term->is_external()) term->add_force({all.time, all.q, still, all.stage}, f);
  unknowns_.gather(f, rows);
  unknowns_.clear_held(rows);
  return rows.norm();
}

}  // namespace sundrape
