// Target length on faces: where a surface turns, h is cut so that one element edge turns no more than the limit.
// Boundary edges shorter than h may turn more: what counts is how far they lie off their curve, about length x turn
// / 8. In: model, options. Out: one FaceSize per face. Steps: box of each face in (u, v); largest principal curvature
// on a grid over it; h = limit / curvature, between H / 4 and H (less at limits below 45 degrees); element count
// predicted from area / h^2 and checked against the limit. Known limit: the grid covers the box of the loops, so a
// trimmed-away bend may cut h near it.
#include "sizing/size_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/box.h"
#include "sizing/parts/find_places.h"
#include "sizing/parts/local_counts.h"

namespace paver {
namespace {

constexpr int grid_size = 17;            // samples per direction: enough for a B-spline of about 8 spans
constexpr double smallest_share = 0.25;  // of H inside faces: a tiny fillet must not explode the count
constexpr double usual_turn = M_PI / 4;  // where that is so; a lower limit that is asked for goes as much farther down
constexpr double one_way_turn = 2.5;
constexpr double even_lengths = 1.5;                         // longest by shortest, over a face without a border
constexpr double least_ridge = 0.25;                         // of the diagonal
constexpr double small_face = 6;                             // of h^2
constexpr double least_stretch = 1.12, large_stretch = 1.6;  // of lengths by turns: less is not worth it
constexpr double table_spacing = 0.4;                        // of h: turns sharper than that are spread over it
constexpr double cell_turn = 0.1;         // radians: from one line of the table to the next, where turns are slow
constexpr double most_spacing = 16;       // times table_spacing, there
constexpr double most_normals_apart = 2;  // normals that look opposite ways
constexpr double slope_reach = 0.625;     // of the spacing: derivatives of normals are taken so far to either side
constexpr double large_face = 13500;      // of h^2: about where levels begin
constexpr double chord_turn = 1.25;       // the same for sides as long as h that are straight
constexpr double degenerate_area = 1e-9;  // of the largest |xu x xv| on the face: such a point counts as a pole

struct CurvatureSample {
  Vec3 x, n;
  double area = 0;       // |xu x xv|
  double larger = 0;     // of the principal curvatures
  double curvature = 0;  // the one that limits h, see limiting_curvature(); NaN where it has none
};

// Elements follow the boundary, whose own divisions resolve a strong turn across a fillet, a leading edge or a tube:
// there rows of long elements do. Only where the surface turns strongly both ways must h itself come down; the larger
// curvature alone is allowed `one_way_turn` times the limit.
double limiting_curvature(double larger, double smaller) { return std::max(smaller, larger / one_way_turn); }

// The second fundamental form in an orthonormal tangent basis, the first vector along xu: its eigenvalues are the
// principal curvatures, and equal ones (sphere) come out without cancellation.
CurvatureSample sample_curvature(const Surface& surface, Vec2 uv) {
  const SurfaceJet at = surface.jet(uv);
  CurvatureSample sample;
  sample.area = norm(cross(at.u, at.v));
  Vec3 n = unit(cross(at.u, at.v));
  sample.x = at.x, sample.n = n;
  double square = dot(at.u, at.u), shear = dot(at.u, at.v) / square;
  double uu = dot(n, at.uu), uv_part = dot(n, at.uv), vv = dot(n, at.vv);
  double along = uu / square;
  double mixed = (uv_part - shear * uu) / sample.area;
  double across = (vv - 2 * shear * uv_part + shear * shear * uu) * square / (sample.area * sample.area);
  double half = 0.5 * (along - across);
  double mean = 0.5 * std::abs(along + across), spread = std::sqrt(half * half + mixed * mixed);
  sample.larger = mean + spread;
  sample.curvature = limiting_curvature(sample.larger, std::abs(mean - spread));
  if (!std::isfinite(sample.area)) sample = {at.x, {}, 0, 0, std::numeric_limits<double>::quiet_NaN()};
  return sample;
}

struct SampledFace {
  FaceSize size;
  double mean_density = 0;  // area-weighted mean of 1 / h^2
};

// A straight side lies about length x turn / 8 off the surface, which is what counts (decision turn-of-short-edges).
double limited_size(const CurvatureSample& sample, double h, double turn_limit, bool is_straight) {
  double limited = sample.curvature > 0 ? turn_limit / sample.curvature : h;
  if (is_straight && sample.larger > 0)
    limited = std::min(limited, std::sqrt(chord_turn * turn_limit / sample.larger * h));
  return std::clamp(limited, smallest_share * std::min(turn_limit / usual_turn, 1.0) * h, h);
}

// Poles carry no curvature of their own: they take the smallest h of their neighbours on the grid.
void fill_degenerate(std::vector<double>& sizes, double h) {
  const std::vector<double> known = sizes;
  for (int row = 0; row < grid_size; ++row)
    for (int column = 0; column < grid_size; ++column) {
      double& size = sizes[row * grid_size + column];
      if (!std::isnan(size)) continue;
      size = h;
      for (int r = std::max(0, row - 1); r <= std::min(grid_size - 1, row + 1); ++r)
        for (int c = std::max(0, column - 1); c <= std::min(grid_size - 1, column + 1); ++c)
          size = std::fmin(size, known[r * grid_size + c]);  // the other one where that is NaN
    }
}

/// Largest stretch of lengths by turns, x along rows of samples (u) and y along columns (v); `weight` is what a radian
/// counts, mm.
Vec2 largest_stretch(const std::vector<CurvatureSample>& samples, double weight) {
  auto at = [&](int row, int column) { return samples[row * grid_size + column]; };
  auto stretch = [&](const CurvatureSample& a, const CurvatureSample& b) {
    const double step = norm(b.x - a.x);
    if (a.n == Vec3{} || b.n == Vec3{} || !(step > 0)) return 1.0;
    const double turn = weight * norm(b.n - a.n) / step;
    return std::sqrt(1 + turn * turn);
  };
  Vec2 most{1, 1};
  for (int row = 0; row < grid_size; ++row)
    for (int column = 0; column < grid_size; ++column) {
      if (column + 1 < grid_size) most.x = std::max(most.x, stretch(at(row, column), at(row, column + 1)));
      if (row + 1 < grid_size) most.y = std::max(most.y, stretch(at(row, column), at(row + 1, column)));
    }
  return most;
}

/// Whether lengths differ much over the face, and are shortest along a line across which it bends: not about a tip.
bool has_ridge(const std::vector<CurvatureSample>& samples, const std::vector<double>& sizes) {
  const double least = *std::min_element(sizes.begin(), sizes.end());
  if (!(*std::max_element(sizes.begin(), sizes.end()) > even_lengths * least)) return false;
  Box extent;
  for (const CurvatureSample& sample : samples) extent.add(sample.x);
  auto is_sharp = [&](int i) {
    const CurvatureSample& sample = samples[i];
    return sizes[i] <= even_lengths * least && sample.curvature <= sample.larger / one_way_turn;
  };
  // The longest along a row or a column: about a tip that many lines run up to it is sharp across each of them.
  double longest = 0;
  for (int line = 0; line < grid_size; ++line)
    for (auto [first, step] : {std::array{line * grid_size, 1}, {line, grid_size}}) {
      double length = 0;
      for (int k = 0, i = first; k + 1 < grid_size; ++k, i += step)
        if (is_sharp(i) && is_sharp(i + step)) length += norm(samples[i + step].x - samples[i].x);
      longest = std::max(longest, length);
    }
  return longest > least_ridge * norm(extent.high - extent.low);
}

// Turns count where they matter, and sides can follow them (decision metric); not on large faces that bend gently,
// which are meshed by levels. Faces without a border have layouts for one length, or are cut and paved: with tips at
// both ends, or where a tip or only ridges ask for that, and the face is not so small that a few quads go round it.
bool turns_count(const Model& model, const Face& face, double h, double stretch, int tips,
                 const std::vector<CurvatureSample>& samples, const std::vector<double>& sizes) {
  const bool is_large = face.area > small_face * h * h;
  if (!has_border(model, face) && tips < 2 && !(is_large && (tips > 0 || has_ridge(samples, sizes)))) return false;
  return stretch > (face.area > large_face * h * h ? large_stretch : least_stretch);
}

/// Of a table of normals, mm, so that no turn stretches lengths by more than `aspect`.
double least_spacing(double h, double turn_limit, double aspect) {
  return most_normals_apart * h / turn_limit / std::sqrt(aspect * aspect - 1);
}

/// Of a table's lines in a direction along which turns stretch lengths by so much at most; `weight` as there.
double line_spacing(double spacing, double stretch, double weight) {
  const double turn = std::sqrt(stretch * stretch - 1) / weight;  // radians per mm
  return turn * most_spacing * spacing > cell_turn ? std::max(spacing, cell_turn / turn) : most_spacing * spacing;
}

SampledFace sample_face(const Model& model, const Face& face, double h, double turn_limit, int tips,
                        const Options& options) {
  SampledFace flat{FaceSize(h), 1 / (h * h)};
  if (!face.surface || face.surface->kind() == SurfaceKind::plane) return flat;
  SampleBox box = sample_box(model, face);
  if (!box.has_area()) return flat;

  std::vector<CurvatureSample> samples;
  double largest_area = 0;
  for (int row = 0; row < grid_size; ++row) {
    for (int column = 0; column < grid_size; ++column) {
      double a = static_cast<double>(column) / (grid_size - 1), b = static_cast<double>(row) / (grid_size - 1);
      samples.push_back(sample_curvature(*face.surface, box.at(a, b)));
      largest_area = std::max(largest_area, samples.back().area);
    }
  }
  std::vector<double> sizes;
  for (const CurvatureSample& sample : samples) {
    bool is_degenerate = !std::isfinite(sample.curvature) || sample.area <= degenerate_area * largest_area;
    sizes.push_back(is_degenerate ? std::numeric_limits<double>::quiet_NaN()
                                  : limited_size(sample, h, turn_limit, options.order == 1));
  }
  fill_degenerate(sizes, h);

  const double weight = h / turn_limit;
  const Vec2 stretch = largest_stretch(samples, weight);
  if (options.aspect > 1 && turns_count(model, face, h, std::max(stretch.x, stretch.y), tips, samples, sizes)) {
    const double least = least_spacing(h, turn_limit, options.aspect), spacing = std::max(table_spacing * h, least);
    const Vec2 apart{line_spacing(spacing, stretch.x, weight), line_spacing(spacing, stretch.y, weight)};
    const auto normals =
        std::make_shared<const NormalTable>(*face.surface, box, apart, slope_reach * spacing, spacing == least);
    flat.mean_density *= normals->stretched_area(weight);
    flat.size.count_turns(1 / turn_limit, normals);
    return flat;
  }
  double area = 0, density = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    area += samples[i].area;
    density += samples[i].area / (sizes[i] * sizes[i]);
  }
  return {FaceSize(h, box, grid_size, std::move(sizes)), area > 0 ? density / area : flat.mean_density};
}

double perimeter(const Model& model, const Face& face) {
  double sum = 0;
  for (const Coedge& coedge : coedges_of(face.loops)) sum += edge_of(model, coedge).length;
  return sum;
}

/// In target lengths, as lengths count turns of the face.
double turned_perimeter(const Model& model, const Face& face, const FaceSize& size) {
  constexpr int steps = 24;
  double sum = 0;
  for (const Coedge& coedge : coedges_of(face.loops)) {
    const Edge& edge = edge_of(model, coedge);
    Vec3 last;
    for (int i = 0; coedge.pcurve && i <= steps; ++i) {
      const Vec3 normal = size.normals()->at(coedge.pcurve->uv(edge.t0 + (edge.t1 - edge.t0) * i / steps));
      if (i > 0) sum += std::hypot(edge.length / (steps * size.own()), size.turn_weight() * norm(normal - last));
      last = normal;
    }
    if (!coedge.pcurve) sum += edge.length / size.own();
  }
  return sum;
}

// A strip narrower than h still gets an element per h of its length: half the perimeter counts as well as the area.
// Turns make elements narrow, not short.
double predicted_elements(const Model& model, const Face& face, const SampledFace& sampled) {
  const bool has_turns = sampled.size.turn_weight() > 0;
  const double along = has_turns ? 1 / sampled.size.own() : std::sqrt(sampled.mean_density);
  return std::max({1.0, face.area * sampled.mean_density, 0.5 * perimeter(model, face) * along - 1});
}

/// Where what is divided finely, as a hole beside an edge, would meet long intervals. Not for LocalSizes itself, which
/// say before that what is to be merged.
std::vector<SizeSource> fine_borders(const Model& model, const Options& options, double h, const LocalSizes& local) {
  const TurnLimit limit = turn_limit(options, h);
  auto interval = [&](const Edge& edge, double t) {
    return std::min({h, local.on_edge(edge), edge.length, limit.longest_edge(curvature(*edge.curve, t))});
  };
  std::vector<SizeSource> pieces = find_fine_borders(model, interval, options.gradation);
  std::erase_if(pieces, [h](const SizeSource& piece) { return piece.value >= h; });
  return pieces;
}

// Lengths that are given for whole faces; none is longer than the face, whose turns were lost on it otherwise.
void give_local(const Model& model, const Options& options, const std::vector<SizeSource>& places, SizeField& field) {
  const auto local = std::make_shared<LocalSizes>(model, options, field.h);
  local->add(places);
  local->add(fine_borders(model, options, field.h, *local));
  field.local = local;
  for (std::size_t f = 0; f < model.faces.size(); ++f)
    field.face_h.push_back(
        std::min({field.h, local->on_face(static_cast<int>(f)), face_extent(model, model.faces[f])}));
}

void add_turning_sides(const Face& face, int index, SizeField& field) {
  for (const Coedge& coedge : coedges_of(face.loops))
    if (coedge.pcurve) field.turning[coedge.edge].push_back({index, coedge.pcurve});
}

void check_predicted(double predicted, double h, long limit, bool is_local) {
  if (predicted <= static_cast<double>(limit)) return;
  const double enough = h * std::sqrt(predicted / static_cast<double>(limit));
  throw Error(ErrorCode::too_many_elements,
              fmt::format("About {:.3g} elements are predicted at target length {:.6g} mm{}, above the limit of {}; "
                          "choose {}, a larger max_turn, or raise max_elements.",
                          predicted, h, is_local ? " and the local ones" : "", limit,
                          is_local ? "longer ones" : fmt::format("a target length of {:.3g} mm or more", enough)),
              {"sizing", -1, -1, std::nullopt});
}

}  // namespace

