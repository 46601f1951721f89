#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sundrape/io/hdf5.hpp"
#include "sundrape/io/result.hpp"

#include "checkpoint_slots.hpp"

namespace sundrape {

/// All of a result but the rows: attributes, mesh, obstacles, statistics, checkpoint. Written anew into every new file.
struct ResultRest {
  ResultHeader header;
  ResultStatus status = ResultStatus::running;
  std::string message = {};
  bool finished = false;  // no further checkpoints: one slot is enough
  std::vector<Statistic> statistics = {};
  std::optional<checkpoint_slots::Numbered> checkpoint = {};

  void write(hdf5::File& file) const;
  /// Status and message, in place.
  void write_status(hdf5::File& file) const;
};

}  // namespace sundrape
