// Everything a user can set for one run.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace paver {

/// Which elements a mesh is made of.
enum class Elements {
  quad_dominant,  ///< quads, and triangles where they are better
  all_quad,       ///< no triangle wherever a face's boundary and shape allow; the report names the other faces
  all_triangle,   ///< every quad cut in two
};

/// "quad-dominant", "all-quad" or "all-triangle".
const char* elements_name(Elements elements);

/// What becomes of parts that touch or cross.
enum class Connect {
  imprint,  ///< they share faces, edges and vertices: one mesh
  united,   ///< as imprint, and what lies between or inside solids is left out: the outer skin
  none,     ///< as drawn
};

/// "imprint", "union" or "none".
const char* connect_name(Connect connect);

/// Target length for one part of the model: there and, growing by the gradation, around it.
struct LocalSize {
  std::string part;            ///< "Face3", "Edge5", "Vertex2" or "Solid1", numbered as FreeCAD does
  std::optional<double> size;  ///< mm, > 0; none: from the frequency, in the medium eps_r, mu_r
  double eps_r = 1, mu_r = 1;  ///< > 0
};

/// What solids are made of, under a name in the mesh. Where `frequency` is given their faces get the wavelength in it
/// where that is shorter, unless it conducts.
struct Medium {
  std::string name;
  std::vector<std::string> parts;  ///< "Solid1"
  double eps_r = 1, mu_r = 1;      ///< > 0
  double loss_tangent = 0;         ///< >= 0
  bool is_conductor = false;
};

/// Faces, edges and vertices that are a group of the mesh by themselves, and are never merged with others.
struct Port {
  std::string name;
  std::vector<std::string> parts;  ///< "Face3", "Edge5", "Vertex2"
};

/// Edges that stand for a thin wire: a group of lines, kept as ports are.
struct Wire {
  std::string name;
  std::vector<std::string> parts;  ///< "Edge5"
  double radius = 0;               ///< mm, > 0
};

/// Value of Options::multilevel: levels as the number of elements suggests.
constexpr int automatic_levels = -1;

/// Either `size` or `frequency` must be set. check() names the first bad field.
struct Options {
  std::optional<double> size;       ///< target length h, mm, > 0
  std::optional<double> frequency;  ///< Hz, > 0; h = c / (f sqrt(eps_r mu_r) divisions)
  double divisions = 10;            ///< elements per wavelength, > 0
  double eps_r = 1;                 ///< relative permittivity, > 0
  double mu_r = 1;                  ///< relative permeability, > 0
  int order = 2;                    ///< order of the elements: 1 or 2
  Elements elements = Elements::quad_dominant;
  /// Faces are meshed at this many times the target length first, and the coarse elements divided: 0: never; 4 to 8, or
  /// automatic_levels: 3 to 12, by the size of the face. Large faces only.
  int multilevel = automatic_levels;
  int threads = 0;                 ///< worker threads; 0: all cores
  int ranks = 0;                   ///< processes, for those who start them (paver/launch.h); 0: this one alone
  std::optional<double> max_turn;  ///< largest turn per element edge, radians; default pi/4, more on short ones
  double aspect = 8;               ///< how far elements may be narrower across a ridge than along it, 1 (not) to 64
  double gradation = 0.6;          ///< largest growth of h per unit of length, 0.05 to 2
  double tip = 32;                 ///< the target length is divided by it where a surface comes to a point, 1 to 64
  double grade_edges = 1;          ///< the target length is divided by it at sharp outer edges, 1 to 64
  int gap_elements = 1;            ///< across what is narrower than 0.7 of the target length, 1 to 8
  double merge = 0.1;  ///< of the target length, 0 to 0.5: shorter edges are merged with others; 0: nothing is merged
  double merge_width = 0.05;  ///< of the target length, 0 to 0.5: narrower faces are merged with neighbours
  /// Largest distance between mesh and surface, mm, > 0: what is farther off is meshed again with shorter lengths;
  /// none: whatever comes out.
  std::optional<double> chord_error;
  long max_elements = 2'000'000;        ///< stop before meshing when more are predicted
  std::optional<double> sew_tolerance;  ///< mm, >= 0 (0: never sew); default from the target length
  Connect connect = Connect::imprint;
  bool strict = false;           ///< a model that needs repairs, or has faces that cannot be meshed, is refused
  std::vector<LocalSize> local;  ///< target lengths of parts of the model; the least counts
  std::vector<Medium> media;     ///< a solid has one at most
  std::vector<Port> ports;       ///< a part is in one of the ports and wires at most
  std::vector<Wire> wires;

  double turn_limit() const { return max_turn ? *max_turn : 0.7853981633974483; }
};

/// Throws Error{bad_option} that names the option, its value and the range.
void check(const Options& options);

/// The target length in mm, from `size` or from the frequency. Options must have passed check().
double target_length(const Options& options);

/// The target length of a part in mm. Options must have passed check().
double local_length(const Options& options, const LocalSize& local);

/// Wavelength around the solids, mm; none without a frequency.
std::optional<double> wavelength(const Options& options);

/// The shortest in some of the media, by name, empty: around the solids; none where all of them conduct.
std::optional<double> shortest_wavelength(const Options& options, const std::vector<std::string>& media);

/// The wavelengths in media that are shorter than the target length allows, as lengths of their solids. None without
/// a frequency. Options must have passed check().
std::vector<LocalSize> lengths_in_media(const Options& options);

}  // namespace paver