FaceSize FaceSize::scaled(double factor) const {
  FaceSize result = *this;
  result.h_ *= factor;
  result.scale_ *= factor;
  for (double& sample : result.samples_) sample *= factor;
  return result;
}

FaceSize FaceSize::at_most(double h) const {
  FaceSize result = *this;
  result.h_ = std::min(h_, h);
  for (double& sample : result.samples_) sample = std::min(sample, h);
  return result;
}

double FaceSize::least() const {
  return samples_.empty() ? h_ : std::min(h_, *std::min_element(samples_.begin(), samples_.end()));
}

double FaceSize::by_curvature(Vec2 uv) const {
  if (samples_.empty()) return h_;
  // Written so that NaN lands on 0: a size is always given back.
  auto position = [this](double value, double lo, double hi) {
    double share = (value - lo) / (hi - lo) * (side_ - 1);
    return share > 0 ? std::min(share, static_cast<double>(side_ - 1)) : 0.0;
  };
  double a = position(uv.x, box_.lo.x, box_.hi.x), b = position(uv.y, box_.lo.y, box_.hi.y);
  int i = std::min(static_cast<int>(a), side_ - 2), j = std::min(static_cast<int>(b), side_ - 2);
  a -= i;
  b -= j;
  const double* low = &samples_[j * side_ + i];
  const double* high = low + side_;
  return (1 - b) * ((1 - a) * low[0] + a * low[1]) + b * ((1 - a) * high[0] + a * high[1]);
}

