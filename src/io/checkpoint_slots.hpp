#pragma once
#include <cstdint>
#include <optional>

#include "sundrape/io/hdf5.hpp"
#include "sundrape/io/result.hpp"

/// /checkpoint: two slots that take turns. A slot's sequence number is 0 while it is being written and comes last, so
/// that at every moment one of them is whole once the first checkpoint is there.
namespace sundrape::checkpoint_slots {

struct Numbered {
  Checkpoint checkpoint;
  std::int64_t sequence = 0;
};

/// Creates both slots, with `newest` in the first one.
void create(hdf5::File& file, const Numbered& newest);
/// Creates the only slot of a finished file.
void create_single(hdf5::File& file, const Numbered& newest);
/// Overwrites the older slot; false where names or sizes of the arrays are not those of the slots.
[[nodiscard]] bool overwrite_older(hdf5::File& file, const Numbered& next, const Numbered& newest);
/// The newest valid checkpoint of a file.
[[nodiscard]] std::optional<Numbered> read_newest(const hdf5::File& file);

}  // namespace sundrape::checkpoint_slots
