#include "sundrape/io/xdmf.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "sundrape/io/file_error.hpp"
#include "sundrape/io/replace_file.hpp"
#include "sundrape/io/result_layout.hpp"

namespace sundrape {
namespace {

/// Frame `frame` of a dataset of F × `items` × 3.
std::string slab(const XdmfContent& content, const std::string& dataset, std::size_t frame, std::size_t items) {
  return fmt::format(
      R"(<DataItem ItemType="HyperSlab" Dimensions="{1} 3"><DataItem Dimensions="3 3" Format="XML">{2} 0 0 1 1 1 1 {1} 3</DataItem>)"
      R"(<DataItem Dimensions="{3} {1} 3" NumberType="Float" Precision="8" Format="HDF">{0}:/frames/{4}</DataItem></DataItem>)",
      escaped_xml(content.result_file), items, frame, content.rows, dataset);
}

}  // namespace

std::string escaped_xml(const std::string& text) {
  std::string result;
  for (const char c : text) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  return result;
}

std::string xdmf_text(const XdmfContent& content, std::span<const double> frame_values) {
  std::string text =
      "<?xml version=\"1.0\" ?>\n<Xdmf Version=\"3.0\">\n<Domain>\n"
      "<Grid Name=\"cloth\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  const auto out = std::back_inserter(text);
  for (std::size_t frame = 0; frame < frame_values.size(); ++frame) {
    fmt::format_to(out, "<Grid Name=\"cloth\" GridType=\"Uniform\"><Time Value=\"{:.17g}\"/>\n", frame_values[frame]);
    fmt::format_to(out,
                   R"(<Topology TopologyType="Quadrilateral" NumberOfElements="{0}"><DataItem Dimensions="{0} 4" )"
                   R"(NumberType="Int" Precision="4" Format="HDF">{1}:/mesh/quads</DataItem></Topology>)"
                   "\n",
                   content.quads, escaped_xml(content.result_file));
    fmt::format_to(out, "<Geometry GeometryType=\"XYZ\">{}</Geometry>\n",
                   slab(content, "position", frame, content.nodes));
    const auto vector = [&](const char* name) {
      fmt::format_to(out, "<Attribute Name=\"{0}\" AttributeType=\"Vector\" Center=\"Node\">{1}</Attribute>\n", name,
                     slab(content, name, frame, content.nodes));
    };
    vector("velocity");
    vector("contact_force");
    if (content.director) vector("director");
    if (content.element_fields)
      for (const auto& [name, components] : layout::element_fields())
        if (components == 3)  // XDMF has no vectors of two
          fmt::format_to(out, "<Attribute Name=\"{}\" AttributeType=\"Vector\" Center=\"Cell\">{}</Attribute>\n", name,
                         slab(content, fmt::format("element/{}", name), frame, content.quads));
    text += "</Grid>\n";
  }
  return text + "</Grid>\n</Domain>\n</Xdmf>\n";
}

XdmfWriter::XdmfWriter(std::filesystem::path result, const ResultHeader& header)
    : path_(std::move(result)),
      content_{.result_file = path_.filename().string(),
               .nodes = header.mesh.reference.size(),
               .quads = header.mesh.quads.size(),
               .director = header.director,
               .element_fields = header.element_fields} {
  path_.replace_extension(".xdmf");
}

void XdmfWriter::add_frame(double variable) {
  variables_.push_back(variable);
  if (std::chrono::steady_clock::now() >= next_) write();
}

void XdmfWriter::set_frames(std::span<const double> variables) {
  variables_.assign(variables.begin(), variables.end());
  written_ = 0;
}

void XdmfWriter::write() {
  if (written_ == variables_.size()) return;
  const auto start = std::chrono::steady_clock::now();
  content_.rows = variables_.size();
  ReplaceFile replacement(path_);
  std::ofstream file(replacement.temporary(), std::ios::binary | std::ios::trunc);
  file << xdmf_text(content_, variables_);
  file.close();
  if (!file) throw FileError(fmt::format("{}: cannot write", path_.string()));
  replacement.commit(ReplaceFile::Durability::process);
  written_ = variables_.size();
  const auto end = std::chrono::steady_clock::now();
  next_ = end + std::max<std::chrono::steady_clock::duration>(std::chrono::seconds(1), 50 * (end - start));
}

}  // namespace sundrape
