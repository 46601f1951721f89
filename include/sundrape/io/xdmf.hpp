#pragma once
#include <chrono>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sundrape/io/result.hpp"

namespace sundrape {

/// What an XDMF description of a result says.
struct XdmfContent {
  std::string result_file;  // name of the HDF5 file, relative to the description
  std::size_t nodes = 0, quads = 0;
  std::size_t rows = 0;  // frames that the description covers
  bool director = false, element_fields = false;
};

/// Text as it can stand in XML.
[[nodiscard]] std::string escaped_xml(const std::string& text);

/// The XDMF 3 text of a result: one grid a frame, whose geometry, velocity and contact force are slabs of the HDF5
/// file. frame_values: time or load factor of each frame.
[[nodiscard]] std::string xdmf_text(const XdmfContent& content, std::span<const double> frame_values);

/// Keeps OUT.xdmf beside OUT.h5 in step with the frames written, at most about once a second.
class XdmfWriter {
 public:
  XdmfWriter(std::filesystem::path result, const ResultHeader& header);

  /// To be called after every frame. @throws FileError
  void add_frame(double variable);
  /// Frames that are there already, when an analysis goes on.
  void set_frames(std::span<const double> variables);
  /// Writes it now if frames were added since. @throws FileError
  void write();
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  XdmfContent content_;
  std::vector<double> variables_;
  std::size_t written_ = 0;
  std::chrono::steady_clock::time_point next_{};
};

}  // namespace sundrape
