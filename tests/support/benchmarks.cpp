#include "support/benchmarks.hpp"

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sundrape/app/solver_choice.hpp"
#include "sundrape/integrate/dynamics.hpp"
#include "sundrape/io/case_reader.hpp"

namespace sundrape {
namespace {

class Frames final : public DynamicsObserver {
 public:
  explicit Frames(Motion& motion) : motion_(motion) {}
  void frame(const State& all, const EnergyAudit::Balance& balance) override {
    motion_.time.push_back(all.time);
    motion_.position.emplace_back(all.q);
    motion_.velocity.emplace_back(all.v);
    motion_.energy.push_back(balance.energies.total());
    motion_.kinetic.push_back(balance.energies.kinetic);
  }
  void step(const State&, const StepReport&, const Integrator&) override {}
  [[nodiscard]] bool wants_to_stop() override { return false; }

 private:
  Motion& motion_;
};

}  // namespace

Benchmark benchmark(const std::string& case_name, const std::vector<std::string>& sets) {
  Case c = read_case(std::filesystem::path(SUNDRAPE_SOURCE_DIR) / "cases" / case_name, sets);
  CaseModel model = build_model(c);
  return {std::move(c), std::move(model)};
}

std::string cells_along(int n) { return fmt::format("cloth.cells=[{},1]", n); }

Equilibrium equilibrium(const Benchmark& b, double tolerance) {
  return equilibrium_from(b.model.initial, b, tolerance);
}

Equilibrium equilibrium_from(const Vector& start, const Benchmark& b, double tolerance) {
  Equilibrium e{start, {}};
  UnseenRelaxation unseen;
  const auto solver = statics_solver(b.c, *b.model.system);
  auto options = relaxation_options(b.c, b.model);
  options.tolerance = tolerance;
  e.result = relax(*b.model.system, *solver, options, e.q, unseen);
  EXPECT_EQ(e.result.end, RelaxationEnd::converged) << e.result.diagnosis;
  return e;
}

std::unique_ptr<Integrator> integrator_of(const Benchmark& b) {
  const auto& system = *b.model.system;
  const auto options = integrator_options(b.c, b.model);
  if (b.c.dynamics.integrator == IntegratorKind::rk4) return make_rk4(system, options);
  auto solver = dynamics_solver(b.c);
  if (b.c.dynamics.integrator == IntegratorKind::ida) return make_ida(system, std::move(solver), options);
  if (b.c.dynamics.integrator == IntegratorKind::dirk) return make_dirk(system, std::move(solver), options);
  return make_cvode(system, std::move(solver), options);
}

Motion motion(const Benchmark& b) {
  const auto integrator = integrator_of(b);
  return motion(*b.model.system, *integrator, b.c.output.frame_times, b.model.initial,
                Vector::Zero(b.model.initial.size()));
}

Motion motion(const System& system, Integrator& integrator, const std::vector<double>& frame_times, ConstVectorRef q,
              ConstVectorRef v) {
  Motion motion;
  Frames frames(motion);
  Dynamics dynamics(system, integrator, frame_times, frames);
  (void)dynamics.run(0, q, v, true);
  motion.statistics = integrator.statistics();
  return motion;
}

std::vector<std::vector<int>> columns(const QuadMesh& strip) {
  const double resolution = 1e-9 * diagonal(strip);
  std::map<long, std::vector<int>> by_place;
  for (int i = 0; i < strip.nodes(); ++i)
    by_place[std::lround(strip.material[static_cast<std::size_t>(i)].x() / resolution)].push_back(i);
  std::vector<std::vector<int>> columns;
  columns.reserve(by_place.size());
  for (auto& [place, nodes] : by_place) columns.push_back(std::move(nodes));
  return columns;
}

std::vector<Vector3> centre_line(const QuadMesh& strip, const Vector& all) {
  std::vector<Vector3> line;
  for (const auto& column : columns(strip)) {
    Vector3 sum = Vector3::Zero();
    for (const int i : column) sum += point(all, i);
    line.emplace_back(sum / static_cast<double>(column.size()));
  }
  return line;
}

std::vector<double> edge_angles(const std::vector<Vector3>& line) {
  std::vector<double> angles;
  double before = 0;
  for (std::size_t k = 1; k < line.size(); ++k) {
    const Vector3 edge = line[k] - line[k - 1];
    before += std::remainder(std::atan2(edge.z(), edge.x()) - before, 2 * std::numbers::pi);
    angles.push_back(before);
  }
  return angles;
}

double tip_rotation(const std::vector<Vector3>& line, double tip_curvature) {
  const auto angles = edge_angles(line);
  const double last = angles.back(), turn = last - angles[angles.size() - 2];
  const double length = (line.back() - line[line.size() - 2]).norm();
  return last + (turn + 3 * length * tip_curvature) / 8;
}

std::vector<double> director_angles(const CaseModel& model, const Vector& all) {
  std::vector<double> angles;
  double before = 0;
  for (const auto& column : columns(model.mesh)) {
    Vector3 sum = Vector3::Zero();
    for (const int i : column) sum += point(all, model.mesh.nodes() + i);
    before += std::remainder(std::atan2(-sum.x(), sum.z()) - before, 2 * std::numbers::pi);
    angles.push_back(before);
  }
  return angles;
}

double observed_order(double coarse_error, double fine_error, double refinement) {
  return std::log(coarse_error / fine_error) / std::log(refinement);
}

std::map<std::string, std::vector<double>> reference_table(const std::string& name) {
  std::ifstream in(std::filesystem::path(SUNDRAPE_SOURCE_DIR) / "tests" / "reference" / name);
  EXPECT_TRUE(in) << name;
  std::map<std::string, std::vector<double>> table;
  std::vector<std::string> header;
  for (std::string line; std::getline(in, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    std::istringstream cells(line);
    std::size_t k = 0;
    const bool names = header.empty();
    for (std::string cell; std::getline(cells, cell, ','); ++k) {
      if (names)
        header.push_back(cell);
      else
        table[header.at(k)].push_back(std::stod(cell));
    }
  }
  return table;
}

namespace {

std::vector<std::pair<double, Tip>> tips(const std::string& file, const std::string& load,
                                         const std::string& rotation) {
  const auto table = reference_table(file);
  std::vector<std::pair<double, Tip>> rows;
  for (std::size_t k = 1; k < table.at(load).size(); ++k)
    rows.emplace_back(table.at(load)[k],
                      Tip{table.at("ux/L (shortening)")[k], table.at("uy/L")[k], table.at(rotation)[k]});
  return rows;
}

}  // namespace

std::vector<std::pair<double, Tip>> elastica_of_tip_force() {
  return tips("elastica_tip_force.csv", "lambda", "tip rotation rad");
}

std::vector<std::pair<double, Tip>> arcs_of_tip_moment() {
  return tips("elastica_tip_moment.csv", "lambda_M", "rotation rad");
}

}  // namespace sundrape
