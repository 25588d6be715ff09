// Reads the text as OpenCASCADE's reader does, word by word, and keeps nothing but counts.
//
// Tables in order: locations, curves in parameters, curves, polygons, polygons on triangulations, surfaces,
// triangulations, shapes; last the shape that is meant. Shapes name others that come before them, counted from the end.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <string_view>

#include "brep/reading/texts.h"

namespace paver {
namespace {

constexpr double largest_number = 1e101;  // writers put 1e100 and 2e100 for infinity
constexpr int largest_degree = 25, largest_power = 100, deepest = 8;

struct Fault {
  std::string what;
};

/// Kinds of geometry as numbered in the file.
enum Curve { line = 1, circle, ellipse, parabola, hyperbola, bezier, bspline, trimmed, offset };
enum SurfaceKind {
  plane = 1,
  cylinder,
  cone,
  sphere,
  torus,
  extrusion,
  revolution,
  bezier_surface,
  bspline_surface,
  trimmed_surface,
  offset_surface
};

class Text {
 public:
  explicit Text(std::string_view text) : text_(text) {}

  std::string_view line() {
    std::string_view left = text_.substr(at_);
    std::string_view found = left.substr(0, left.find('\n'));
    at_ = std::min(text_.size(), at_ + found.size() + 1);
    if (found.ends_with('\r')) found.remove_suffix(1);
    return found;
  }
  std::string_view word() {
    skip_space();
    std::size_t start = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    if (at_ == start) throw Fault{"the text ends early"};
    return text_.substr(start, at_ - start);
  }
  std::string_view next_word() {
    const std::size_t here = at_;
    std::string_view found = word();
    at_ = here;
    return found;
  }
  void expect(std::string_view wanted) {
    if (word() != wanted) throw Fault{"the word " + std::string(wanted) + " is missing"};
  }
  double real() {
    std::string_view found = word();
    if (found.starts_with('+')) found.remove_prefix(1);
    double value = 0;
    auto [end, error] = std::from_chars(found.data(), found.data() + found.size(), value);
    const bool is_tiny = error == std::errc::result_out_of_range && std::abs(std::strtod(found.data(), nullptr)) < 1;
    if ((error != std::errc() && !is_tiny) || end != found.data() + found.size())
      throw Fault{"there is no number where one must be"};
    if (!(std::abs(value) <= largest_number)) throw Fault{"a number is too large"};
    return value;
  }
  void reals(long count) {
    for (long i = 0; i < count; ++i) real();
  }
  long integer(long least, long most) {
    std::string_view found = word();
    return number(found, least, most);
  }
  static long number(std::string_view found, long least, long most) {
    long value = 0;
    auto [end, error] = std::from_chars(found.data(), found.data() + found.size(), value);
    if (error != std::errc() || end != found.data() + found.size() || value < least || value > most)
      throw Fault{"there is no number from " + std::to_string(least) + " to " + std::to_string(most) +
                  " where one must be"};
    return value;
  }
  bool flag() { return integer(0, 1) == 1; }
  /// Of things that take `bytes` each at least.
  long count(long least = 0, long bytes = 2) {
    return integer(least, static_cast<long>(text_.size() - at_) / bytes + 1);
  }
  /// As "C0", also directly behind a number.
  void continuity(std::string_view found) {
    static constexpr std::string_view known[] = {"C0", "C1", "C2", "C3", "CN", "G1", "G2"};
    if (std::find(std::begin(known), std::end(known), found) == std::end(known)) throw Fault{"a continuity is missing"};
  }
  bool is_at_end() {
    skip_space();
    return at_ == text_.size();
  }
  long line_number() const {
    return 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
  }

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  void skip_space() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

class Checker {
 public:
  explicit Checker(Text& text) : text_(text) {}

  void run() {
    version();
    locations();
    curves_in_parameters_ = table("Curve2ds", [this] { curve(2); });
    curves_ = table("Curves", [this] { curve(3); });
    polygons_ = table("Polygon3D", [this] { polygon(); });
    polygons_on_triangles_ = table("PolygonOnTriangulations", [this] { polygon_on_triangles(); });
    surfaces_ = table("Surfaces", [this] { surface(); });
    triangulations_ = table("Triangulations", [this] { triangulation(); });
    shapes();
  }

 private:
  void version() {
    constexpr std::string_view start = "CASCADE Topology V";
    while (!text_.is_at_end()) {
      std::string_view found = text_.line();
      if (!found.starts_with(start) || found.size() <= start.size()) continue;
      version_ = found[start.size()] - '0';
      if (version_ >= 1 && version_ <= 3) return;
    }
    throw Fault{"its version is missing"};
  }

