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

Unknowns::Unknowns(const std::vector<Held>& held, const std::vector<int>& order) : row_of_point_(held.size(), -1) {
  auto sorted = order;
  std::ranges::sort(sorted);
  if (sorted != ascending(held.size())) throw std::invalid_argument("an order of points has every point once");
  holders_.reserve(held.size());
  for (const auto& h : held) holders_.push_back({h[0], h[1], h[2]});
  for (const int p : order) {
    if (is_held(p)) continue;
    row_of_point_[static_cast<std::size_t>(p)] = static_cast<int>(point_of_row_.size());
    point_of_row_.push_back(p);
  }
  list_held_components();
}

void Unknowns::list_held_components() {
  held_components_.clear();
  for (int r = 0; r < rows(); ++r)
    for (int c = 0; c < 3; ++c)
      if (is_held(point_of_row_[static_cast<std::size_t>(r)], c)) held_components_.push_back({r, c});
}

void Unknowns::hold(int point, int component) {
  if (row_of_point_.at(static_cast<std::size_t>(point)) < 0)
    throw std::invalid_argument("a point that is held for good takes no other support");
  ++holders_[static_cast<std::size_t>(point)].at(static_cast<std::size_t>(component));
  list_held_components();
}

void Unknowns::let_go(int point, int component) {
  auto& holders = holders_.at(static_cast<std::size_t>(point)).at(static_cast<std::size_t>(component));
  if (holders == 0 || row_of_point_[static_cast<std::size_t>(point)] < 0)
    throw std::invalid_argument("a point that no support can let go of");
  --holders;
  list_held_components();
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

double Unknowns::held_dot(ConstVectorRef a, ConstVectorRef b) const {
  double sum = 0;
  for (int p = 0; p < points(); ++p)
    for (int c = 0; c < 3; ++c)
      if (is_held(p, c)) sum += a[3 * p + c] * b[3 * p + c];
  return sum;
}

}  // namespace sundrape
