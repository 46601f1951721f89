#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sundrape {

/// The elements of a force term by columns, so that consecutive ones fill SIMD registers.
template <std::size_t points, std::size_t numbers>
class ElementTable {
 public:
  struct Element {
    std::array<int, points> points_of;
    std::array<double, numbers> numbers_of;
  };

  ElementTable() = default;
  explicit ElementTable(std::span<const Element> elements) : size_(elements.size()) {
    for (std::size_t p = 0; p < points; ++p)
      for (const auto& e : elements) start_[p].push_back(3 * std::int64_t{e.points_of[p]});
    for (std::size_t k = 0; k < numbers; ++k)
      for (const auto& e : elements) number_[k].push_back(e.numbers_of[k]);
    if (elements.empty()) return;
    for (auto& column : start_) column.resize(size_ + widest, column.back());
    for (auto& column : number_) column.resize(size_ + widest, column.back());
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] int point_of(std::size_t p, std::size_t e) const { return static_cast<int>(start_[p][e] / 3); }
  [[nodiscard]] std::array<int, points> points_of(std::size_t e) const {
    std::array<int, points> of{};
    for (std::size_t p = 0; p < points; ++p) of[p] = point_of(p, e);
    return of;
  }
  [[nodiscard]] double number_of(std::size_t k, std::size_t e) const { return number_[k][e]; }

  // Columns from element e on. A whole register may be read from any element on: copies of the last follow it.
  /// Where in a vector of all points the 3-vector of point p starts.
  [[nodiscard]] const std::int64_t* starts(std::size_t p, std::size_t e) const { return &start_[p][e]; }
  [[nodiscard]] const double* column(std::size_t k, std::size_t e) const { return &number_[k][e]; }

 private:
  static constexpr std::size_t widest = 8;  // doubles in a register

  std::array<std::vector<std::int64_t>, points> start_;
  std::array<std::vector<double>, numbers> number_;
  std::size_t size_ = 0;
};

}  // namespace sundrape
