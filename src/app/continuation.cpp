#include "sundrape/app/continuation.hpp"

#include <algorithm>
#include <ranges>

#include <fmt/format.h>

#include "sundrape/app/solver_choice.hpp"
#include "sundrape/mesh/interpolation.hpp"

namespace sundrape {
namespace {

constexpr double tolerance_on_the_way = 1e-3;  // on the residual of coarser meshes

class Watch final : public RelaxationObserver {
 public:
  Watch(const QuadMesh& mesh, const std::function<void(const QuadMesh&, const RelaxationStep&)>& observe,
        const std::function<bool()>& wants_to_stop)
      : mesh_(mesh), observe_(observe), wants_to_stop_(wants_to_stop) {}
  void step(const State& /*all*/, const RelaxationStep& step) override {
    time_ = step.time;
    observe_(mesh_, step);
  }
  [[nodiscard]] bool wants_to_stop() override { return wants_to_stop_(); }
  [[nodiscard]] double time() const { return time_; }

 private:
  const QuadMesh& mesh_;
  const std::function<void(const QuadMesh&, const RelaxationStep&)>& observe_;
  const std::function<bool()>& wants_to_stop_;
  double time_ = 0;
};

}  // namespace

Vector carried(const CaseModel& from, ConstVectorRef q, const CaseModel& to) {
  const SheetInterpolation interpolation(from.mesh, to.mesh);
  Vector all = to.initial;
  const auto size = 3 * Eigen::Index{to.mesh.nodes()};
  all.head(size) = interpolation.carry(from.of_nodes(q));
  if (to.has_directors()) {
    all.tail(size) = interpolation.carry(from.directors_of(q));
    for (int i = to.mesh.nodes(); i < 2 * to.mesh.nodes(); ++i)
      point(all, i) = to.director_length * Vector3(point(all, i)).normalized();
  }
  const auto& unknowns = to.system->unknowns();
  for (int i = 0; i < unknowns.points(); ++i)
    for (int k = 0; k < 3; ++k)
      if (unknowns.is_held(i, k)) all[3 * i + k] = to.initial[3 * i + k];
  return all;
}

RelaxationOptions continued_options(const Case& c, const CaseModel& model) {
  auto options = relaxation_options(c, model);
  options.largest_rise /= 50;
  return options;
}

CoarseStart start_on_coarser_meshes(const Case& c, const CaseModel& model, const std::vector<CoarserCase>& coarser,
                                    const std::function<void(const QuadMesh&, const RelaxationStep&)>& observe,
                                    const std::function<bool()>& wants_to_stop) {
  CoarseStart start;
  start.step_size = relaxation_options(c, model).first_step;
  const CoarserCase* before = nullptr;
  for (const auto& level : std::views::reverse(coarser)) {
    auto options = before ? continued_options(level.c, level.model) : relaxation_options(level.c, level.model);
    options.tolerance = std::max(options.tolerance, tolerance_on_the_way);
    Vector q = before ? carried(before->model, start.q, level.model) : level.model.initial;
    const auto solver = statics_solver(level.c, *level.model.system);
    Watch watch(level.model.mesh, observe, wants_to_stop);
    const auto result = relax(*level.model.system, *solver, options, q, watch);
    ++start.meshes;
    start.iterations += result.iterations;
    start.factorizations += result.factorizations;
    start.time += watch.time();
    start.q = std::move(q);
    before = &level;
    start.stopped = result.end == RelaxationEnd::stopped;
    if (result.end == RelaxationEnd::stalled)
      start.problem = fmt::format("on {} nodes {}", level.model.mesh.nodes(), result.diagnosis);
    if (result.end != RelaxationEnd::converged) break;
  }
  if (before) start.q = carried(before->model, start.q, model);
  return start;
}

}  // namespace sundrape