  template <class Entry>
  long table(std::string_view name, Entry entry) {
    text_.expect(name);
    const long entries = text_.count();
    for (long i = 0; i < entries; ++i) entry();
    return entries;
  }

  void locations() {
    text_.expect("Locations");
    const long entries = text_.count();
    for (; locations_ < entries; ++locations_) {
      if (text_.integer(1, 2) == 1) {
        text_.reals(12);
        continue;
      }
      long powers = 0;
      for (; text_.integer(0, locations_) != 0; ++powers) text_.integer(-largest_power, largest_power);
      if (powers == 0) throw Fault{"a location says nothing"};
    }
  }

  // Geometry. `dimensions`: 2 for curves in parameters, 3 in space.

  void curve(int dimensions, int depth = 0) {
    if (depth > deepest) throw Fault{"a curve is made of too many others"};
    const int axes = dimensions == 2 ? 3 * 2 : 4 * 3;  // of a conic: centre and directions
    switch (text_.integer(line, offset)) {
      case line:
        return text_.reals(2L * dimensions);
      case circle:
      case parabola:
        return text_.reals(axes + 1);
      case ellipse:
      case hyperbola:
        return text_.reals(axes + 2);
      case bezier: {
        const bool is_rational = text_.flag();
        return text_.reals((text_.integer(1, largest_degree) + 1) * (dimensions + is_rational));
      }
      case bspline:
        return spline_curve(dimensions);
      case trimmed:
        text_.reals(2);
        return curve(dimensions, depth + 1);
      default:
        text_.reals(dimensions == 2 ? 1 : 1 + 3);
        return curve(dimensions, depth + 1);
    }
  }

  void spline_curve(int dimensions) {
    const bool is_rational = text_.flag();
    text_.flag();
    const long degree = text_.integer(1, largest_degree);
    const long poles = text_.count(2), knots = text_.count(2);
    for (long i = 0; i < poles; ++i) {
      text_.reals(dimensions);
      if (is_rational) weight();
    }
    knot_row(knots, degree);
  }

  void weight() {
    if (!(text_.real() > 0)) throw Fault{"a weight is not positive"};
  }

  void knot_row(long knots, long degree) {
    double last = -2 * largest_number;
    for (long i = 0; i < knots; ++i) {
      const double knot = text_.real();
      if (!(knot > last)) throw Fault{"knots do not rise"};
      last = knot;
      text_.integer(1, degree + 1);
    }
  }

  void surface(int depth = 0) {
    if (depth > deepest) throw Fault{"a surface is made of too many others"};
    const long kind = text_.integer(plane, offset_surface);
    constexpr int axes = 12;
    switch (kind) {
      case plane:
        return text_.reals(axes);
      case cylinder:
      case sphere:
        return text_.reals(axes + 1);
      case cone:
      case torus:
        return text_.reals(axes + 2);
      case extrusion:
        text_.reals(3);
        return curve(3, depth + 1);
      case revolution:
        text_.reals(6);
        return curve(3, depth + 1);
      case bezier_surface: {
        const bool u_rational = text_.flag(), v_rational = text_.flag();
        const long u = text_.integer(1, largest_degree), v = text_.integer(1, largest_degree);
        return text_.reals((u + 1) * (v + 1) * (3 + (u_rational || v_rational)));
      }
      case bspline_surface:
        return spline_surface();
      case trimmed_surface:
        text_.reals(4);
        return surface(depth + 1);
      default:
        text_.real();
        return surface(depth + 1);
    }
  }

  void spline_surface() {
    const bool u_rational = text_.flag(), v_rational = text_.flag();
    text_.flag();
    text_.flag();
    const long u_degree = text_.integer(1, largest_degree), v_degree = text_.integer(1, largest_degree);
    const long u_poles = text_.count(2), v_poles = text_.count(2), u_knots = text_.count(2), v_knots = text_.count(2);
    for (long i = 0; i < u_poles * v_poles; ++i) {
      text_.reals(3);
      if (u_rational || v_rational) weight();
    }
    knot_row(u_knots, u_degree);
    knot_row(v_knots, v_degree);
  }

  void polygon() {
    const long nodes = text_.count(2);
    const bool has_parameters = text_.flag();
    text_.real();
    text_.reals(nodes * (3 + has_parameters));
  }

  void polygon_on_triangles() {
    const long nodes = text_.count(2);
    for (long i = 0; i < nodes; ++i) text_.count(1);
    text_.expect("p");
    text_.real();
    if (text_.flag()) text_.reals(nodes);
  }

