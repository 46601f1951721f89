#include "sundrape/force/shell.hpp"

#include <stdexcept>

#include "shell_batch.hpp"

namespace sundrape {

Shell::Shell(const std::vector<ShellElement>& elements, const ShellSection& section, const ShellOptions& options)
    : section_(section), options_(options) {
  if (!(options.director_length > 0)) throw std::invalid_argument("the length of directors must be positive [m]");
  if (!(section.membrane_damping >= 0 && section.bending_damping >= 0))
    throw std::invalid_argument("the relaxation times of a shell must not be negative [s]");
  auto sorted = elements;
  stripes_ = sort_into_stripes(sorted, [](const ShellElement& e) { return e.nodes; });
  std::vector<ElementTable<8, numbers>::Element> rows;
  rows.reserve(sorted.size());
  const Eigen::Matrix3d rigidity = section.bending.rigidity();
  for (const auto& e : sorted) {
    const auto reference = shell_reference(e, section, options.membrane);
    auto& row = rows.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) {
      row.points_of[k] = e.nodes[k];
      row.points_of[4 + k] = e.directors[k];
    }
    const auto put = [&](std::size_t number, const auto& matrix) {
      const auto n = static_cast<std::size_t>(matrix.rows());
      for (std::size_t k = 0; k < n; ++k)
        for (std::size_t l = k; l < n; ++l)
          row.numbers_of[number + triangle(k, l, n)] =
              matrix(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(l));
    };
    put(Number::membrane, reference.membrane);
    put(Number::shear, reference.shear);
    for (std::size_t g = 0; g < 4; ++g) {
      const Eigen::Matrix3d& to_axes = reference.frame[g];
      put(Number::bending + 6 * g, Eigen::Matrix3d(reference.area[g] * to_axes.transpose() * rigidity * to_axes));
      for (std::size_t i = 0; i < 9; ++i) row.numbers_of[Number::frame + 9 * g + i] = to_axes.data()[i];
      row.numbers_of[Number::area + g] = reference.area[g];
    }
    const double spans = e.spans ? 1 : 0;
    row.numbers_of[Number::spans] = spans;
    // strains at rest, by the same arithmetic as later on
    std::array<Batch3, 4> x, t;
    for (std::size_t k = 0; k < 4; ++k) {
      x[k] = e.position[k].cast<Batch>();
      t[k] = options.director_length * e.director[k].cast<Batch>();
    }
    const Modes rest = modes_of(x, t, options.director_length);
    const auto put_list = [&](std::size_t number, const auto& list) {
      for (std::size_t k = 0; k < list.size(); ++k) row.numbers_of[number + k] = list[k].get(0);
    };
    put_list(Number::membrane_rest, Membrane::values(rest));
    put_list(Number::shear_rest, TransverseShear::values(rest));
    put_list(Number::curvature_rest, Curvature(rest, options.curvature, Batch(spans)).values());
  }
  table_ = ElementTable<8, numbers>(rows);
}

double Shell::energy(const State& state) const {
  Energies e;
  add_energies(state, e);
  return e.stored();
}

void Shell::add_energies(const State& state, Energies& energies) const {
  const auto sum = [&](auto part) {
    return sum_over_batches(stripes_, [&](std::size_t e) -> Batch { return Element(*this, e, state).energy().*part; });
  };
  energies.membrane += sum(&Element::Energy::membrane);
  energies.shear += sum(&Element::Energy::shear);
  energies.bending += sum(&Element::Energy::bending);
}

void Shell::add_strain_energy(const State& state, VectorRef of_points) const {
  const auto total = [&](std::size_t e) -> Batch {
    const auto stored = Element(*this, e, state).energy();
    return stored.membrane + stored.shear + stored.bending;
  };
  share_among_points(stripes_, table_, 0, 3, total, of_points);
}

double Shell::dissipated_power(const State& state) const {
  if (section_.membrane_damping == 0 && section_.bending_damping == 0) return 0;
  return sum_over_batches(stripes_,
                          [&](std::size_t e) -> Batch { return Element(*this, e, state).dissipated_power(); });
}

void Shell::add_force(const State& state, VectorRef f) const {
  for_each_batch(stripes_, [&](std::size_t e, std::size_t count) {
    const auto nodal = nodal_forces(Element(*this, e, state).force(), options_.director_length);
    LaneBuffer<24> buffer;
    for (std::size_t p = 0; p < 8; ++p) buffer.store(3 * p, nodal[p]);
    scatter_add(buffer, table_, e, count, f);
  });
}

void Shell::add_tangent(const State& state, double dq, double dv, Assembler& tangent) const {
  const bool symmetric = !tangent.keeps_unsymmetric();
  for_each_batch(stripes_, [&](std::size_t e, std::size_t count) {
    const Element element(*this, e, state);
    Blocks h;
    if (symmetric) {
      element.stiffness<true>(dq, dv, h);
      add_symmetric_blocks(h, options_.director_length, e, count, tangent);
    } else {
      element.stiffness<false>(dq, dv, h);
      add_general_blocks(h, options_.director_length, e, count, tangent);
    }
  });
}

void Shell::declare_pattern(Pattern& pattern) const {
  pattern.begin_term(8);
  for (std::size_t e = 0; e < table_.size(); ++e) pattern.add_element(table_.points_of(e));
}

}  // namespace sundrape
