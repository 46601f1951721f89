#include "swept_clearance.hpp"

#include <algorithm>

namespace sundrape {

std::optional<Meeting> first_contact(Shapes shapes, const std::array<Vector3, 4>& from,
                                     const std::array<Vector3, 4>& to, double clearance) {
  constexpr double advance = 0.9;  // of the way that is known to be free
  constexpr int most_advances = 10000;
  const std::size_t points = points_of(shapes), first = shapes == Shapes::edge_edge ? 2 : 1;
  std::array<Vector3, 4> way{Vector3::Zero(), Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
  Vector3 mean = Vector3::Zero();
  for (std::size_t k = 0; k < points; ++k) {
    way[k] = to[k] - from[k];
    mean += way[k] / static_cast<double>(points);
  }
  double most_first = 0, most_second = 0;  // how far the points of either shape go, but for what all go
  for (std::size_t k = 0; k < points; ++k) {
    auto& most = k < first ? most_first : most_second;
    most = std::max(most, (way[k] - mean).norm());
  }
  const double most = most_first + most_second;

  double share = 0;
  auto at = from;
  for (int i = 0; i < most_advances; ++i) {
    const auto now = separation(shapes, at);
    if ((1 - share) * most < now.distance - clearance) return std::nullopt;
    if (i > 0 && now.distance <= clearance) return Meeting{share, now.weights};
    // what starts nearer than the clearance must get away from there
    const double free =
        i > 0 ? now.distance - 0.5 * clearance : std::max(now.distance - 0.5 * clearance, 0.5 * now.distance);
    share += advance * free / most;
    if (share >= 1) share = 1;
    for (std::size_t k = 0; k < points; ++k) at[k] = from[k] + share * way[k];
    if (share == 1) {
      const auto end = separation(shapes, at);
      if (end.distance <= clearance) return Meeting{1, end.weights};
      return std::nullopt;
    }
  }
  return Meeting{share, separation(shapes, at).weights};
}

}  // namespace sundrape
