#pragma once
#include <string>

namespace sundrape {

/// A case that is right; tests of wrong ones change one line of it. The line numbers are those of the tests.
inline std::string sample_case() {
  return R"(title = "A sheet falls on a table"
model = "particle"
analysis = "dynamics"

[cloth]
shape = "rectangle"
size = ["20 cm", "20 cm"]
cells = [10, 10]
place = { translate = [0, 0, "1 mm"] }

[material]
thickness = "0.54229 mm"
weight = "0.2384e-3 gf/mm^2"
youngs_modulus = "118.1176 gf/mm^2"
poisson = 0.3

[[fix]]
nodes = { near = [0, 0, 0] }
components = ["x", "y"]

[[load]]
kind = "gravity"
acceleration = [0, 0, -9.80665]

[[obstacle]]
kind = "box"
size = ["8 cm", "8 cm", "8 cm"]
place = { translate = [0, 0, "-4 cm"] }

[dynamics]
integrator = "cvode"
duration = "0.2 s"
rtol = 1e-3

[output]
frames = 10
probes = [ { name = "corner", near = ["10 cm", "10 cm", 0] } ]
)";
}

/// The sample with the first `old` replaced.
inline std::string sample_with(const std::string& old, const std::string& text) {
  std::string changed = sample_case();
  const auto at = changed.find(old);
  return at == std::string::npos ? "the sample has no " + old : changed.replace(at, old.size(), text);
}

/// A material that is right, for cases that replace the sample's.
inline std::string with_material(const std::string& material) {
  const std::string sample = sample_case();
  const auto begin = sample.find("thickness");
  const auto end = sample.find("\n[[fix]]");
  return sample.substr(0, begin) + material + sample.substr(end);
}

/// Everything that a case file can say in this version, in the units of the textile trade.
inline std::string full_case() {
  return R"(title    = "Tablecloth on a square table"
model    = "particle"
analysis = "dynamics"

[cloth]
shape = "rectangle"
size  = ["20 cm", "30 cm"]
cells = [20, 24]
place = { translate = [0, 0, "1 mm"], rotate = { axis = [0, 0, 2], angle = "45 deg" } }
waviness = { amplitude = "1e-4 in", seed = 7 }

[material]
thickness = "0.54229 mm"
weight    = "0.2384e-3 gf/mm^2"
youngs_modulus = "118.1176 gf/mm^2"
poisson   = 0.3
bending = { law = "linear", rigidity = ["0.589 gf*cm^2/cm", "0.4 gf*cm^2/cm"] }
damping = { mass = "0.1 1/s", membrane = "2 ms", bending = "0.5 ms" }
net = { compression_factor = 0.5, shear_factor = 2, shear = "diagonals", diagonal_compression_factor = 0.25 }

[[fix]]
nodes = "left"

[[fix]]
nodes = { plane = { point = [0, "1 cm", 0], normal = [0, 3, 0] } }
components = ["y"]
name = "symmetry"

[[fix]]
nodes = { sphere = { centre = [0, 0, 0], radius = "2 cm" } }

[[load]]
kind = "gravity"

[[load]]
kind = "force"
nodes = { near = ["10 cm", 0, 0] }
total = ["1 gf", 0, 0]
ramp = "0.1 s"

[[load]]
kind = "moment"
nodes = "right"
total = [0, "1 gf*cm", 0]

[[load]]
kind = "traction"
nodes = "top"
per_length = [0, "1 gf/cm", 0]

[[load]]
kind = "pressure"
value = "10 Pa"

[[obstacle]]
kind = "box"
size = ["8 cm", "8 cm", "4 cm"]
edge_radius = "1 mm"
place = { translate = [0, 0, "-4 cm"] }
friction = 0.0

[[obstacle]]
kind = "plane"
point = [0, 0, "-1 m"]

[[obstacle]]
kind = "cylinder"
radius = "2.5 cm"
length = "30 cm"
axis = [0, 4, 3]

[[obstacle]]
kind = "sphere"
radius = "3 cm"
name = "ball"

[[obstacle]]
kind = "capsule"
radius = "1 cm"
length = "5 cm"

[[obstacle]]
kind = "disc"
radius = "9 cm"

[contact]
thickness = "0.5 mm"
stiffness = "500 gf/cm^3"
restitution = 0.5

[dynamics]
integrator = "rk4"
duration = "1 s"
rtol = 1e-5
atol_position = "1 um"
atol_velocity = "1 mm/s"
max_order = 5
step = "0.1 ms"
max_step = "10 ms"
first_step = "1 us"
linear_solver = "cg"
time_limit = "2 min"

[relaxation]
tolerance = 1e-7
scheme = "chapter"
c_disp = "1 mm/N"

["arc-length"]
tolerance = 1e-6
target_iterations = 7
first_load_increment = 2.5e-4

[output]
every = "300 ms"
probes = [ { name = "tip", near = ["10 cm", 0, 0] } ]
)";
}

}  // namespace sundrape
