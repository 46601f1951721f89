#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sundrape/io/file_error.hpp"

/// A thin layer over the HDF5 C library: identifiers that close themselves, typed attributes and datasets.
///
/// Every failure is a FileError with the file's name, what was tried and HDF5's innermost reason. HDF5 itself prints
/// nothing, and files are not locked, so that others can read a file while it is written.
namespace sundrape::hdf5 {

using Id = std::int64_t;  // HDF5's hid_t

/// Owns one HDF5 identifier.
class Handle {
 public:
  using Close = int (*)(Id);
  Handle() = default;
  Handle(Id id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() { reset(); }

  [[nodiscard]] Id id() const { return id_; }
  /// Closes it now; false where HDF5 reports that closing failed.
  bool reset();

 private:
  Id id_ = -1;
  Close close_ = nullptr;
};

/// What one entry of a dataset is: IEEE number, integer (signed, but for single bytes), or UTF-8 text of a fixed
/// length.
enum class Element { real64, real32, int32, int64, uint8, text };

struct DatasetSpec {
  Element element = Element::real64;
  std::vector<std::uint64_t> shape;  // rows first
  std::size_t text_length = 0;       // bytes a text
  std::uint64_t chunk_rows = 0;      // 0: contiguous, of a fixed size; otherwise rows a chunk, and rows may be added
  int deflate = 0;                   // gzip level of the chunks, with byte shuffling; 0: none, space allocated at once
};

/// Bytes of one row of a dataset.
[[nodiscard]] std::size_t row_bytes(const DatasetSpec& spec);

using Attribute = std::variant<std::int64_t, double, std::string, std::vector<double>, std::vector<std::int64_t>>;

/// An open dataset.
class Dataset {
 public:
  Dataset(Handle handle, std::string file, std::string path);

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::vector<std::uint64_t> shape() const;
  [[nodiscard]] std::uint64_t rows() const;

  /// Rows [first, first + count) as they stand in memory: double, 32- or 64-bit integers, or text_length bytes.
  void write_rows(std::uint64_t first, std::uint64_t count, std::span<const std::byte> bytes);
  /// T: double, std::int32_t, std::int64_t (converted from what the file holds).
  template <class T>
  [[nodiscard]] std::vector<T> read_rows(std::uint64_t first, std::uint64_t count) const;
  template <class T>
  [[nodiscard]] std::vector<T> read() const {
    return read_rows<T>(0, rows());
  }
  [[nodiscard]] std::vector<std::string> read_text(std::uint64_t first, std::uint64_t count) const;
  /// Rows as they stand in the file, unconverted.
  [[nodiscard]] std::vector<std::byte> read_bytes(std::uint64_t first, std::uint64_t count) const;

  /// Changes the number of rows and hands exactly this dataset's header to the operating system.
  void publish_rows(std::uint64_t rows);
  /// Where row `row` stands in the file [bytes]; the row must be the first of its chunk, or 0 in a contiguous dataset.
  [[nodiscard]] std::uint64_t address_of_chunk(std::uint64_t row) const;

 private:
  [[nodiscard]] std::size_t file_row_bytes() const;
  void read_into(void* memory, Id memory_type, std::uint64_t first, std::uint64_t count) const;

  Handle handle_;
  std::string file_, path_;
};

enum class Access { read, write };

/// An open file. Paths of objects are absolute, as in "/frames/position".
class File {
 public:
  File() = default;
  /// A new file, replacing one of that name. Raw data goes straight to the file, through no cache.
  /// @throws FileError
  [[nodiscard]] static File create(const std::filesystem::path& path);
  /// @throws FileError  missing, unreadable, not HDF5
  [[nodiscard]] static File open(const std::filesystem::path& path, Access access = Access::read);

  [[nodiscard]] const std::string& name() const { return name_; }
  /// The name that messages use from here on (after the file was renamed).
  void set_name(std::string name) { name_ = std::move(name); }

  [[nodiscard]] bool exists(const std::string& path) const;
  /// Names of the links in a group, in alphabetical order; none where the group is missing.
  [[nodiscard]] std::vector<std::string> children(const std::string& group) const;
  /// Creates a group and those above it; one that exists is left alone.
  void create_group(const std::string& path);
  Dataset create_dataset(const std::string& path, const DatasetSpec& spec);
  [[nodiscard]] Dataset dataset(const std::string& path) const;

  [[nodiscard]] std::vector<std::string> attribute_names(const std::string& object) const;
  [[nodiscard]] bool has_attribute(const std::string& object, const std::string& name) const;
  [[nodiscard]] Attribute attribute(const std::string& object, const std::string& name) const;
  /// An attribute's text; `otherwise` where there is none or it is not text.
  [[nodiscard]] std::string text_attribute(const std::string& object, const std::string& name,
                                           const std::string& otherwise = {}) const;
  void set_attribute(const std::string& object, const std::string& name, const Attribute& value);
  /// Text of a fixed length, which changes in place; cut at a character's boundary where it does not fit.
  void set_fixed_text(const std::string& object, const std::string& name, const std::string& text, std::size_t length);
  /// Text that says of itself that it is ASCII, for readers that accept nothing else.
  void set_ascii_text(const std::string& object, const std::string& name, const std::string& text);

  void flush();
  /// Asks the disk to keep everything that was written (fdatasync).
  void synchronise();
  /// Writes at an absolute place of the file, past HDF5. For space that HDF5 has allocated and does not move.
  void write_at(std::uint64_t address, std::span<const std::byte> bytes);
  /// @throws FileError  where the last data could not be written
  void close();
  /// Closes a file that nobody wants any more, so that a full disk cannot get in the way. The file is to be removed.
  void discard() noexcept;

 private:
  [[nodiscard]] int descriptor() const;
  [[nodiscard]] Handle open_object(const std::string& path) const;

  Handle handle_;
  std::string name_;
};

}  // namespace sundrape::hdf5
