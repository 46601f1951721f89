#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "sundrape/export/writers.hpp"
#include "sundrape/version.hpp"

#include "output_file.hpp"

// Numbers with the names of the glTF 2.0 specification, https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
namespace sundrape {
namespace {

using Json = nlohmann::json;

constexpr int component_float = 5126, component_uint = 5125;
constexpr int target_vertices = 34962, target_indices = 34963;
constexpr std::array linen{0.967, 0.904, 0.776}, slate{0.274, 0.331, 0.393};  // linear

/// glTF's y points up, ours is z.
Vector3 y_up(const Vector3& v) { return {v.x(), v.z(), -v.y()}; }

/// The file's one buffer with its views and accessors.
class Accessors {
 public:
  explicit Accessors(const std::filesystem::path& file) : file_(file) {}

  /// One accessor on numbers of 1, 2, 3 or 4 components. `bounds`: whether it says their range, as positions must.
  template <class Number>
  std::size_t add(const std::vector<Number>& numbers, std::size_t components, int target, bool bounds = false) {
    static constexpr std::array types{"SCALAR", "VEC2", "VEC3", "VEC4"};
    Json view{{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", numbers.size() * sizeof(Number)}};
    if (target != 0) view["target"] = target;
    Json accessor{{"bufferView", views_.size()},
                  {"componentType", std::is_same_v<Number, float> ? component_float : component_uint},
                  {"count", numbers.size() / components},
                  {"type", types.at(components - 1)}};
    if (bounds) {
      std::vector<Number> low(components, std::numeric_limits<Number>::max());
      std::vector<Number> high(components, std::numeric_limits<Number>::lowest());
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        low[i % components] = std::min(low[i % components], numbers[i]);
        high[i % components] = std::max(high[i % components], numbers[i]);
      }
      accessor["min"] = low;
      accessor["max"] = high;
    }
    for (const auto number : numbers) append_bytes<std::endian::little>(bytes_, number);
    if (bytes_.size() > std::numeric_limits<std::uint32_t>::max() / 2)
      throw FileError(
          fmt::format("{}: would be larger than the 2 GiB that programs read: export fewer frames, "
                      "e.g. --frames ::2",
                      file_.string()));
    views_.push_back(std::move(view));
    accessors_.push_back(std::move(accessor));
    return accessors_.size() - 1;
  }
  std::size_t add(const std::vector<Vector3>& vectors, bool bounds) {
    std::vector<float> numbers;
    numbers.reserve(3 * vectors.size());
    for (const auto& v : vectors)
      for (const double component : y_up(v)) numbers.push_back(static_cast<float>(component));
    return add(numbers, 3, target_vertices, bounds);
  }
  std::size_t add(const Vector& values) {
    return add(std::vector<float>(values.begin(), values.end()), 1, target_vertices);
  }

  void finish(Json& document) const {
    document["bufferViews"] = views_;
    document["accessors"] = accessors_;
    document["buffers"] = {{{"byteLength", bytes_.size()}}};
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::filesystem::path file_;
  Json views_ = Json::array(), accessors_ = Json::array();
  std::string bytes_;  // all entries are of 4 bytes, which keeps them aligned
};

std::vector<std::uint32_t> triangles_of(const std::vector<std::array<int, 4>>& quads) {
  std::vector<std::uint32_t> corners;
  for (const auto& q : quads)
    for (const auto k : {0UL, 1UL, 2UL, 0UL, 2UL, 3UL}) corners.push_back(static_cast<std::uint32_t>(q[k]));
  return corners;
}

Json material(const char* name, const std::array<double, 3>& colour, bool two_sided) {
  return {{"name", name},
          {"doubleSided", two_sided},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {colour[0], colour[1], colour[2], 1.0}},
            {"metallicFactor", 0.0},
            {"roughnessFactor", 0.9}}}};
}

std::vector<Vector3> differences(const std::vector<Vector3>& to, const std::vector<Vector3>& from) {
  std::vector<Vector3> list;
  for (std::size_t i = 0; i < to.size(); ++i) list.emplace_back(to[i] - from[i]);
  return list;
}

/// A field's name as one of a program's own attributes, which begin with an underscore. Of the first frame only:
/// morph targets have no room for them.
std::string attribute_name(const NodalField& field) {
  std::string name = "_" + field.name;
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name;
}

/// The whole of a scene as a glTF document, its parts added in the order in which they refer to each other.
class Document {
 public:
  Document(const ExportScene& scene, const std::filesystem::path& file) : scene_(scene), accessors_(file) {
    json_["asset"] = {{"version", "2.0"}, {"generator", "sundrape " + version()}};
    json_["materials"] = {material("cloth", linen, true), material("obstacle", slate, false)};
    for (std::size_t k = 0; k < scene.frames(); ++k) shown_.push_back(static_cast<float>(scene.shown_at(k)));
    add_cloth();
    for (std::size_t b = 0; b < scene.bodies().size(); ++b) add_body(b);
    std::vector<std::size_t> nodes(json_["nodes"].size());
    for (std::size_t n = 0; n < nodes.size(); ++n) nodes[n] = n;
    json_["scenes"] = {{{"name", scene.result().title()}, {"nodes", nodes}}};
    json_["scene"] = 0;
    if (!channels_.empty())
      json_["animations"] = {{{"name", "motion"}, {"samplers", samplers_}, {"channels", channels_}}};
    accessors_.finish(json_);
  }

  /// The binary container: header, the JSON padded with blanks, the buffer.
  [[nodiscard]] std::string container() const {
    auto text = json_.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto& data = accessors_.bytes();
    std::string bytes = "glTF";
    const auto word = [&](std::size_t number) {
      append_bytes<std::endian::little>(bytes, static_cast<std::uint32_t>(number));
    };
    word(2);
    word(12 + 8 + text.size() + 8 + data.size());
    word(text.size());
    bytes += "JSON" + text;
    word(data.size());
    bytes += std::string("BIN\0", 4) + data;
    return bytes;
  }

