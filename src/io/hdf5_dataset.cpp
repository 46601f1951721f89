#include <algorithm>
#include <array>
#include <numeric>

#include <fmt/format.h>

#include "hdf5_support.hpp"

namespace sundrape::hdf5 {
namespace {

std::uint64_t entries(std::span<const std::uint64_t> shape) {
  return std::accumulate(shape.begin(), shape.end(), std::uint64_t{1}, std::multiplies<>());
}

template <class T>
Id native_type();
template <>
Id native_type<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
Id native_type<std::int32_t>() {
  return H5T_NATIVE_INT32;
}
template <>
Id native_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}

Handle element_type(const DatasetSpec& spec, const std::string& file) {
  const auto copy = [&](Id type) { return require(H5Tcopy(type), H5Tclose, file, "copy a data type"); };
  switch (spec.element) {
    case Element::real64:
      return copy(H5T_NATIVE_DOUBLE);
    case Element::real32:
      return copy(H5T_NATIVE_FLOAT);
    case Element::int32:
      return copy(H5T_NATIVE_INT32);
    case Element::int64:
      return copy(H5T_NATIVE_INT64);
    case Element::uint8:
      return copy(H5T_NATIVE_UINT8);
    case Element::text:
      break;
  }
  return text_type(spec.text_length, file);
}

/// Attributes and offsets: HDF5's default is to stamp objects with a time, which would make equal runs differ.
Handle creation_properties(const DatasetSpec& spec, const std::string& file, const std::string& attempt) {
  Handle properties = require(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, file, attempt);
  const auto id = properties.id();
  require(H5Pset_obj_track_times(id, false), file, attempt);
  require(H5Pset_fill_time(id, H5D_FILL_TIME_NEVER), file, attempt);
  if (spec.chunk_rows == 0 || spec.deflate == 0) require(H5Pset_alloc_time(id, H5D_ALLOC_TIME_EARLY), file, attempt);
  if (spec.chunk_rows > 0) {
    std::vector<hsize_t> chunk(spec.shape.begin(), spec.shape.end());
    chunk[0] = spec.chunk_rows;
    require(H5Pset_chunk(id, static_cast<int>(chunk.size()), chunk.data()), file, attempt);
    if (spec.deflate > 0) {
      require(H5Pset_shuffle(id), file, attempt);
      require(H5Pset_deflate(id, static_cast<unsigned>(spec.deflate)), file, attempt);
    }
  }
  return properties;
}

}  // namespace

std::size_t row_bytes(const DatasetSpec& spec) {
  constexpr std::array<std::size_t, 5> sizes{8, 4, 4, 8, 1};
  const auto element = spec.element == Element::text ? spec.text_length : sizes[static_cast<std::size_t>(spec.element)];
  return element * entries(std::span(spec.shape).subspan(1));
}

Dataset File::create_dataset(const std::string& path, const DatasetSpec& spec) {
  const auto attempt = fmt::format("create the dataset {}", path);
  const std::vector<hsize_t> shape(spec.shape.begin(), spec.shape.end());
  auto limits = shape;
  if (spec.chunk_rows > 0) limits[0] = H5S_UNLIMITED;
  const Handle space =
      require(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), limits.data()), H5Sclose, name_, attempt);
  const Handle type = element_type(spec, name_);
  const Handle properties = creation_properties(spec, name_, attempt);
  const Handle links = require(H5Pcreate(H5P_LINK_CREATE), H5Pclose, name_, attempt);
  require(H5Pset_create_intermediate_group(links.id(), 1), name_, attempt);
  return {
      require(H5Dcreate2(handle_.id(), path.c_str(), type.id(), space.id(), links.id(), properties.id(), H5P_DEFAULT),
              H5Dclose, name_, attempt),
      name_, path};
}

Dataset File::dataset(const std::string& path) const {
  return {require(H5Dopen2(handle_.id(), path.c_str(), H5P_DEFAULT), H5Dclose, name_, fmt::format("open {}", path)),
          name_, path};
}

Dataset::Dataset(Handle handle, std::string file, std::string path)
    : handle_(std::move(handle)), file_(std::move(file)), path_(std::move(path)) {}

std::vector<std::uint64_t> Dataset::shape() const {
  const auto attempt = fmt::format("read the shape of {}", path_);
  const Handle space = require(H5Dget_space(handle_.id()), H5Sclose, file_, attempt);
  const int rank = require(H5Sget_simple_extent_ndims(space.id()), file_, attempt);
  std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
  require(H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr), file_, attempt);
  return {shape.begin(), shape.end()};
}

std::uint64_t Dataset::rows() const {
  const auto all = shape();
  return all.empty() ? 0 : all.front();
}

std::size_t Dataset::file_row_bytes() const {
  const Handle type = require(H5Dget_type(handle_.id()), H5Tclose, file_, fmt::format("read the type of {}", path_));
  const auto all = shape();
  return H5Tget_size(type.id()) * entries(std::span(all).subspan(std::min<std::size_t>(1, all.size())));
}

