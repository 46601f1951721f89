#include "sundrape/system/unknowns.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace sundrape {
namespace {

std::vector<int> ascending(std::size_t points) {
  std::vector<int> order(points);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

}  // namespace

Unknowns::Unknowns(const std::vector<Held>& held) : Unknowns(held, ascending(held.size())) {}

Unknowns::Unknowns(std::vector<Held> held, const std::vector<int>& order)
    : held_(std::move(held)), row_of_point_(held_.size(), -1) {
  auto sorted = order;
  std::ranges::sort(sorted);
  if (sorted != ascending(held_.size())) throw std::invalid_argument("an order of points has every point once");
  for (const int p : order) {
    const auto& h = held_[static_cast<std::size_t>(p)];
    if (h[0] && h[1] && h[2]) continue;
    const int row = static_cast<int>(point_of_row_.size());
    row_of_point_[static_cast<std::size_t>(p)] = row;
    point_of_row_.push_back(p);
    for (int c = 0; c < 3; ++c)
      if (h[static_cast<std::size_t>(c)]) held_components_.push_back({row, c});
  }
}

void Unknowns::gather(ConstVectorRef all, VectorRef rows) const {
  for (int r = 0; r < this->rows(); ++r) point(rows, r) = point(all, point_of_row_[static_cast<std::size_t>(r)]);
}

void Unknowns::scatter(ConstVectorRef rows, VectorRef all) const {
  for (int r = 0; r < this->rows(); ++r) point(all, point_of_row_[static_cast<std::size_t>(r)]) = point(rows, r);
}

void Unknowns::clear_held(VectorRef rows) const {
  for (const auto& [row, component] : held_components_) rows[3 * row + component] = 0;
}

}  // namespace sundrape
