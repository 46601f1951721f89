#include <iterator>

#include <fmt/format.h>

#include "sundrape/export/writers.hpp"
#include "sundrape/io/result_layout.hpp"

#include "output_file.hpp"

namespace sundrape {
namespace {

/// A table with named columns, all of the same length.
class Table {
 public:
  void add(const std::string& name, const std::string& units, std::vector<double> values) {
    header_ += fmt::format("{}{}", header_.empty() ? "" : ",", quoted(fmt::format("{} [{}]", name, units)));
    columns_.push_back(std::move(values));
  }
  void add(const std::string& name, const std::string& units, const std::vector<Vector3>& values) {
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<double> component;
      component.reserve(values.size());
      for (const auto& v : values) component.push_back(v[static_cast<Eigen::Index>(i)]);
      add(fmt::format("{}.{}", name, "xyz"[i]), units, std::move(component));
    }
  }
  /// Only the rows of some frames.
  [[nodiscard]] std::string text(const std::vector<std::size_t>& rows) const {
    auto text = header_ + "\n";
    for (const auto row : rows)
      for (std::size_t c = 0; c < columns_.size(); ++c)
        fmt::format_to(std::back_inserter(text), "{}{}", columns_[c].at(row), c + 1 < columns_.size() ? ',' : '\n');
    return text;
  }
  [[nodiscard]] std::size_t rows() const { return columns_.empty() ? 0 : columns_.front().size(); }
  [[nodiscard]] bool empty() const { return columns_.empty(); }

 private:
  /// RFC 4180: names of sets may have commas.
  static std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? "\"\"" : std::string(1, c);
    return result + "\"";
  }

  std::string header_;
  std::vector<std::vector<double>> columns_;
};

std::vector<std::size_t> all_rows(std::size_t rows) {
  std::vector<std::size_t> all(rows);
  for (std::size_t k = 0; k < rows; ++k) all[k] = k;
  return all;
}

std::string variable_name(const ResultReader& result) {
  return result.frame_variable() == FrameVariable::time ? "time" : "load_factor";
}

std::string variable_units(const ResultReader& result) {
  return result.frame_variable() == FrameVariable::time ? "s" : "1";
}

Table frame_table(const ResultReader& result) {
  Table table;
  table.add(variable_name(result), variable_units(result), result.frame_values());
  const auto energies = result.energies();
  for (const auto& name : layout::energy_names())
    if (const auto found = energies.find(name); found != energies.end())
      table.add("energy." + name, "J", found->second);
  table.add("residual", "1", result.residual());
  table.add("penetration", "m", result.penetration());
  table.add("contact_force_sum", "N", result.contact_force_sum());
  for (const auto& [set, forces] : result.reactions()) table.add("reaction." + set, "N", forces);
  for (const auto& [set, moments] : result.reaction_moments()) table.add("reaction_moment." + set, "N m", moments);
  std::map<std::string, std::vector<Vector3>> paths;
  const auto probes = result.probes();
  for (std::size_t frame = 0; frame < result.frames(); ++frame) {
    const auto position = result.position(frame);
    for (const auto& [name, probe] : probes)
      if (probe.node >= 0) paths[name].emplace_back(point(position, probe.node));
  }
  for (const auto& [name, path] : paths) table.add("probe." + name, "m", path);
  return table;
}

Table step_table(const ResultReader& result) {
  Table table;
  for (auto& [name, values] : result.step_columns())
    table.add(name, std::string(layout::meaning("/steps/" + name).units), values);
  return table;
}

Table probe_table(const ResultReader& result) {
  Table table;
  for (const auto& [name, probe] : result.probes()) {
    if (table.empty()) table.add(variable_name(result), variable_units(result), probe.time);
    table.add("probe." + name, "m", probe.position);
    table.add("probe." + name + ".velocity", "m/s", probe.velocity);
  }
  return table;
}

void write(const std::filesystem::path& path, const std::string& text) {
  OutputFile output(path);
  output.write(text);
  output.commit();
}

}  // namespace

WrittenFiles write_csv(const ExportScene& scene, const std::filesystem::path& file) {
  const auto& result = scene.result();
  write(file, frame_table(result).text(scene.frame_numbers()));
  WrittenFiles written{file};
  for (const auto& [name, table] : {std::pair{"-steps", step_table(result)}, {"-probes", probe_table(result)}}) {
    if (table.rows() == 0) continue;
    auto beside = file;
    beside.replace_filename(file.stem().string() + name + file.extension().string());
    write(beside, table.text(all_rows(table.rows())));
    written.push_back(beside);
  }
  return written;
}

}  // namespace sundrape
