#include "sundrape/app/fit_measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "sundrape/app/model.hpp"
#include "sundrape/io/case_error.hpp"
#include "sundrape/io/case_reader.hpp"
#include "sundrape/mesh/edges.hpp"

#include "overload.hpp"
#include "pick.hpp"

namespace sundrape {
namespace {

using Vector2 = Eigen::Vector2d;

/// One number that was measured: how far it is from where the run has it, and where that comes from.
struct Reading {
  double difference = 0;  // measured less computed [m]
  double deviation = 1;   // [m]
  struct Part {
    int entry = 0;      // of positions, 3N
    double weight = 0;  // d(computed)/d(position)
  };
  std::vector<Part> parts;
};

/// A point's distance from the nearest of some segments, seen in a plane; positive on the left of the segment.
Reading distance(const MeasuredCurve& curve, const MeasuredCurve::Point& measured,
                 const std::vector<std::array<int, 2>>& segments, const Vector& q) {
  const Vector2 m(measured.first, measured.second);
  const auto seen = [&](int node) { return Vector2(q[3 * node + curve.first_axis], q[3 * node + curve.second_axis]); };
  Reading reading;
  reading.deviation = measured.deviation;
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [i, j] : segments) {
    const Vector2 a = seen(i), along = seen(j) - a;
    const double part = std::clamp((m - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const Vector2 away = m - (a + part * along);
    const double length = away.norm();
    if (!(length < nearest)) continue;
    nearest = length;
    const Vector2 left = Vector2(-along.y(), along.x()).normalized();
    const double side = left.dot(away) < 0 ? -1 : 1;
    const Vector2 direction = length > 1e-12 ? Vector2(side * away / length) : left;
    reading.difference = side * length;
    reading.parts.clear();
    for (const auto& [node, share] : {std::pair(i, 1 - part), std::pair(j, part)}) {
      reading.parts.push_back({3 * node + curve.first_axis, share * direction.x()});
      reading.parts.push_back({3 * node + curve.second_axis, share * direction.y()});
    }
  }
  return reading;
}

Reading height(const MeasuredHeight& measured, const Vector& q) {
  int highest = 2;
  for (int entry = 2; entry < q.size(); entry += 3)
    if (q[entry] > q[highest]) highest = entry;
  return {measured.value - q[highest], measured.deviation, {{highest, 1}}};
}

std::size_t frame_at(const ResultReader& result, const std::optional<double>& time) {
  const auto& times = result.frame_values();
  if (times.empty()) throw FileError(fmt::format("{}: has no frames", result.file().name()));
  if (!time) return times.size() - 1;
  const auto nearest = std::ranges::min_element(times, {}, [&](double t) { return std::abs(t - *time); });
  if (std::abs(*nearest - *time) > 1e-9 * std::max(1.0, times.back()))
    throw FileError(fmt::format("{}: has no frame at {:.10g} s", result.file().name(), *time));
  return static_cast<std::size_t>(nearest - times.begin());
}

}  // namespace

FitMeasures::FitMeasures(const Fit& fit) : fit_(fit) {
  const Case c = read_case(fit.case_file, fit.sets);
  const auto model = build_model(c);
  std::vector<Vector3> start;
  for (int n = 0; n < model.mesh.nodes(); ++n) start.emplace_back(point(model.initial, n));
  for (const auto& m : fit.measured) {
    auto& segments = segments_.emplace_back();
    const auto* curve = std::get_if<MeasuredCurve>(&m.what);
    if (curve == nullptr) continue;
    std::vector<bool> chosen(start.size(), !curve->nodes);
    if (curve->nodes)
      for (const int n : pick(*curve->nodes, model.mesh, start, m.source)) chosen[static_cast<std::size_t>(n)] = true;
    for (const auto& edge : edge_table(model.mesh).edges)
      if (chosen[static_cast<std::size_t>(edge.i)] && chosen[static_cast<std::size_t>(edge.j)] &&
          (curve->nodes || edge.boundary()))
        segments.push_back({edge.i, edge.j});
    if (segments.empty()) throw CaseError(m.source, "no edge of the mesh has both its ends among these nodes");
  }
}

LeastSquaresPoint FitMeasures::compare(const ResultReader& result) const {
  const auto count = static_cast<Eigen::Index>(fit_.numbers()), parameters = std::ssize(fit_.parameters);
  LeastSquaresPoint point{Vector(count), Eigen::MatrixXd(count, parameters)};
  Eigen::Index row = 0;
  for (std::size_t k = 0; k < fit_.measured.size(); ++k) {
    const auto& measured = fit_.measured[k];
    const auto frame = frame_at(result, measured.time);
    const Vector q = result.position(frame);
    std::vector<Vector> derivatives;
    for (const auto& p : fit_.parameters) {
      derivatives.push_back(result.position_sensitivity(p.parameter.key, frame));
      if (!derivatives.back().allFinite())
        throw FileError(fmt::format("{}: holds no derivatives of the frame at {:.6g}: the tangent is singular there",
                                    result.file().name(), result.frame_values()[frame]));
    }
    const auto add = [&](const Reading& reading) {
      point.residuals[row] = reading.difference / reading.deviation;
      for (Eigen::Index p = 0; p < parameters; ++p) {
        double change = 0;
        for (const auto& part : reading.parts)
          change += part.weight * derivatives[static_cast<std::size_t>(p)][part.entry];
        point.jacobian(row, p) = -change / reading.deviation;
      }
      ++row;
    };
    std::visit(Overload{[&](const MeasuredCurve& curve) {
                          for (const auto& each : curve.points) add(distance(curve, each, segments_[k], q));
                        },
                        [&](const MeasuredProbe& probe) {
                          const int node = result.probes().at(probe.name).node;
                          for (const auto& [axis, value] : probe.coordinates)
                            add({value - q[3 * node + axis], probe.deviation, {{3 * node + axis, 1}}});
                        },
                        [&](const MeasuredHeight& each) { add(height(each, q)); }},
               measured.what);
  }
  return point;
}

}  // namespace sundrape
