#include "sundrape/io/growing_file.hpp"

#include <algorithm>
#include <cstring>
#include <ranges>

#include <fmt/format.h>

#include "sundrape/io/replace_file.hpp"

namespace sundrape {
namespace {

constexpr std::uint64_t largest_chunk = (std::uint64_t{1} << 32) - 1;  // HDF5 counts a chunk's bytes in 32 bits
constexpr std::uint64_t copy_block = std::uint64_t{1} << 24;           // bytes copied at a time
constexpr std::uint64_t worth_deflating = std::uint64_t{1} << 12;      // bytes a row

hdf5::DatasetSpec spec_of(const Column& column) {
  hdf5::DatasetSpec spec{.element = column.element, .shape = {0}, .text_length = column.text_length};
  spec.shape.insert(spec.shape.end(), column.row_shape.begin(), column.row_shape.end());
  return spec;
}

/// Space for the rows expected, or for twice as many rows as there are once they are more.
std::uint64_t roomy(std::uint64_t rows, std::uint64_t expected) {
  return std::max<std::uint64_t>(1, rows <= expected ? expected : 2 * rows);
}

}  // namespace

GrowingFile::GrowingFile(std::filesystem::path path, std::vector<Series> series, WriteRest write_rest,
                         const Source& source)
    : path_(std::move(path)), series_(std::move(series)), write_rest_(std::move(write_rest)), states_(series_.size()) {
  for (std::size_t s = 0; s < series_.size(); ++s) {
    states_[s].pending.resize(series_[s].columns.size());
    for (const auto& column : series_[s].columns)
      if (const auto bytes = hdf5::row_bytes(spec_of(column)); bytes > largest_chunk)
        throw FileError(fmt::format("{}: one row of {} takes {} bytes; the file format allows {}", path_.string(),
                                    column.path, bytes, largest_chunk));
  }
  replace(source, Purpose::growing, 0);
}

void GrowingFile::append(std::size_t series, std::size_t column, std::span<const double> values) {
  const auto bytes = std::as_bytes(values);
  auto& pending = states_.at(series).pending.at(column);
  pending.insert(pending.end(), bytes.begin(), bytes.end());
}

void GrowingFile::append(std::size_t series, std::size_t column, std::int64_t value) {
  const auto bytes = std::as_bytes(std::span(&value, 1));
  auto& pending = states_.at(series).pending.at(column);
  pending.insert(pending.end(), bytes.begin(), bytes.end());
}

void GrowingFile::append(std::size_t series, std::size_t column, const std::string& text) {
  auto& pending = states_.at(series).pending.at(column);
  const auto length = series_[series].columns[column].text_length;
  const auto start = pending.size();
  pending.resize(start + length, std::byte{0});
  std::memcpy(pending.data() + start, text.data(), std::min(text.size(), length));
}

std::uint64_t GrowingFile::rows(std::size_t series) const {
  const auto& state = states_.at(series);
  if (state.pending.empty()) return 0;
  return state.rows + state.pending.front().size() / hdf5::row_bytes(spec_of(series_[series].columns.front()));
}

void GrowingFile::commit() {
  for (std::size_t s = 0; s < states_.size(); ++s)
    if (rows(s) > states_[s].capacity) return rewrite();

  for (std::size_t s = 0; s < states_.size(); ++s)  // values first, where no reader looks yet
    for (std::size_t c = 0; c < states_[s].placed.size(); ++c) write_pending(s, c);
  for (std::size_t s = 0; s < states_.size(); ++s) {  // then the counts, the first column's last
    auto& state = states_[s];
    const auto grown = rows(s);
    if (grown == state.rows) continue;
    for (auto& each : std::views::reverse(state.placed)) each.dataset.publish_rows(grown);
    for (auto& pending : state.pending) pending.clear();
    state.rows = grown;
  }
}

void GrowingFile::write_pending(std::size_t series, std::size_t column) {
  const auto& placed = states_[series].placed[column];
  const auto bytes = hdf5::row_bytes(spec_of(series_[series].columns[column]));
  auto first = states_[series].rows;
  for (std::span<const std::byte> rest(states_[series].pending[column]); !rest.empty();) {
    const auto row = first % placed.chunk_rows;
    const auto count = std::min<std::uint64_t>(rest.size() / bytes, placed.chunk_rows - row);
    file_.write_at(placed.chunk_address.at(first / placed.chunk_rows) + row * bytes, rest.first(count * bytes));
    rest = rest.subspan(count * bytes);
    first += count;
  }
}

GrowingFile::Source GrowingFile::itself() const {
  Source source{.file = &file_, .rows = {}};
  for (const auto& state : states_) source.rows.push_back(state.rows);
  return source;
}

void GrowingFile::rewrite() { replace(itself(), Purpose::growing, 0); }

void GrowingFile::compact(int deflate) {
  replace(itself(), Purpose::final, deflate);
  for (auto& state : states_) state.placed.clear();
  file_.close();
}

void GrowingFile::replace(const Source& source, Purpose purpose, int deflate) {
  ReplaceFile replacement(path_);
  auto fresh = hdf5::File::create(replacement.temporary());
  std::vector<std::vector<Placed>> placed(series_.size());
  try {
    write_rest_(fresh);
    for (std::size_t s = 0; s < series_.size(); ++s)
      for (std::size_t c = 0; c < series_[s].columns.size(); ++c)
        placed[s].push_back(place(fresh, s, c, source, purpose, deflate));
    fresh.flush();
    const bool precious = std::ranges::any_of(source.rows, [](std::uint64_t rows) { return rows > 0; });
    replacement.commit(precious ? ReplaceFile::Durability::disk : ReplaceFile::Durability::process);
  } catch (...) {
    fresh.discard();
    throw;
  }
  fresh.set_name(path_.string());

  for (std::size_t s = 0; s < series_.size(); ++s) {
    auto& state = states_[s];
    state.rows = (source.file != nullptr ? source.rows.at(s) : 0) + (rows(s) - state.rows);
    state.placed = std::move(placed[s]);
    state.capacity = ~std::uint64_t{0};
    for (const auto& each : state.placed)
      state.capacity = std::min(state.capacity, each.chunk_rows * each.chunk_address.size());
    for (auto& pending : state.pending) pending.clear();
  }
  std::swap(file_, fresh);  // the old file closes here, after its datasets
}

GrowingFile::Placed GrowingFile::place(hdf5::File& target, std::size_t series, std::size_t column, const Source& source,
                                       Purpose purpose, int deflate) const {
  const auto& description = series_[series].columns[column];
  const auto& pending = states_[series].pending[column];
  auto spec = spec_of(description);
  const auto bytes = hdf5::row_bytes(spec);
  const auto old_rows = source.file != nullptr ? source.rows.at(series) : 0;
  const auto new_rows = pending.size() / bytes;
  spec.shape[0] = old_rows + new_rows;
  if (purpose == Purpose::growing)
    spec.chunk_rows = std::min(roomy(spec.shape[0], series_[series].expected_rows), largest_chunk / bytes);
  else if (deflate > 0 && bytes >= worth_deflating && spec.shape[0] > 0)
    spec.chunk_rows = 1, spec.deflate = deflate;

  Placed placed{
      .dataset = target.create_dataset(description.path, spec), .chunk_rows = spec.chunk_rows, .chunk_address = {}};
  target.set_attribute(description.path, "units", description.units);
  target.set_attribute(description.path, "description", description.description);
  if (old_rows > 0) {
    const auto from = source.file->dataset(description.path);
    const auto block = std::max<std::uint64_t>(1, copy_block / bytes);
    for (std::uint64_t row = 0; row < old_rows; row += block) {
      const auto count = std::min(block, old_rows - row);
      placed.dataset.write_rows(row, count, from.read_bytes(row, count));
    }
  }
  placed.dataset.write_rows(old_rows, new_rows, pending);
  if (purpose == Purpose::growing)
    for (std::uint64_t row = 0; row < spec.shape[0]; row += spec.chunk_rows)
      placed.chunk_address.push_back(placed.dataset.address_of_chunk(row));
  return placed;
}

}  // namespace sundrape
