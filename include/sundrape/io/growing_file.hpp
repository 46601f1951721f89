#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sundrape/io/hdf5.hpp"

namespace sundrape {

/// One growing dataset of a result: a row for every frame, step or warning.
struct Column {
  std::string path;  // "/frames/position"
  hdf5::Element element = hdf5::Element::real64;
  std::vector<std::uint64_t> row_shape;  // {} a number, {N, 3} a vector a node
  std::size_t text_length = 0;           // bytes, of text
  std::string units, description;
};

/// Datasets that grow together. The first one is published last: its rows count the rows of all. May have no columns.
struct Series {
  std::vector<Column> columns;
  std::uint64_t expected_rows = 0;  // space for so many rows is set aside from the first row on
};

/// An HDF5 file that grows by rows and can be read at any moment, whatever happens to its writer.
///
/// Nothing that HDF5 needs to find its way ever changes while rows are added: each dataset is one chunk of its whole
/// capacity, allocated when the file is made, at an address that stays. Adding rows means (1) writing the values behind
/// the last row, past HDF5, where no reader looks yet, and (2) changing the row counts in the datasets' headers, the
/// first column's last. When a capacity is used up, or the structure changes, a new file with more space is written
/// under NAME.tmp and renamed over the old one, which is atomic. See docs/result-file.md.
class GrowingFile {
 public:
  /// Writes all that is neither a series nor a value changed in place. Called once for every new file.
  using WriteRest = std::function<void(hdf5::File&)>;

  /// Rows to start from: the first `rows[s]` rows of every column of series s in `file`.
  struct Source {
    const hdf5::File* file = nullptr;
    std::vector<std::uint64_t> rows;
  };

  /// Creates the file, replacing one of that name only when the new one is complete.
  /// @throws FileError
  GrowingFile(std::filesystem::path path, std::vector<Series> series, WriteRest write_rest, const Source& source);
  GrowingFile(std::filesystem::path path, std::vector<Series> series, WriteRest write_rest)
      : GrowingFile(std::move(path), std::move(series), std::move(write_rest), Source{}) {}

  /// Adds values to a column, in memory. Every column must be given whole rows, equally many before commit().
  void append(std::size_t series, std::size_t column, std::span<const double> values);
  void append(std::size_t series, std::size_t column, std::int64_t value);
  /// Cut to the column's text length.
  void append(std::size_t series, std::size_t column, const std::string& text);

  /// Rows in the file and in memory.
  [[nodiscard]] std::uint64_t rows(std::size_t series) const;

  /// Writes the rows held in memory: all are visible to readers afterwards, or (on an error) those before.
  /// @throws FileError  a full disk, for instance; the rows stay in memory
  void commit();

  /// Writes a new file with the rows so far, in the file and in memory, and what `write_rest` now says.
  /// @throws FileError  the old file stays
  void rewrite();
  /// The same with no space to spare, and closes it. deflate: gzip level of large columns, 0 for none.
  void compact(int deflate = 0);

  /// The file, for values that change in place.
  [[nodiscard]] hdf5::File& file() { return file_; }

 private:
  enum class Purpose { growing, final };
  struct Placed {  // one column in the open file
    hdf5::Dataset dataset;
    std::uint64_t chunk_rows;
    std::vector<std::uint64_t> chunk_address;
  };
  struct State {                                  // of one series
    std::uint64_t rows = 0, capacity = 0;         // in the file
    std::vector<Placed> placed;                   // one a column
    std::vector<std::vector<std::byte>> pending;  // one a column
  };

  void replace(const Source& source, Purpose purpose, int deflate);
  [[nodiscard]] Placed place(hdf5::File& target, std::size_t series, std::size_t column, const Source& source,
                             Purpose purpose, int deflate) const;
  [[nodiscard]] Source itself() const;
  void write_pending(std::size_t series, std::size_t column);

  std::filesystem::path path_;
  std::vector<Series> series_;
  WriteRest write_rest_;
  hdf5::File file_;
  std::vector<State> states_;
};

}  // namespace sundrape
