#include "sundrape/app/recorder.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sundrape/io/file_error.hpp"
#include "sundrape/io/result_layout.hpp"
#include "sundrape/io/result_reader.hpp"
#include "sundrape/mesh/crossings.hpp"
#include "sundrape/mesh/directors.hpp"
#include "sundrape/statics/relaxation.hpp"
#include "sundrape/version.hpp"

namespace sundrape {
namespace {

ResultHeader header_of(const Case& c, const CaseModel& model, std::vector<StepColumn> columns,
                       std::uint64_t expected_frames) {
  ResultHeader h;
  h.title = c.title;
  h.model = c.model == Model::shell ? "shell" : "particle";
  h.director = model.has_directors();
  h.element_fields = !model.gauges.empty() && c.output.resultants;
  h.analysis = to_string(c.analysis);
  h.frame_variable = c.analysis == Analysis::arc_length ? FrameVariable::load_factor : FrameVariable::time;
  h.case_text = c.text;
  h.inputs = c.inputs;
  h.version = version();
  h.mesh = model.mesh;
  h.expected_frames = expected_frames;
  for (const auto& set : model.reactions) h.reaction_sets.push_back(set.name);
  h.probes = model.probes;
  h.step_columns = std::move(columns);
  h.obstacles = model.obstacles;
  for (const auto& p : c.sensitivities) h.sensitivities.push_back({p.key, p.value, p.unit});
  h.rate_sensitivities = c.analysis == Analysis::dynamics;
  return h;
}

Vector as_vector(const std::vector<double>& values) {
  return Eigen::Map<const Vector>(values.data(), static_cast<Eigen::Index>(values.size()));
}
/// Of obstacles and of cloth on cloth together.
ContactReport contact_report(const CaseModel& model, const State& all) {
  ContactReport report;
  if (model.contact) report.include(model.contact->report(all));
  if (model.cloth_contact) report.include(model.cloth_contact->report(all));
  return report;
}

std::vector<double> as_list(ConstVectorRef v) { return {v.data(), v.data() + v.size()}; }

Recorder::Restart read_restart(const ResultReader& earlier, const std::filesystem::path& file, Eigen::Index size) {
  const auto checkpoint = earlier.checkpoint();
  if (!checkpoint) throw FileError(file.string() + ": holds no checkpoint to resume from");
  const auto& arrays = checkpoint->arrays;
  const auto get = [&](const char* name) -> const std::vector<double>& {
    const auto found = arrays.find(name);
    if (found == arrays.end()) throw FileError(file.string() + ": its checkpoint lacks '" + name + "'");
    return found->second;
  };
  const auto& books = get("books");
  const auto& extremes = get("extremes");
  const auto& times = get("run_seconds");
  Recorder::Restart r{.time = get("time").at(0),
                      .q = as_vector(get("q")),
                      .v = as_vector(get("v")),
                      .balance = {},
                      .initial_energy = books.at(2),
                      .step_size = books.at(3),
                      .totals = get("totals"),
                      .extremes = {},
                      .wall = times.at(0),
                      .cpu = times.at(1),
                      .schedule = {},
                      .sensitivities = {}};
  if (const auto found = arrays.find("schedule"); found != arrays.end()) r.schedule = found->second;
  if (const auto found = arrays.find("sensitivities"); found != arrays.end()) r.sensitivities = found->second;
  if (r.q.size() != size || r.v.size() != size)
    throw FileError(file.string() + ": its checkpoint belongs to another mesh");
  r.balance.dissipated = books.at(0);
  r.balance.external_work = books.at(1);
  r.extremes = {.largest_edge_strain = extremes.at(0),
                .smallest_edge_strain = extremes.at(1),
                .deepest_penetration = extremes.at(2),
                .sharpest_bend = extremes.at(3),
                .largest_membrane_strain = extremes.at(4)};
  return r;
}

ResultWriter open_writer(const ResultHeader& header, const Recorder::Files& files,
                         std::optional<Recorder::Restart>& restart, Eigen::Index size) {
  if (!files.resume) return {files.output, header};
  const ResultReader earlier(*files.resume);
  if (earlier.analysis() != header.analysis)
    throw FileError(fmt::format(R"({}: is the result of analysis = "{}", the case says "{}")", files.resume->string(),
                                earlier.analysis(), header.analysis));
  restart = read_restart(earlier, *files.resume, size);
  return ResultWriter::resume(files.output, header, earlier);
}

ElementFields fields_of(const ShellReadings& r) {
  const auto flat = [](const auto& rows) { return Vector(Eigen::Map<const Vector>(rows.data(), rows.size())); };
  return {.membrane_strain = flat(r.membrane_strain),
          .membrane_force = flat(r.membrane_force),
          .shear_strain = flat(r.shear_strain),
          .shear_force = flat(r.shear_force),
          .curvature = flat(r.curvature),
          .moment = flat(r.moment)};
}

/// What the summary says of the last frame, except its positions.
Frame last_frame(const ResultReader& result, const CaseModel& model) {
  Frame f;
  if (result.frames() == 0) return f;
  const auto last = result.frames() - 1;
  const auto energies = result.energies();
  const auto energy = [&](const char* name) { return energies.at(name).at(last); };
  f.variable = result.frame_values().at(last);
  f.contact_force = result.contact_force(last);
  f.energies = {.kinetic = energy("kinetic"),
                .membrane = energy("membrane"),
                .shear = energy("shear"),
                .bending = energy("bending"),
                .gravity = energy("gravity"),
                .contact = energy("contact"),
                .dissipated = energy("dissipated"),
                .external_work = energy("external_work"),
                .method_dissipated = energy("method_dissipated")};
  f.residual = result.residual().at(last);
  f.negative_pivots = static_cast<int>(result.negative_pivots().at(last));
  const auto reactions = result.reactions();
  const auto moments = result.reaction_moments();
  for (const auto& set : model.reactions) {
    f.reactions.push_back(reactions.at(layout::link_name(set.name)).at(last));
    f.moments.push_back(moments.at(layout::link_name(set.name)).at(last));
  }
  return f;
}

}  // namespace

Recorder::Recorder(const Case& c, const CaseModel& model, const Files& files, std::vector<StepColumn> columns,
                   std::uint64_t expected_frames, RunClock clock)
    : case_(c),
      model_(model),
      header_(header_of(c, model, std::move(columns), expected_frames)),
      clock_(clock),
      writer_(open_writer(header_, files, restart_, model.initial.size())),
      xdmf_(files.output, header_) {
  if (files.resume) {
    const ResultReader earlier(files.output);
    auto values = earlier.frame_values();
    if (header_.frame_variable == FrameVariable::load_factor) std::iota(values.begin(), values.end(), 0.0);
    xdmf_.set_frames(std::move(values));
    last_ = last_frame(earlier, model);
    warnings_ = earlier.warnings();
    extremes_ = restart_->extremes;
    clock_.carry_over(restart_->wall, restart_->cpu);
  }
}

void Recorder::frame(const State& all, const EnergyAudit::Balance& balance, std::optional<int> negative_pivots,
                     std::optional<double> residual, std::vector<FrameSensitivity> derivatives) {
  Frame f;
  f.variable = all.time;
  f.stage = all.stage;
  f.position = model_.of_nodes(all.q);
  f.velocity = model_.of_nodes(all.v);
  f.director = model_.directors_of(all.q);
  f.energy_density = model_.folded(model_.system->strain_energy(all)).cwiseQuotient(model_.node_area);
  const auto& e = balance.energies;
  f.energies = {.kinetic = e.kinetic,
                .membrane = e.membrane,
                .shear = e.shear,
                .bending = e.bending,
                .gravity = e.gravity,
                .contact = e.contact,
                .dissipated = balance.dissipated,
                .external_work = balance.external_work,
                .method_dissipated = balance.method_dissipated};
  f.residual = residual ? *residual : relative_residual(*model_.system, all, model_.force_scale());
  f.negative_pivots = negative_pivots.value_or(-1);
  f.crossings = std::ssize(crossings(model_.surface, all.q));
  if (f.crossings > 0 && !first_crossing_) first_crossing_ = all.time;
  if (model_.contact || model_.cloth_contact) {
    Vector contact_force = Vector::Zero(all.q.size());
    if (model_.contact) model_.contact->add_force(all, contact_force);
    if (model_.cloth_contact) model_.cloth_contact->add_force(all, contact_force);
    f.contact_force = model_.of_nodes(contact_force);
  }
  f.penetration = contact_report(model_, all).deepest_penetration;
  if (model_.contact) {
    const auto forces = model_.contact->total_forces(all);
    for (std::size_t k = 0; k < model_.obstacles.size(); ++k) {
      const auto& start = model_.obstacles[k];
      const auto carried = model_.contact->carried(k, all);
      f.obstacles.push_back({carried(start.position), carried.rotation * start.rotation, forces[k]});
    }
  }
  if (!model_.gauges.empty()) {
    const auto readings = read(model_.gauges, all.q);
    extremes_.largest_membrane_strain =
        std::max(extremes_.largest_membrane_strain, largest_principal_strain(readings.membrane_strain));
    if (header_.element_fields) f.elements = fields_of(readings);
  }
  for (const auto& set : model_.reactions) {
    const auto [force, moment] = reaction(model_, all, model_.nodes_of(set));
    f.reactions.push_back(force);
    f.moments.push_back(moment);
  }
  if (case_.analysis == Analysis::relaxation) extremes_ = {.deepest_penetration = f.penetration};
  const auto [smallest, largest] = model_.edge_strains.range(all.q);
  extremes_.largest_edge_strain = std::max(extremes_.largest_edge_strain, largest);
  extremes_.smallest_edge_strain = std::min(extremes_.smallest_edge_strain, smallest);
  if (model_.directors)
    extremes_.sharpest_bend = std::max(extremes_.sharpest_bend, sharpest_turn(model_.mesh, model_.directors_of(all.q)));
  for (const auto* bends : model_.bends)
    extremes_.sharpest_bend = std::max(extremes_.sharpest_bend, bends->largest_angle(all.q));
  f.sensitivities = std::move(derivatives);
  if (sensitivities_ != nullptr && case_.analysis != Analysis::dynamics && negative_pivots) {
    f.sensitivities = sensitivities_->at_equilibrium(all);
    if (f.sensitivities.empty())
      warn(fmt::format("sensitivities are not known where the tangent is singular, at {:.6g}", all.time));
  }
  writer_.append_frame(f);
  // load factors may fall, and begin anew with every stage: viewers get the number of the frame
  xdmf_.add_frame(header_.frame_variable == FrameVariable::time ? f.variable
                                                                : static_cast<double>(writer_.frames() - 1));
  last_ = std::move(f);
}

ContactReport Recorder::step(const State& all) {
  if (!model_.probes.empty()) writer_.append_probes(all.time, all.q, all.v);
  const auto report = contact_report(model_, all);
  if (case_.analysis != Analysis::relaxation)
    extremes_.deepest_penetration = std::max(extremes_.deepest_penetration, report.deepest_penetration);
  return report;
}

void Recorder::checkpoint(const State& all, const EnergyAudit::Balance& balance, double initial_energy,
                          double step_size, const std::vector<double>& totals, const std::vector<double>& schedule,
                          const std::vector<double>& sensitivities) {
  const auto& e = extremes_;
  Checkpoint c;
  c.arrays = {{"time", {all.time}},
              {"q", as_list(all.q)},
              {"v", as_list(all.v)},
              {"books", {balance.dissipated, balance.external_work, initial_energy, step_size}},
              {"totals", totals},
              {"extremes",
               {e.largest_edge_strain, e.smallest_edge_strain, e.deepest_penetration, e.sharpest_bend,
                e.largest_membrane_strain}},
              {"run_seconds", {clock_.wall(), clock_.cpu()}}};
  if (!schedule.empty()) c.arrays["schedule"] = schedule;
  if (!sensitivities.empty()) c.arrays["sensitivities"] = sensitivities;
  writer_.write_checkpoint(c);
}

void Recorder::warn(const std::string& text) {
  if (std::ranges::find(warnings_, text) != warnings_.end()) return;
  warnings_.push_back(text);
  writer_.add_warning(text);
}

void Recorder::statistic(const std::string& name, StatisticValue value, const std::string& description) {
  writer_.set_statistic(name, value, description);
  statistics_.push_back({name, std::move(value), description});
}

nlohmann::json Recorder::summary(const std::string& status, const std::string& message) const {
  nlohmann::json j{{"title", case_.title},
                   {"model", header_.model},
                   {"analysis", header_.analysis},
                   {"status", status},
                   {"sundrape_version", header_.version}};
  if (!message.empty()) j["message"] = message;
  j["mesh"] = {{"nodes", model_.mesh.nodes()}, {"quads", model_.mesh.quads.size()}};
  j["frames"] = writer_.frames();
  const auto& e = last_.energies;
  j["final"] = {{"variable", last_.variable},
                {"residual", last_.residual},
                {"negative_pivots", last_.negative_pivots},
                {"energy_J",
                 {{"kinetic", e.kinetic},
                  {"membrane", e.membrane},
                  {"shear", e.shear},
                  {"bending", e.bending},
                  {"gravity", e.gravity},
                  {"contact", e.contact},
                  {"dissipated", e.dissipated},
                  {"external_work", e.external_work},
                  {"method_dissipated", e.method_dissipated}}}};
  if (last_.contact_force.size() > 0) {
    Vector3 sum = Vector3::Zero();
    for (int i = 0; i < model_.mesh.nodes(); ++i) sum += point(last_.contact_force, i);
    j["final"]["contact_force_sum_N"] = {sum.x(), sum.y(), sum.z()};
  }
  const auto list = [](const Vector3& v) { return std::array{v.x(), v.y(), v.z()}; };
  for (std::size_t k = 0; k < last_.reactions.size(); ++k) {
    j["final"]["reaction_N"][model_.reactions[k].name] = list(last_.reactions[k]);
    j["final"]["reaction_moment_Nm"][model_.reactions[k].name] = list(last_.moments[k]);
  }
  j["weight_N"] = model_.weight;
  for (const auto& s : statistics_) std::visit([&](const auto& value) { j[s.name] = value; }, s.value);
  j["warnings"] = warnings_;
  return j;
}

void Recorder::finish(ResultStatus status, const std::string& message) {
  writer_.finish(status, message);
  xdmf_.write();
}

}  // namespace sundrape
