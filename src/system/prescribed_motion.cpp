#include "sundrape/system/prescribed_motion.hpp"

#include <ranges>

namespace sundrape {

PrescribedMotions::PrescribedMotions(std::vector<PrescribedMotion> motions, int points)
    : motions_(std::move(motions)), points_(points) {
  list_carried();
}

void PrescribedMotions::list_carried() {
  carried_.clear();
  std::vector<std::size_t> entry(static_cast<std::size_t>(points_), carried_.max_size());
  const auto add = [&](int point, bool direction, std::size_t motion) {
    auto& at = entry.at(static_cast<std::size_t>(point));
    if (at == carried_.max_size()) {
      at = carried_.size();
      carried_.push_back({point, direction, {}});
    }
    carried_[at].motions.push_back(motion);
  };
  for (std::size_t m = 0; m < motions_.size(); ++m) {
    for (const int p : motions_[m].points) add(p, false, m);
    for (const int p : motions_[m].directions) add(p, true, m);
  }
}

void PrescribedMotions::carry_instead(std::size_t motion, std::vector<int> points, std::vector<int> directions,
                                      double time, ConstVectorRef q, VectorRef rest) {
  auto& changed = motions_.at(motion);
  std::vector<bool> moves_on(static_cast<std::size_t>(points_), false);
  const auto mark = [&] {
    for (const auto& list : {changed.points, changed.directions})
      for (const int p : list) moves_on.at(static_cast<std::size_t>(p)) = true;
  };
  mark();
  changed.points = std::move(points);
  changed.directions = std::move(directions);
  mark();
  list_carried();
  rest_from(time, q, rest, moves_on);
}

void PrescribedMotions::rest_from(double time, ConstVectorRef q, VectorRef rest) const {
  rest_from(time, q, rest, std::vector<bool>(static_cast<std::size_t>(points_), true));
}

void PrescribedMotions::rest_from(double time, ConstVectorRef q, VectorRef rest, const std::vector<bool>& which) const {
  const Vector nothing;
  const State now{time, nothing, nothing};
  for (const auto& carried : carried_) {
    if (!which[static_cast<std::size_t>(carried.point)]) continue;
    Vector3 x = point(q, carried.point);
    for (const auto m : std::views::reverse(carried.motions)) {
      const auto placement = motions_[m].course.placement(now);
      const Vector3 before = carried.direction ? Vector3(placement.rotation.transpose() * x) : placement.inverse(x);
      // next to others a motion answers for its own components alone
      const bool whole = carried.direction || carried.motions.size() == 1;
      for (std::size_t c = 0; c < 3; ++c)
        if (whole || motions_[m].components[c]) x[static_cast<int>(c)] = before[static_cast<int>(c)];
    }
    point(rest, carried.point) = x;
  }
}

template <class Visit>
void PrescribedMotions::visit(double time, int stage, ConstVectorRef rest, Visit&& visit) const {
  const Vector nothing;
  const State state{time, nothing, nothing, stage};
  std::vector<RigidPlacement> placements;
  std::vector<RigidRate> rates;
  for (const auto& motion : motions_) {
    placements.push_back(motion.course.placement(state));
    rates.push_back(motion.course.rate(state));
  }
  constexpr std::array all{true, true, true};
  for (const auto& carried : carried_) {
    Vector3 x = point(rest, carried.point), rate = Vector3::Zero();
    for (const auto m : carried.motions) {
      const auto& turn = placements[m].rotation;
      x = carried.direction ? Vector3(turn * x) : placements[m](x);
      rate = turn * rate + (carried.direction ? Vector3(rates[m].spin.cross(x)) : rates[m](x));
      const auto& components = carried.direction ? all : motions_[m].components;
      for (int c = 0; c < 3; ++c)
        if (components[static_cast<std::size_t>(c)]) visit(3 * carried.point + c, x[c], rate[c]);
    }
  }
}

void PrescribedMotions::place(double time, int stage, ConstVectorRef rest, VectorRef q) const {
  visit(time, stage, rest, [&](int entry, double x, double /*rate*/) { q[entry] = x; });
}

void PrescribedMotions::place(double time, ConstVectorRef rest, VectorRef q, VectorRef v) const {
  visit(time, 0, rest, [&](int entry, double x, double rate) {
    q[entry] = x;
    v[entry] = rate;
  });
}

Vector PrescribedMotions::acceleration(double time, ConstVectorRef rest) const {
  constexpr double step = 1e-6;  // [s]
  Vector before = Vector::Zero(rest.size()), after = before;
  visit(time - step, 0, rest, [&](int entry, double /*x*/, double rate) { before[entry] = rate; });
  visit(time + step, 0, rest, [&](int entry, double /*x*/, double rate) { after[entry] = rate; });
  return (after - before) / (2 * step);
}

}  // namespace sundrape
