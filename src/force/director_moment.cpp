#include "sundrape/force/director_moment.hpp"

#include <array>

#include "couple.hpp"

namespace sundrape {

DirectorMoment::DirectorMoment(std::vector<LoadedDirector> directors, LoadCourse course)
    : directors_(std::move(directors)), course_(std::move(course)) {}

double DirectorMoment::external_power(const State& state) const {
  double power = 0;
  for (const auto& l : directors_) power += couple(l.moment, point(state.q, l.point)).dot(point(state.v, l.point));
  return course_.share(state) * power;
}

void DirectorMoment::add_force(const State& state, VectorRef f) const {
  const double share = course_.share(state);
  for (const auto& l : directors_) point(f, l.point) += share * couple(l.moment, point(state.q, l.point));
}

void DirectorMoment::add_tangent(const State& state, double dq, double /*dv*/, Assembler& tangent) const {
  const double share = dq * course_.share(state);
  for (std::size_t k = 0; k < directors_.size(); ++k)
    tangent.add_diagonal(k, 0, couple_by_arm(share * directors_[k].moment, point(state.q, directors_[k].point)));
}

void DirectorMoment::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(1);
  for (const auto& l : directors_) pattern.add_element(std::array{l.point});
}

}  // namespace sundrape
