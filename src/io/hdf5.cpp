#include "sundrape/io/hdf5.hpp"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include "hdf5_support.hpp"

namespace sundrape::hdf5 {
namespace {

/// Keeps the innermost entry of HDF5's error stack, which is the first one when walking upwards.
herr_t keep_innermost(unsigned depth, const H5E_error2_t* error, void* reason) {
  if (depth == 0 && error->desc != nullptr) *static_cast<std::string*>(reason) = error->desc;
  return 0;
}

/// To be called before anything else of HDF5. Its clean-up at exit crashes over files that could not be closed (1.10.8
/// frees such a file but keeps its identifier); nothing here needs it, since handles close themselves.
void silence() {
  static const bool once = H5dont_atexit() >= 0;
  (void)once;
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

/// No locks, so that readers can open a file that is being written; no caches between raw data and the file.
Handle access_properties(const std::string& file) {
  Handle properties = require(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, file, "set up file access");
  require(H5Pset_file_locking(properties.id(), false, true), file, "switch file locking off");
  require(H5Pset_libver_bounds(properties.id(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V18), file, "choose the file version");
  require(H5Pset_sieve_buf_size(properties.id(), 0), file, "switch the sieve buffer off");
  require(H5Pset_cache(properties.id(), 0, 521, 0, 0.75), file, "switch the chunk cache off");
  require(H5Pset_fclose_degree(properties.id(), H5F_CLOSE_STRONG), file, "set up file access");
  return properties;
}

}  // namespace

void fail(std::string_view file, std::string_view attempt) {
  std::string reason = "unknown reason";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
  H5Eclear2(H5E_DEFAULT);
  throw FileError(fmt::format("{}: cannot {}: {}", file, attempt, reason));
}

bool Handle::reset() {
  if (id_ < 0) return true;
  const bool closed = close_(std::exchange(id_, -1)) >= 0;
  if (!closed) silence();
  return closed;
}

File File::create(const std::filesystem::path& path) {
  silence();
  File file;
  file.name_ = path.string();
  const Handle access = access_properties(file.name_);
  const Handle creation = require(H5Pcreate(H5P_FILE_CREATE), H5Pclose, file.name_, "set up the file");
  // Almost every dataset has one chunk: small index nodes keep fifty of them from costing 200 kB.
  require(H5Pset_istore_k(creation.id(), 2), file.name_, "set up the file");
  file.handle_ = require(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()), H5Fclose, file.name_,
                         "create the file");
  return file;
}

File File::open(const std::filesystem::path& path, Access access) {
  silence();
  File file;
  file.name_ = path.string();
  const Handle properties = access_properties(file.name_);
  if (access == Access::read) require(H5Pset_cache(properties.id(), 0, 521, 1 << 20, 0.75), file.name_, "set a cache");
  file.handle_ = require(H5Fopen(path.c_str(), access == Access::read ? H5F_ACC_RDONLY : H5F_ACC_RDWR, properties.id()),
                         H5Fclose, file.name_, "open as an HDF5 file");
  return file;
}

Handle File::open_object(const std::string& path) const {
  return require(H5Oopen(handle_.id(), path.c_str(), H5P_DEFAULT), H5Oclose, name_, fmt::format("open {}", path));
}

bool File::exists(const std::string& path) const {
  if (path == "/") return true;
  for (std::size_t slash = path.find('/', 1);; slash = path.find('/', slash + 1)) {  // HDF5 asks one level at a time
    const auto found = H5Lexists(handle_.id(), path.substr(0, slash).c_str(), H5P_DEFAULT);
    if (require(found, name_, fmt::format("look for {}", path)) == 0) return false;
    if (slash == std::string::npos) return true;
  }
}

std::vector<std::string> File::children(const std::string& group) const {
  std::vector<std::string> names;
  if (!exists(group)) return names;
  const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  const Handle object = open_object(group);
  require(H5Literate(object.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &names), name_,
          fmt::format("list {}", group));
  return names;
}

void File::create_group(const std::string& path) {
  if (exists(path)) return;
  const Handle links = require(H5Pcreate(H5P_LINK_CREATE), H5Pclose, name_, "set up a group");
  require(H5Pset_create_intermediate_group(links.id(), 1), name_, "set up a group");
  (void)require(H5Gcreate2(handle_.id(), path.c_str(), links.id(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose, name_,
                fmt::format("create the group {}", path));
}

void File::flush() { require(H5Fflush(handle_.id(), H5F_SCOPE_LOCAL), name_, "write the file"); }

int File::descriptor() const {
  void* descriptor = nullptr;
  require(H5Fget_vfd_handle(handle_.id(), H5P_DEFAULT, &descriptor), name_, "reach the file's descriptor");
  return *static_cast<int*>(descriptor);
}

void File::synchronise() {
  if (::fdatasync(descriptor()) != 0)
    throw FileError(fmt::format("{}: cannot write to the disk: {}", name_, std::strerror(errno)));
}

void File::write_at(std::uint64_t address, std::span<const std::byte> bytes) {
  const int file = descriptor();
  while (!bytes.empty()) {
    const auto written = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(address));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw FileError(fmt::format("{}: cannot write: {}", name_, std::strerror(errno)));
    address += static_cast<std::uint64_t>(written);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void File::discard() noexcept {
  if (handle_.id() < 0) return;
  // What HDF5 still holds goes to memory instead of the disk: then closing has no reason to fail.
  const int memory = ::memfd_create("discarded", MFD_CLOEXEC);
  void* file = nullptr;
  if (memory >= 0 && H5Fget_vfd_handle(handle_.id(), H5P_DEFAULT, &file) >= 0) ::dup2(memory, *static_cast<int*>(file));
  if (memory >= 0) ::close(memory);
  handle_.reset();
}

void File::close() {
  if (!handle_.reset()) fail(name_, "close the file");
}

}  // namespace sundrape::hdf5