TurnLimit SizeField::turn_limit_of(const Edge& edge) const {
  const bool is_inside = edge.faces.size() == 2 && edge.faces[0] == edge.faces[1];
  return {h, turn_limit, is_inside ? 0 : short_turn_limit};
}

SizeField build_size_field(const Model& model, const Options& options, Progress& progress,
                           const std::vector<SizeSource>& places) {
  progress.begin(Stage::sizing, static_cast<long>(model.faces.size()));
  SizeField field;
  field.h = target_length(options);
  field.gradation = options.gradation;
  const TurnLimit limit = turn_limit(options, field.h);
  field.turn_limit = limit.usual, field.short_turn_limit = limit.of_short;
  if (!options.max_turn) field.small_bend = options.merge;
  give_local(model, options, places, field);
  field.turning.resize(model.edges.size());
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    const Face& face = model.faces[f];
    bool is_meshed = face.is_meshed();
    SampledFace sampled = is_meshed ? sample_face(model, face, field.face_h[f], field.turn_limit,
                                                  field.local->tips_of(static_cast<int>(f)), options)
                                    : SampledFace{FaceSize(field.h), 0};
    field.perimeter.push_back(sampled.size.turn_weight() > 0 ? turned_perimeter(model, face, sampled.size)
                                                             : perimeter(model, face) / field.face_h[f]);
    if (is_meshed && !field.local->is_empty()) {
      sampled.size.set_local(field.local, sample_box(model, face));
      LocalCounts counts = count_with_local(model, face, sampled.size, field);
      sampled.size.set_local(field.local, counts.near);
      sampled.mean_density += counts.more_density;
      field.perimeter.back() = counts.perimeter;
      sampled.size.set_graded(counts.is_graded);
    }
    field.predicted.push_back(is_meshed ? predicted_elements(model, face, sampled) : 0);
    field.faces.push_back(std::move(sampled.size));
    if (field.faces.back().turn_weight() > 0) add_turning_sides(face, static_cast<int>(f), field);
    progress.advance();
  }
  double predicted = std::accumulate(field.predicted.begin(), field.predicted.end(), 0.0);
  check_predicted(predicted, field.h, options.max_elements, !options.local.empty() || !places.empty());
  return field;
}

}  // namespace paver
