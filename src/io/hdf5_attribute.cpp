#include <algorithm>

#include <fmt/format.h>

#include "hdf5_support.hpp"

namespace sundrape::hdf5 {
namespace {

std::string read_text(Id attribute, Id type, const std::string& file, const std::string& attempt) {
  if (require(H5Tis_variable_str(type), file, attempt) > 0) {
    char* text = nullptr;
    const Handle memory = text_type(H5T_VARIABLE, file);
    require(H5Aread(attribute, memory.id(), &text), file, attempt);
    std::string copy = text == nullptr ? "" : text;
    H5free_memory(text);
    return copy;
  }
  std::string text(H5Tget_size(type), '\0');
  require(H5Aread(attribute, type, text.data()), file, attempt);
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

}  // namespace

Handle text_type(std::size_t length, std::string_view file) {
  Handle type = require(H5Tcopy(H5T_C_S1), H5Tclose, file, "set up a text type");
  require(H5Tset_size(type.id(), length), file, "set up a text type");
  require(H5Tset_cset(type.id(), H5T_CSET_UTF8), file, "set up a text type");
  if (length != H5T_VARIABLE) require(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), file, "set up a text type");
  return type;
}

std::vector<std::string> File::attribute_names(const std::string& object) const {
  std::vector<std::string> names;
  const auto collect = [](hid_t, const char* name, const H5A_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  const Handle owner = open_object(object);
  require(H5Aiterate2(owner.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names), name_,
          fmt::format("list the attributes of {}", object));
  return names;
}

bool File::has_attribute(const std::string& object, const std::string& name) const {
  if (!exists(object)) return false;
  const Handle owner = open_object(object);
  return require(H5Aexists(owner.id(), name.c_str()), name_, fmt::format("look for {} of {}", name, object)) > 0;
}

Attribute File::attribute(const std::string& object, const std::string& name) const {
  const auto attempt = fmt::format("read the attribute {} of {}", name, object);
  const Handle owner = open_object(object);
  const Handle attribute = require(H5Aopen(owner.id(), name.c_str(), H5P_DEFAULT), H5Aclose, name_, attempt);
  const Handle type = require(H5Aget_type(attribute.id()), H5Tclose, name_, attempt);
  const Handle space = require(H5Aget_space(attribute.id()), H5Sclose, name_, attempt);
  const auto kind = H5Tget_class(type.id());
  if (kind == H5T_STRING) return read_text(attribute.id(), type.id(), name_, attempt);
  const bool is_list = H5Sget_simple_extent_type(space.id()) != H5S_SCALAR;
  if (kind == H5T_INTEGER && !is_list) {
    std::int64_t value = 0;
    require(H5Aread(attribute.id(), H5T_NATIVE_INT64, &value), name_, attempt);
    return value;
  }
  std::vector<double> values(
      static_cast<std::size_t>(require(H5Sget_simple_extent_npoints(space.id()), name_, attempt)));
  require(H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, values.data()), name_, attempt);
  if (!is_list) return values.front();
  return values;
}

std::string File::text_attribute(const std::string& object, const std::string& name,
                                 const std::string& otherwise) const {
  if (!has_attribute(object, name)) return otherwise;
  const auto value = attribute(object, name);
  const auto* const text = std::get_if<std::string>(&value);
  return text != nullptr ? *text : otherwise;
}

namespace {

void write_attribute(Id owner, const std::string& name, Id type, Id space, const void* value, const std::string& file) {
  const auto attempt = fmt::format("write the attribute {}", name);
  Handle attribute;
  if (require(H5Aexists(owner, name.c_str()), file, attempt) > 0)
    attribute = require(H5Aopen(owner, name.c_str(), H5P_DEFAULT), H5Aclose, file, attempt);
  else
    attribute =
        require(H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, file, attempt);
  require(H5Awrite(attribute.id(), type, value), file, attempt);
}

}  // namespace

void File::set_attribute(const std::string& object, const std::string& name, const Attribute& value) {
  const Handle owner = open_object(object);
  const Handle scalar = require(H5Screate(H5S_SCALAR), H5Sclose, name_, "set up an attribute");
  if (const auto* const text = std::get_if<std::string>(&value)) {
    const char* const pointer = text->c_str();
    const Handle type = text_type(H5T_VARIABLE, name_);
    write_attribute(owner.id(), name, type.id(), scalar.id(), &pointer, name_);
  } else if (const auto* const list = std::get_if<std::vector<double>>(&value)) {
    const hsize_t size = list->size();
    const Handle space = require(H5Screate_simple(1, &size, nullptr), H5Sclose, name_, "set up an attribute");
    write_attribute(owner.id(), name, H5T_NATIVE_DOUBLE, space.id(), list->data(), name_);
  } else if (const auto* const integers = std::get_if<std::vector<std::int64_t>>(&value)) {
    const hsize_t size = integers->size();
    const Handle space = require(H5Screate_simple(1, &size, nullptr), H5Sclose, name_, "set up an attribute");
    write_attribute(owner.id(), name, H5T_NATIVE_INT64, space.id(), integers->data(), name_);
  } else if (const auto* const number = std::get_if<double>(&value)) {
    write_attribute(owner.id(), name, H5T_NATIVE_DOUBLE, scalar.id(), number, name_);
  } else {
    write_attribute(owner.id(), name, H5T_NATIVE_INT64, scalar.id(), &std::get<std::int64_t>(value), name_);
  }
}

void File::set_fixed_text(const std::string& object, const std::string& name, const std::string& text,
                          std::size_t length) {
  auto size = std::min(text.size(), length);
  if (size < text.size())  // never inside a UTF-8 character
    while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) --size;
  std::string padded = text.substr(0, size);
  padded.resize(length, '\0');
  const Handle owner = open_object(object);
  const Handle scalar = require(H5Screate(H5S_SCALAR), H5Sclose, name_, "set up an attribute");
  const Handle type = text_type(length, name_);
  write_attribute(owner.id(), name, type.id(), scalar.id(), padded.data(), name_);
}

void File::set_ascii_text(const std::string& object, const std::string& name, const std::string& text) {
  const Handle owner = open_object(object);
  const Handle scalar = require(H5Screate(H5S_SCALAR), H5Sclose, name_, "set up an attribute");
  const Handle type = text_type(text.size(), name_);
  require(H5Tset_cset(type.id(), H5T_CSET_ASCII), name_, "set up a text type");
  write_attribute(owner.id(), name, type.id(), scalar.id(), text.data(), name_);
}

}  // namespace sundrape::hdf5
