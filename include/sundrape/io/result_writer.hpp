#pragma once
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "sundrape/io/result.hpp"

namespace sundrape {

class ResultReader;

/// Writes a result file that can be read at every moment, even when its writer is killed: at most the frame being
/// written is lost. docs/result-file.md has the layout and the reasons.
///
/// Steps and probes are kept in memory and written with the next frame or checkpoint. A writer that is destroyed
/// without finish() leaves the file as a kill would: readable, status "running".
class ResultWriter {
 public:
  /// Replaces what `path` holds; whether that is wanted is for the caller to ask.
  /// @throws FileError
  ResultWriter(const std::filesystem::path& path, ResultHeader header);

  /// Goes on with an earlier result at its newest checkpoint: what was written after it is left out. `path` may be the
  /// file that `earlier` reads.
  /// @throws FileError  no checkpoint, or another mesh
  [[nodiscard]] static ResultWriter resume(const std::filesystem::path& path, ResultHeader header,
                                           const ResultReader& earlier);

  ResultWriter(ResultWriter&&) noexcept;
  ResultWriter& operator=(ResultWriter&&) noexcept;
  ~ResultWriter();

  using StepValue = std::pair<std::string_view, double>;
  /// One accepted step, by the names of header.step_columns; what is not given is NaN, or 0 in a column of integers.
  /// @throws std::invalid_argument  a name that is not a column
  void append_step(std::initializer_list<StepValue> values);
  /// What the probes see at an accepted step. positions [m], velocities [m/s]: 3N, of the whole mesh.
  void append_probes(double time, ConstVectorRef positions, ConstVectorRef velocities);
  /// Writes a frame and all that waits; readers see it afterwards.
  /// @throws std::invalid_argument  arrays of the wrong size
  /// @throws FileError  the frames before stay readable
  void append_frame(const Frame& frame);
  [[nodiscard]] std::uint64_t frames() const;

  struct PathIteration {
    int step = 0, iteration = 0;  // from 1 on
    double load_factor = 0, residual = 0;
  };
  /// Of an equilibrium path; written with the next frame or checkpoint.
  void append_iteration(const PathIteration& iteration);
  void append_critical_point(const CriticalRecord& c);

  /// Written with the next frame or checkpoint.
  void add_warning(const std::string& text);
  /// Replaces one of that name. Written when the file is rewritten, at the latest by finish().
  void set_statistic(const std::string& name, StatisticValue value, const std::string& description);

  /// Writes what `resume` needs, beside the checkpoint before it, which stays valid until this one is complete; asks
  /// the disk to keep it. Counts in `checkpoint` are ignored: they are those of this writer.
  /// @throws FileError
  void write_checkpoint(const Checkpoint& checkpoint);

  /// Writes what waits, sets the status, and replaces the file by a compact one.
  /// @param message  why it failed, or where it was interrupted
  /// @param deflate  gzip level of the frames, 0 to 9
  /// @throws FileError  something that waited could not be written; what was written before is readable and has the
  /// status
  void finish(ResultStatus status, const std::string& message = {}, int deflate = 0);

 private:
  class Implementation;
  explicit ResultWriter(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace sundrape