 private:
  void add_cloth() {
    const auto start = scene_.frame(0);
    std::vector<float> texture;
    for (const auto& s : scene_.texture())
      texture.insert(texture.end(), {static_cast<float>(s.x()), 1 - static_cast<float>(s.y())});  // v runs downwards
    Json primitive{{"indices", accessors_.add(triangles_of(scene_.mesh().quads), 1, target_indices)},
                   {"material", 0},
                   {"attributes",
                    {{"POSITION", accessors_.add(start.positions, true)},
                     {"NORMAL", accessors_.add(start.normals, false)},
                     {"TEXCOORD_0", accessors_.add(texture, 2, target_vertices)}}}};
    for (const auto& field : start.fields)
      primitive["attributes"][attribute_name(field)] = accessors_.add(field.values);
    Json names = Json::array();
    for (std::size_t k = 1; k < scene_.frames(); ++k) {
      const auto frame = scene_.frame(k);
      Json target{{"POSITION", accessors_.add(differences(frame.positions, start.positions), true)},
                  {"NORMAL", accessors_.add(differences(frame.normals, start.normals), false)}};
      primitive["targets"].push_back(std::move(target));
      names.push_back(fmt::format("frame {}", scene_.frame_numbers()[k]));
    }
    Json mesh{{"name", "cloth"}, {"primitives", Json::array({primitive})}};
    const auto targets = scene_.frames() - 1;
    if (targets > 0) {
      mesh["weights"] = std::vector<double>(targets, 0.0);
      mesh["extras"] = {{"targetNames", names}};
      std::vector<float> weights(scene_.frames() * targets, 0.0F);
      for (std::size_t k = 1; k < scene_.frames(); ++k) weights[k * targets + k - 1] = 1;
      animate("weights", accessors_.add(weights, 1, 0));
    }
    std::vector<double> values;
    for (std::size_t k = 0; k < scene_.frames(); ++k) values.push_back(scene_.variable(k));
    json_["meshes"].push_back(std::move(mesh));
    json_["nodes"].push_back(
        {{"name", "cloth"},
         {"mesh", 0},
         {"extras",
          {{scene_.result().frame_variable() == FrameVariable::time ? "time_s" : "load_factor", values},
           {"texture_unit_m", scene_.texture_unit()}}}});
  }

  void add_body(std::size_t b) {
    const auto& [name, surface, moves] = scene_.bodies()[b];
    std::vector<std::uint32_t> corners;
    for (const auto& triangle : surface.triangles)
      for (const int v : triangle) corners.push_back(static_cast<std::uint32_t>(v));
    const Json primitive{
        {"indices", accessors_.add(corners, 1, target_indices)},
        {"material", 1},
        {"attributes",
         {{"POSITION", accessors_.add(surface.vertices, true)}, {"NORMAL", accessors_.add(surface.normals, false)}}}};
    json_["meshes"].push_back({{"name", name}, {"primitives", Json::array({primitive})}});
    std::vector<float> places, turns;
    for (std::size_t k = 0; k < (moves ? scene_.frames() : 1); ++k) add_pose(scene_.frame(k).bodies[b], places, turns);
    const auto first = [](const std::vector<float>& list, std::size_t size) {
      return std::vector<float>(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(size));
    };
    json_["nodes"].push_back({{"name", name},
                              {"mesh", json_["meshes"].size() - 1},
                              {"translation", first(places, 3)},
                              {"rotation", first(turns, 4)}});
    if (!moves || scene_.frames() < 2) return;
    animate("translation", accessors_.add(places, 3, 0));
    animate("rotation", accessors_.add(turns, 4, 0));
  }

  /// The pose in glTF's axes; quaternions of neighbouring frames on the same side, as interpolation wants them.
  static void add_pose(const Pose& pose, std::vector<float>& places, std::vector<float>& turns) {
    for (const double component : y_up(pose.position)) places.push_back(static_cast<float>(component));
    const Eigen::Quaterniond q(pose.rotation);
    const Vector3 axis = y_up(q.vec());
    std::array<float, 4> turn{static_cast<float>(axis.x()), static_cast<float>(axis.y()), static_cast<float>(axis.z()),
                              static_cast<float>(q.w())};
    if (turns.size() >= 4) {
      const auto before = turns.end() - 4;
      float side = 0;
      for (int i = 0; i < 4; ++i) side += before[i] * turn[static_cast<std::size_t>(i)];
      if (side < 0)
        for (auto& component : turn) component = -component;
    }
    turns.insert(turns.end(), turn.begin(), turn.end());
  }

  /// What the node that is added next does in time.
  void animate(const char* path, std::size_t output) {
    if (!times_) times_ = accessors_.add(shown_, 1, 0, true);
    samplers_.push_back({{"input", *times_}, {"output", output}, {"interpolation", "LINEAR"}});
    const auto node = std::string_view(path) == "weights" ? 0 : json_["nodes"].size() - 1;
    channels_.push_back({{"sampler", samplers_.size() - 1}, {"target", {{"node", node}, {"path", path}}}});
  }

  const ExportScene& scene_;
  Accessors accessors_;
  Json json_, samplers_ = Json::array(), channels_ = Json::array();
  std::vector<float> shown_;          // [s], one a frame
  std::optional<std::size_t> times_;  // their accessor
};

}  // namespace

WrittenFiles write_gltf(const ExportScene& scene, const std::filesystem::path& file) {
  OutputFile output(file);
  output.write(Document(scene, file).container());
  output.commit();
  return {file};
}

}  // namespace sundrape