namespace {

/// Memory and file selections of a block of rows.
struct RowSelection {
  Handle file, memory;
};

RowSelection select_rows(Id dataset, std::vector<std::uint64_t> shape, std::uint64_t first, std::uint64_t count,
                         const std::string& file, const std::string& attempt) {
  RowSelection selection{.file = require(H5Dget_space(dataset), H5Sclose, file, attempt), .memory = {}};
  std::vector<hsize_t> start(shape.size(), 0), size(shape.begin(), shape.end());
  start[0] = first;
  size[0] = count;
  require(H5Sselect_hyperslab(selection.file.id(), H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr), file,
          attempt);
  selection.memory =
      require(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose, file, attempt);
  return selection;
}

}  // namespace

void Dataset::write_rows(std::uint64_t first, std::uint64_t count, std::span<const std::byte> bytes) {
  const auto attempt = fmt::format("write rows {} to {} of {}", first, first + count, path_);
  if (bytes.size() != count * file_row_bytes())
    throw FileError(fmt::format("{}: cannot {}: {} bytes given, {} needed", file_, attempt, bytes.size(),
                                count * file_row_bytes()));
  if (bytes.empty()) return;
  const Handle type = require(H5Dget_type(handle_.id()), H5Tclose, file_, attempt);
  const auto selection = select_rows(handle_.id(), shape(), first, count, file_, attempt);
  require(H5Dwrite(handle_.id(), type.id(), selection.memory.id(), selection.file.id(), H5P_DEFAULT, bytes.data()),
          file_, attempt);
}

void Dataset::read_into(void* memory, Id memory_type, std::uint64_t first, std::uint64_t count) const {
  const auto attempt = fmt::format("read rows {} to {} of {}", first, first + count, path_);
  if (first + count > rows()) throw FileError(fmt::format("{}: cannot {}: it has {}", file_, attempt, rows()));
  if (count == 0) return;
  const auto selection = select_rows(handle_.id(), shape(), first, count, file_, attempt);
  require(H5Dread(handle_.id(), memory_type, selection.memory.id(), selection.file.id(), H5P_DEFAULT, memory), file_,
          attempt);
}

template <class T>
std::vector<T> Dataset::read_rows(std::uint64_t first, std::uint64_t count) const {
  const auto all = shape();
  std::vector<T> values(count * entries(std::span(all).subspan(std::min<std::size_t>(1, all.size()))));
  read_into(values.data(), native_type<T>(), first, count);
  return values;
}
template std::vector<double> Dataset::read_rows(std::uint64_t, std::uint64_t) const;
template std::vector<std::int32_t> Dataset::read_rows(std::uint64_t, std::uint64_t) const;
template std::vector<std::int64_t> Dataset::read_rows(std::uint64_t, std::uint64_t) const;

std::vector<std::byte> Dataset::read_bytes(std::uint64_t first, std::uint64_t count) const {
  const Handle type = require(H5Dget_type(handle_.id()), H5Tclose, file_, fmt::format("read {}", path_));
  std::vector<std::byte> bytes(count * file_row_bytes());
  read_into(bytes.data(), type.id(), first, count);
  return bytes;
}

std::vector<std::string> Dataset::read_text(std::uint64_t first, std::uint64_t count) const {
  const auto bytes = read_bytes(first, count);
  const auto length = file_row_bytes();
  std::vector<std::string> texts;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto* const begin = reinterpret_cast<const char*>(bytes.data()) + i * length;
    texts.emplace_back(begin, std::find(begin, begin + length, '\0'));
  }
  return texts;
}

void Dataset::publish_rows(std::uint64_t rows) {
  const auto attempt = fmt::format("add rows to {}", path_);
  auto extent = shape();
  extent[0] = rows;
  const std::vector<hsize_t> size(extent.begin(), extent.end());
  require(H5Dset_extent(handle_.id(), size.data()), file_, attempt);
  require(H5Dflush(handle_.id()), file_, attempt);
}

std::uint64_t Dataset::address_of_chunk(std::uint64_t row) const {
  const auto attempt = fmt::format("find row {} of {} in the file", row, path_);
  const Handle properties = require(H5Dget_create_plist(handle_.id()), H5Pclose, file_, attempt);
  haddr_t address = HADDR_UNDEF;
  if (require(H5Pget_layout(properties.id()), file_, attempt) == H5D_CHUNKED) {
    std::vector<hsize_t> coordinates(shape().size(), 0);
    coordinates[0] = row;
    unsigned filters = 0;
    hsize_t size = 0;
    require(H5Dget_chunk_info_by_coord(handle_.id(), coordinates.data(), &filters, &address, &size), file_, attempt);
  } else {
    address = H5Dget_offset(handle_.id());
  }
  if (address == HADDR_UNDEF) throw FileError(fmt::format("{}: cannot {}: it has no space yet", file_, attempt));
  return address;
}

}  // namespace sundrape::hdf5
