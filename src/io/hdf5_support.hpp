#pragma once
#include <string_view>

#include <hdf5.h>

#include "sundrape/io/hdf5.hpp"

/// What the sources of the HDF5 layer share.
namespace sundrape::hdf5 {

static_assert(std::is_same_v<Id, hid_t>);

/// @throws FileError  "FILE: cannot ATTEMPT: HDF5's innermost reason"
[[noreturn]] void fail(std::string_view file, std::string_view attempt);

/// Passes a non-negative result of the C library on; anything else is a failure of `attempt`.
template <class Result>
Result require(Result result, std::string_view file, std::string_view attempt) {
  if (result < 0) fail(file, attempt);
  return result;
}

/// The same for a call that returns an identifier.
inline Handle require(hid_t id, Handle::Close close, std::string_view file, std::string_view attempt) {
  return {require(id, file, attempt), close};
}

/// UTF-8 text type of a fixed length, padded with zeros, or of any length (H5T_VARIABLE).
[[nodiscard]] Handle text_type(std::size_t length, std::string_view file);

}  // namespace sundrape::hdf5