  void triangulation() {
    const long nodes = text_.count(3), triangles = text_.count(1);
    const bool has_parameters = text_.flag(), has_normals = version_ >= 3 && text_.flag();
    text_.real();
    text_.reals(nodes * (has_parameters ? 5 : 3));
    for (long i = 0; i < 3 * triangles; ++i) text_.integer(1, nodes);
    if (has_normals) text_.reals(3 * nodes);
  }

  // Shapes.

  void shapes() {
    text_.expect("TShapes");
    count_ = text_.count(1);
    for (; known_ < count_; ++known_) {
      shape(text_.word());
      flags();
      while (text_.next_word() != "*") use();
      text_.word();
    }
    use();
  }

  void shape(std::string_view kind) {
    if (kind == "Ve") return vertex();
    if (kind == "Ed") return edge();
    if (kind == "Fa") return face();
    for (std::string_view other : {"Wi", "Sh", "So", "CS", "Co"})
      if (kind == other) return;
    throw Fault{"a kind of shape is missing"};
  }

  void flags() {
    std::string_view found = text_.word();
    if (found.size() != 7 || found.find_first_not_of("01") != std::string_view::npos)
      throw Fault{"the properties of a shape are missing"};
  }

  /// Of a shape that is known by then, as "+8 0".
  void use() {
    std::string_view found = text_.word();
    if (std::string_view("+-ie").find(found.front()) == std::string_view::npos) throw Fault{"a shape is missing"};
    Text::number(found.substr(1), count_ - known_ + 1, count_);
    location();
  }

  void location() { text_.integer(0, locations_); }
  void on_surface() {
    text_.integer(1, surfaces_);
    location();
  }

  void tolerance() {
    if (!(text_.real() >= 0)) throw Fault{"a tolerance is negative"};
  }

  void vertex() {
    tolerance();
    text_.reals(3);
    for (;;) {
      text_.real();
      const long kind = text_.integer(0, 3);
      if (kind == 0) return;
      if (kind == 1) text_.integer(1, curves_);
      if (kind == 2) text_.integer(1, curves_in_parameters_);
      if (kind == 3) text_.real();
      if (kind > 1) text_.integer(1, surfaces_);
      location();
    }
  }

  void edge() {
    tolerance();
    for (int i = 0; i < 3; ++i) text_.flag();
    while (representation(text_.integer(0, 7))) {
    }
  }

  /// Of an edge; false when there are no more.
  bool representation(long kind) {
    switch (kind) {
      case 0:
        return false;
      case 1:
        text_.integer(1, curves_);
        location();
        text_.reals(2);
        return true;
      case 2:
      case 3:
        on_face(kind == 3);
        return true;
      case 4:
        text_.continuity(text_.word());
        on_surface();
        on_surface();
        return true;
      case 5:
        text_.integer(1, polygons_);
        location();
        return true;
      default:
        for (long i = 6; i <= kind; ++i) text_.integer(1, polygons_on_triangles_);
        text_.integer(1, triangulations_);
        location();
        return true;
    }
  }

  /// Both sides of a periodic edge: "3 4CN 1 0".
  void on_face(bool is_periodic) {
    text_.integer(1, curves_in_parameters_);
    if (is_periodic) {
      std::string_view second = text_.word();
      const std::size_t digits = std::min(second.find_first_not_of("0123456789"), second.size());
      Text::number(second.substr(0, digits), 1, curves_in_parameters_);
      text_.continuity(digits < second.size() ? second.substr(digits) : text_.word());
    }
    on_surface();
    text_.reals(2);
    if (version_ == 2) text_.reals(4);
  }

  void face() {
    text_.flag();
    tolerance();
    text_.integer(0, surfaces_);  // 0: none
    location();
    if (text_.next_word() != "2") return;
    text_.word();
    text_.integer(1, triangulations_);
  }

  Text& text_;
  int version_ = 0;
  long locations_ = 0, curves_in_parameters_ = 0, curves_ = 0, polygons_ = 0, polygons_on_triangles_ = 0;
  long surfaces_ = 0, triangulations_ = 0;
  long count_ = 0, known_ = 0;  ///< shapes: of the file, and before this one
};

}  // namespace

std::string fault_of_brep(std::string_view text) {
  Text words(text);
  try {
    Checker(words).run();
  } catch (const Fault& fault) {
    return "line " + std::to_string(words.line_number()) + ": " + fault.what;
  }
  return {};
}

}  // namespace paver
