#include "checkpoint_slots.hpp"

#include <algorithm>
#include <array>

namespace sundrape::checkpoint_slots {
namespace {

const std::array<std::string, 2> slots{"/checkpoint/slot_0", "/checkpoint/slot_1"};

std::array<std::int64_t, 6> counts(const Checkpoint& checkpoint) {
  const auto number = [](std::uint64_t count) { return static_cast<std::int64_t>(count); };
  return {number(checkpoint.frames),   number(checkpoint.steps),      number(checkpoint.probe_rows),
          number(checkpoint.warnings), number(checkpoint.iterations), number(checkpoint.critical_points)};
}

template <class Range>
auto bytes_of(const Range& values) {
  return std::as_bytes(std::span(values));
}

void create_slot(hdf5::File& file, const std::string& slot, const Numbered& content) {
  const auto write = [&](const std::string& name, hdf5::Element element, std::uint64_t size,
                         std::span<const std::byte> bytes) {
    file.create_dataset(slot + "/" + name, {.element = element, .shape = {size}}).write_rows(0, size, bytes);
  };
  file.create_group(slot + "/arrays");
  for (const auto& [name, values] : content.checkpoint.arrays)
    write("arrays/" + name, hdf5::Element::real64, values.size(), bytes_of(values));
  write("rows", hdf5::Element::int64, 6, bytes_of(counts(content.checkpoint)));
  file.set_attribute(
      slot + "/rows", "description",
      std::string("frames, steps, probe rows, warnings, iterations and critical points up to the checkpoint"));
  write("sequence", hdf5::Element::int64, 1, bytes_of(std::array{content.sequence}));
  file.set_attribute(slot + "/sequence", "description", std::string("the larger the newer; 0: not valid"));
}

bool same_arrays(const Checkpoint& a, const Checkpoint& b) {
  return std::ranges::equal(a.arrays, b.arrays, [](const auto& x, const auto& y) {
    return x.first == y.first && x.second.size() == y.second.size();
  });
}

std::int64_t sequence_of(const hdf5::File& file, const std::string& slot) {
  const auto path = slot + "/sequence";
  return file.exists(path) ? file.dataset(path).read<std::int64_t>().at(0) : 0;
}

}  // namespace

void create(hdf5::File& file, const Numbered& newest) {
  create_slot(file, slots[0], newest);
  create_slot(file, slots[1], {.checkpoint = newest.checkpoint, .sequence = 0});
}

void create_single(hdf5::File& file, const Numbered& newest) { create_slot(file, slots[0], newest); }

bool overwrite_older(hdf5::File& file, const Numbered& next, const Numbered& newest) {
  if (!same_arrays(next.checkpoint, newest.checkpoint)) return false;
  if (!file.exists(slots[1])) return false;
  const auto& slot = sequence_of(file, slots[0]) < sequence_of(file, slots[1]) ? slots[0] : slots[1];
  const auto place = [&](const std::string& name, std::span<const std::byte> bytes) {
    if (!bytes.empty()) file.write_at(file.dataset(slot + "/" + name).address_of_chunk(0), bytes);
  };
  place("sequence", bytes_of(std::array{std::int64_t{0}}));
  for (const auto& [name, values] : next.checkpoint.arrays) place("arrays/" + name, bytes_of(values));
  place("rows", bytes_of(counts(next.checkpoint)));
  file.synchronise();  // the number must not reach the disk before what it vouches for
  place("sequence", bytes_of(std::array{next.sequence}));
  return true;
}

std::optional<Numbered> read_newest(const hdf5::File& file) {
  const auto sequence_0 = sequence_of(file, slots[0]);
  const auto sequence_1 = sequence_of(file, slots[1]);
  const auto& slot = sequence_1 > sequence_0 ? slots[1] : slots[0];
  Numbered newest{.checkpoint = {}, .sequence = std::max(sequence_0, sequence_1)};
  if (newest.sequence <= 0) return std::nullopt;
  auto& checkpoint = newest.checkpoint;
  const auto inside = slot + "/arrays/";
  for (const auto& name : file.children(slot + "/arrays"))
    checkpoint.arrays[name] = file.dataset(inside + name).read<double>();
  const auto rows = file.dataset(slot + "/rows").read<std::int64_t>();
  // results of version 0.1 count the first four only
  const auto number = [&](std::size_t i) { return i < rows.size() ? static_cast<std::uint64_t>(rows[i]) : 0; };
  checkpoint.frames = number(0);
  checkpoint.steps = number(1);
  checkpoint.probe_rows = number(2);
  checkpoint.warnings = number(3);
  checkpoint.iterations = number(4);
  checkpoint.critical_points = number(5);
  return newest;
}

}  // namespace sundrape::checkpoint_slots
