#include "sundrape/system/unknowns.hpp"

namespace sundrape {

Unknowns::Unknowns(std::vector<Held> held) : held_(std::move(held)), row_of_point_(held_.size(), -1) {
  for (std::size_t p = 0; p < held_.size(); ++p) {
    const auto& h = held_[p];
    if (h[0] && h[1] && h[2]) continue;
    const int row = static_cast<int>(point_of_row_.size());
    row_of_point_[p] = row;
    point_of_row_.push_back(static_cast<int>(p));
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
