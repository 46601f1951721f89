#include "sundrape/mesh/interpolation.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sundrape/mesh/quad_locator.hpp"
#include "sundrape/mesh/threads.hpp"

namespace sundrape {
namespace {

constexpr int most_corrections = 30;  // of a place on a curved thread; each takes most of what is left

/// Weights of the nodes that a value is made of. A node may stand there more than once.
class Blend {
 public:
  void add(int node, double weight) { entries_.emplace_back(node, weight); }
  void add(double factor, const Blend& other) {
    for (const auto& [node, weight] : other.entries_) entries_.emplace_back(node, factor * weight);
  }
  /// Each node once, ascending, those that count for nothing left out.
  [[nodiscard]] std::vector<std::pair<int, double>> merged() && {
    std::ranges::sort(entries_, {}, &std::pair<int, double>::first);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < entries_.size();) {
      auto [node, sum] = entries_[k];
      for (++k; k < entries_.size() && entries_[k].first == node; ++k) sum += entries_[k].second;
      if (std::abs(sum) > 1e-12) entries_[kept++] = {node, sum};
    }
    entries_.resize(kept);
    return std::move(entries_);
  }

 private:
  std::vector<std::pair<int, double>> entries_;
};

class SmoothSheet {
 public:
  explicit SmoothSheet(const QuadMesh& mesh) : mesh_(mesh), threads_(find_threads(mesh)) {}

  /// Coons patch: both pairs of opposite edges, each blended linearly, less what the corners then count twice.
  [[nodiscard]] Blend at(const QuadLocator::Place& place) const {
    const auto& n = mesh_.quads[static_cast<std::size_t>(place.quad)];
    const double x = place.at.x(), y = place.at.y();
    Blend blend;
    blend.add(1 - y, along(n[0], n[1], x));
    blend.add(y, along(n[3], n[2], x));
    blend.add(1 - x, along(n[0], n[3], y));
    blend.add(x, along(n[1], n[2], y));
    blend.add(n[0], -(1 - x) * (1 - y));
    blend.add(n[1], -x * (1 - y));
    blend.add(n[2], -x * y);
    blend.add(n[3], -(1 - x) * y);
    return blend;
  }

 private:
  /// Hermite's cubic on the edge from i to j, s in [0, 1].
  [[nodiscard]] Blend along(int i, int j, double s) const {
    const int before = through(i, j), after = through(j, i);
    Blend at_i = before < 0 ? Blend() : slope(before, i, j), at_j;
    if (after >= 0) at_j.add(-1, slope(after, j, i));
    const auto parabola =
        [&](const Blend& other) {  // no thread beyond this end: the edge's second derivative is constant
          Blend end;
          end.add(j, 2);
          end.add(i, -2);
          end.add(-1, other);
          return end;
        };
    Blend straight;
    straight.add(j, 1);
    straight.add(i, -1);
    if (before < 0 && after < 0)
      at_i = at_j = straight;
    else if (before < 0)
      at_i = parabola(at_j);
    else if (after < 0)
      at_j = parabola(at_i);
    Blend blend;
    blend.add(i, (1 + 2 * s) * (1 - s) * (1 - s));
    blend.add(j, s * s * (3 - 2 * s));
    blend.add(s * (1 - s) * (1 - s), at_i);
    blend.add(s * s * (s - 1), at_j);
    return blend;
  }
  /// Slope at i of the parabola through three nodes of a thread, times the length of its edge to `on`.
  [[nodiscard]] Blend slope(int back, int i, int on) const {
    const double behind = length(back, i), ahead = length(i, on), whole = behind + ahead;
    Blend blend;
    blend.add(on, behind / whole);
    blend.add(i, ahead * ahead / (behind * whole) - behind / whole);
    blend.add(back, -ahead * ahead / (behind * whole));
    return blend;
  }
  /// The node where the thread that comes from j goes on behind i, −1 where it ends.
  [[nodiscard]] int through(int i, int j) const {
    for (const auto& end : threads_.ends_at(i))
      if (end.neighbour == j) return end.through;
    return -1;
  }
  [[nodiscard]] double length(int i, int j) const {
    return (mesh_.material[static_cast<std::size_t>(j)] - mesh_.material[static_cast<std::size_t>(i)]).norm();
  }

  const QuadMesh& mesh_;
  Threads threads_;
};

}  // namespace

SheetInterpolation::SheetInterpolation(const QuadMesh& from, const QuadMesh& to) : from_nodes_(from.nodes()) {
  const SmoothSheet sheet(from);
  const QuadLocator locator(from);
  const double close = 1e-13 * diagonal(from);
  start_.push_back(0);
  for (const auto& x : to.material) {
    // Where threads are curved the smooth sheet is not at x where the quads are: look a little beside.
    Eigen::Vector2d sought = x;
    std::vector<std::pair<int, double>> parts;
    for (int correction = 0; correction < most_corrections; ++correction) {
      const auto place = locator.find(sought);
      if (!place) throw std::invalid_argument("a node of the finer mesh does not lie on the coarser one");
      parts = sheet.at(*place).merged();
      Eigen::Vector2d off = x;
      for (const auto& [node, weight] : parts) off -= weight * from.material[static_cast<std::size_t>(node)];
      if (off.norm() <= close) break;
      sought += off;
    }
    for (const auto& [node, weight] : parts) {
      node_.push_back(node);
      weight_.push_back(weight);
    }
    start_.push_back(node_.size());
  }
}

Vector SheetInterpolation::carry(ConstVectorRef field) const {
  if (field.size() != 3 * Eigen::Index{from_nodes_})
    throw std::invalid_argument("a field to interpolate needs three values a node");
  Vector carried = Vector::Zero(3 * static_cast<Eigen::Index>(start_.size() - 1));
  for (std::size_t i = 0; i + 1 < start_.size(); ++i)
    for (auto k = start_[i]; k < start_[i + 1]; ++k)
      carried.segment<3>(3 * static_cast<Eigen::Index>(i)) += weight_[k] * field.segment<3>(3 * Eigen::Index{node_[k]});
  return carried;
}

}  // namespace sundrape
