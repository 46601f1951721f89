#include "sundrape/io/result_writer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "sundrape/io/growing_file.hpp"
#include "sundrape/io/mesh_difference.hpp"
#include "sundrape/io/result_layout.hpp"
#include "sundrape/io/result_reader.hpp"

#include "checkpoint_slots.hpp"
#include "result_rest.hpp"

namespace sundrape {

using layout::SeriesIndex;

class ResultWriter::Implementation {
 public:
  Implementation(const std::filesystem::path& path, ResultHeader header, const ResultReader* earlier)
      : rest_(start(std::move(header), earlier)),
        file_(
            path, layout::series(rest_.header), [this](hdf5::File& file) { rest_.write(file); }, source(earlier)) {}

  ResultRest& rest() { return rest_; }
  GrowingFile& file() { return file_; }
  [[nodiscard]] const ResultHeader& header() const { return rest_.header; }

  void write_checkpoint(const Checkpoint& checkpoint) {
    checkpoint_slots::Numbered next{.checkpoint = checkpoint, .sequence = 1};
    next.checkpoint.frames = file_.rows(SeriesIndex::frames);
    next.checkpoint.steps = file_.rows(SeriesIndex::steps);
    next.checkpoint.probe_rows = file_.rows(SeriesIndex::probes);
    next.checkpoint.warnings = file_.rows(SeriesIndex::warnings);
    next.checkpoint.iterations = file_.rows(SeriesIndex::iterations);
    next.checkpoint.critical_points = file_.rows(SeriesIndex::critical);
    file_.commit();  // what the checkpoint counts must be there before it
    if (rest_.checkpoint) next.sequence = rest_.checkpoint->sequence + 1;
    const bool in_place = rest_.checkpoint && checkpoint_slots::overwrite_older(file_.file(), next, *rest_.checkpoint);
    rest_.checkpoint = std::move(next);
    if (!in_place) file_.rewrite();
  }

 private:
  static ResultRest start(ResultHeader header, const ResultReader* earlier) {
    for (const auto& probe : header.probes)
      if (probe.node < 0 || probe.node >= header.mesh.nodes())
        throw std::invalid_argument(fmt::format("probe {}: the mesh has no node {}", probe.name, probe.node));
    ResultRest rest{.header = std::move(header)};
    if (earlier != nullptr) rest.checkpoint = checkpoint_slots::read_newest(earlier->file());
    return rest;
  }

  [[nodiscard]] GrowingFile::Source source(const ResultReader* earlier) const {
    if (earlier == nullptr) return {};
    if (!rest_.checkpoint)
      throw FileError(fmt::format("{}: holds no checkpoint to go on from", earlier->file().name()));
    const auto& checkpoint = rest_.checkpoint->checkpoint;
    GrowingFile::Source source{.file = &earlier->file(), .rows = std::vector<std::uint64_t>(SeriesIndex::count)};
    source.rows[SeriesIndex::warnings] = checkpoint.warnings;
    source.rows[SeriesIndex::steps] = checkpoint.steps;
    source.rows[SeriesIndex::probes] = checkpoint.probe_rows;
    source.rows[SeriesIndex::frames] = checkpoint.frames;
    source.rows[SeriesIndex::iterations] = checkpoint.iterations;
    source.rows[SeriesIndex::critical] = checkpoint.critical_points;
    return source;
  }

  ResultRest rest_;
  GrowingFile file_;
};

ResultWriter::ResultWriter(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
ResultWriter::ResultWriter(ResultWriter&&) noexcept = default;
ResultWriter& ResultWriter::operator=(ResultWriter&&) noexcept = default;
ResultWriter::~ResultWriter() = default;

ResultWriter::ResultWriter(const std::filesystem::path& path, ResultHeader header)
    : implementation_(std::make_unique<Implementation>(path, std::move(header), nullptr)) {}

ResultWriter ResultWriter::resume(const std::filesystem::path& path, ResultHeader header, const ResultReader& earlier) {
  if (const auto difference = mesh_difference(header.mesh, earlier.mesh()); !difference.empty())
    throw FileError(fmt::format("{}: cannot go on from it: {}", earlier.file().name(), difference));
  return ResultWriter(std::make_unique<Implementation>(path, std::move(header), &earlier));
}

std::uint64_t ResultWriter::frames() const { return implementation_->file().rows(SeriesIndex::frames); }

void ResultWriter::append_step(std::initializer_list<StepValue> values) {
  const auto& columns = implementation_->header().step_columns;
  for (const auto& [name, value] : values)
    if (std::ranges::find(columns, name, &StepColumn::name) == columns.end())
      throw std::invalid_argument(fmt::format("this result has no step column {}", name));
  auto& file = implementation_->file();
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto* const given = std::ranges::find(values, columns[c].name, &StepValue::first);
    const bool missing = given == values.end();
    if (columns[c].integer) {
      file.append(SeriesIndex::steps, c, missing ? std::int64_t{0} : std::llround(given->second));
    } else {
      const double value = missing ? std::numeric_limits<double>::quiet_NaN() : given->second;
      file.append(SeriesIndex::steps, c, std::span(&value, 1));
    }
  }
}

void ResultWriter::append_probes(double time, ConstVectorRef positions, ConstVectorRef velocities) {
  const auto& probes = implementation_->header().probes;
  auto& file = implementation_->file();
  for (std::size_t p = 0; p < probes.size(); ++p) {
    const Vector3 position = point(positions, probes[p].node);
    const Vector3 velocity = point(velocities, probes[p].node);
    file.append(SeriesIndex::probes, 3 * p, std::span(&time, 1));
    file.append(SeriesIndex::probes, 3 * p + 1, std::span(position.data(), 3));
    file.append(SeriesIndex::probes, 3 * p + 2, std::span(velocity.data(), 3));
  }
}

namespace {

void require_size(const Vector& values, Eigen::Index size, std::string_view what) {
  if (values.size() != size)
    throw std::invalid_argument(
        fmt::format("a frame's {} has {} entries, the mesh needs {}", what, values.size(), size));
}

std::span<const double> entries(const Vector& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

}  // namespace

void ResultWriter::append_frame(const Frame& frame) {
  const auto& header = implementation_->header();
  const Eigen::Index size = 3 * header.mesh.nodes();
  require_size(frame.position, size, "position");
  require_size(frame.velocity, size, "velocity");
  if (frame.contact_force.size() != 0) require_size(frame.contact_force, size, "contact force");
  if (header.director) require_size(frame.director, size, "director");
  if (frame.energy_density.size() != 0) require_size(frame.energy_density, header.mesh.nodes(), "energy density");
  const auto fields = layout::element_values(frame.elements);
  if (header.element_fields)
    for (std::size_t k = 0; k < fields.size(); ++k) {
      const auto& [name, components] = layout::element_fields()[k];
      require_size(*fields[k], components * std::ssize(header.mesh.quads), name);
    }
  for (const auto* const sets : {&frame.reactions, &frame.moments})
    if (sets->size() != header.reaction_sets.size())
      throw std::invalid_argument(
          fmt::format("a frame has {} reactions, the result has {} sets", sets->size(), header.reaction_sets.size()));

  if (!frame.obstacles.empty() && frame.obstacles.size() != header.obstacles.size())
    throw std::invalid_argument(
        fmt::format("a frame has {} obstacles, the result has {}", frame.obstacles.size(), header.obstacles.size()));

  if (!frame.sensitivities.empty() && frame.sensitivities.size() != header.sensitivities.size())
    throw std::invalid_argument(fmt::format("a frame has derivatives by {} parameters, the result by {}",
                                            frame.sensitivities.size(), header.sensitivities.size()));
  for (const auto& by : frame.sensitivities) {
    require_size(by.position, size, "derivative of positions");
    if (header.rate_sensitivities) require_size(by.velocity, size, "derivative of velocities");
  }

  auto& file = implementation_->file();
  std::size_t column = 0;  // in the order of layout::series
  const auto add = [&](std::span<const double> values) { file.append(SeriesIndex::frames, column++, values); };
  const Vector contact = frame.contact_force.size() != 0 ? frame.contact_force : Vector::Zero(size);
  const Vector3 contact_sum = contact.reshaped(3, header.mesh.nodes()).rowwise().sum();
  add(std::span(&frame.variable, 1));
  if (header.frame_variable == FrameVariable::load_factor)
    file.append(SeriesIndex::frames, column++, std::int64_t{frame.stage});
  add(entries(frame.position));
  add(entries(frame.velocity));
  add(entries(contact));
  if (header.director) add(entries(frame.director));
  add(entries(frame.energy_density.size() != 0 ? frame.energy_density : Vector::Zero(header.mesh.nodes())));
  if (header.element_fields)
    for (const auto* const field : fields) add(entries(*field));
  for (const double energy : layout::energy_values(frame.energies)) add(std::span(&energy, 1));
  add(std::span(&frame.residual, 1));
  file.append(SeriesIndex::frames, column++, std::int64_t{frame.negative_pivots});
  add(std::span(&frame.penetration, 1));
  file.append(SeriesIndex::frames, column++, frame.crossings);
  add(std::span(contact_sum.data(), 3));
  for (const auto& reaction : frame.reactions) add(std::span(reaction.data(), 3));
  for (const auto& moment : frame.moments) add(std::span(moment.data(), 3));
  for (std::size_t k = 0; k < header.obstacles.size(); ++k) {
    const auto& record = header.obstacles[k];
    const auto pose = frame.obstacles.empty() ? ObstaclePose{record.position, record.rotation} : frame.obstacles[k];
    add(std::span(pose.force.data(), 3));
    if (!record.moves) continue;
    const Matrix3 rows = pose.rotation.transpose();  // Eigen stores columns, readers expect rows
    add(std::span(pose.position.data(), 3));
    add(std::span(rows.data(), 9));
  }
  const Vector unknown = Vector::Constant(size, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < header.sensitivities.size(); ++k) {
    const auto& by = frame.sensitivities.empty() ? FrameSensitivity{unknown, unknown} : frame.sensitivities[k];
    add(entries(by.position));
    if (header.rate_sensitivities) add(entries(by.velocity));
    for (const auto& probe : header.probes)
      add(entries(by.position).subspan(3 * static_cast<std::size_t>(probe.node), 3));
  }
  file.commit();
}

void ResultWriter::append_iteration(const PathIteration& i) {
  auto& file = implementation_->file();
  file.append(SeriesIndex::iterations, 0, std::int64_t{i.step});
  file.append(SeriesIndex::iterations, 1, std::int64_t{i.iteration});
  file.append(SeriesIndex::iterations, 2, std::span(&i.load_factor, 1));
  file.append(SeriesIndex::iterations, 3, std::span(&i.residual, 1));
}

void ResultWriter::append_critical_point(const CriticalRecord& c) {
  const Eigen::Index size = 3 * implementation_->header().mesh.nodes();
  require_size(c.position, size, "position at a critical point");
  require_size(c.mode, size, "critical mode");
  auto& file = implementation_->file();
  std::size_t column = 0;
  file.append(SeriesIndex::critical, column++, std::span(&c.load_factor, 1));
  file.append(SeriesIndex::critical, column++, std::span(&c.uncertainty, 1));
  for (const int number : {c.stage, c.limit_point ? 1 : 0, c.pivots_before, c.pivots_after})
    file.append(SeriesIndex::critical, column++, std::int64_t{number});
  file.append(SeriesIndex::critical, column++, entries(c.position));
  file.append(SeriesIndex::critical, column++, entries(c.mode));
}

void ResultWriter::add_warning(const std::string& text) {
  implementation_->file().append(SeriesIndex::warnings, 0, text);
}

void ResultWriter::set_statistic(const std::string& name, StatisticValue value, const std::string& description) {
  auto& statistics = implementation_->rest().statistics;
  const auto found = std::ranges::find(statistics, name, &Statistic::name);
  if (found != statistics.end())
    *found = {name, std::move(value), description};
  else
    statistics.push_back({name, std::move(value), description});
}

void ResultWriter::write_checkpoint(const Checkpoint& checkpoint) { implementation_->write_checkpoint(checkpoint); }

void ResultWriter::finish(ResultStatus status, const std::string& message, int deflate) {
  auto& rest = implementation_->rest();
  auto& file = implementation_->file();
  rest.status = status;
  rest.message = message;
  rest.finished = true;
  try {
    file.compact(deflate);
  } catch (const FileError&) {  // no space for a second file: the one there is takes the status, and what it can hold
    rest.write_status(file.file());
    file.commit();
    file.file().close();
  }
}

}  // namespace sundrape
