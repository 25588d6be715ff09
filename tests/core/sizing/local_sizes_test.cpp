#include "sizing/parts/local_sizes.h"

#include <gtest/gtest.h>

#include <random>

#include "boundary/edge_metric.h"
#include "paver/error.h"
#include "sizing/size_field.h"
#include "support/fake_model.h"

namespace paver {
namespace {

/// Images of a plane's edges.
void add_images(Model& model, Face& face) {
  const SurfaceSlope at = face.surface->slope({0, 0});
  auto uv = [&](int vertex) {
    Vec3 d = model.vertices[static_cast<std::size_t>(vertex)] - at.x;
    return Vec2{dot(d, at.u) / dot(at.u, at.u), dot(d, at.v) / dot(at.v, at.v)};
  };
  for (Coedge& coedge : coedges_of(face.loops)) {
    const Edge& edge = model.edges[static_cast<std::size_t>(coedge.edge)];
    coedge.pcurve = fake::straight_image(edge.t0, edge.t1, uv(edge.start), uv(edge.end));
  }
}

/// Numbered as models that were read are.
Model numbered_box(double a, double b, double c) {
  Model model = fake::box(a, b, c);
  for (Face& face : model.faces) add_images(model, face);
  for (std::size_t f = 0; f < model.faces.size(); ++f) model.faces[f].origin = static_cast<int>(f);
  for (std::size_t e = 0; e < model.edges.size(); ++e) model.edges[e].origins = {static_cast<int>(e)};
  model.read_edges = static_cast<int>(model.edges.size());
  model.read_vertices = model.vertices;
  model.read_faces = static_cast<int>(model.faces.size());
  model.solid_faces = {{0, 1, 2, 3, 4, 5}};
  return model;
}

Options with_local(double h, std::vector<LocalSize> local) {
  Options options;
  options.size = h;
  options.local = std::move(local);
  return options;
}

SizeField size_of(const Model& model, const Options& options) {
  Progress progress;
  return build_size_field(model, options, progress);
}

std::string refusal(const std::string& part) {
  Model model = numbered_box(10, 10, 10);
  try {
    size_of(model, with_local(2, {{part, 1.0}}));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_option);
    return error.what();
  }
  return "";
}

TEST(LocalSizes, HoldOnWiresWithoutAnyFace) {
  fake::Builder builder;
  builder.line(builder.vertex({0, 0, 0}), builder.vertex({10, 0, 0}));
  Model model = builder.take();
  model.edges[0].origins = {0};
  model.read_edges = 1;
  Options options;
  options.size = 2;
  EXPECT_EQ(LocalSizes(model, options, 2).on_edge(model.edges[0]), std::numeric_limits<double>::infinity());
  options.local.push_back({"Edge1", 0.5, 1, 1});
  EXPECT_EQ(LocalSizes(model, options, 2).on_edge(model.edges[0]), 0.5);
}

TEST(LocalSizes, AFaceHasItsLengthAndItsNeighboursGrowFromTheirCommonEdge) {
  Model model = numbered_box(100, 100, 100);
  SizeField field = size_of(model, with_local(20, {{"Face1", 1.0}}));
  EXPECT_EQ(field.face_h[0], 1);
  for (Vec2 uv : {Vec2{0, 0}, Vec2{33, 70}, Vec2{100, 100}})
    EXPECT_DOUBLE_EQ(field.faces[0].at(uv, *model.faces[0].surface), 1);
  for (const Edge& edge : model.edges) {
    bool is_of_face = std::find(edge.faces.begin(), edge.faces.end(), 0) != edge.faces.end();
    EXPECT_EQ(field.local->on_edge(edge) == 1, is_of_face);
  }
  for (std::size_t f = 1; f < 6; ++f) EXPECT_EQ(field.face_h[f], 20);
}

TEST(LocalSizes, GrowByTheGradationAndNeverAboveTheTargetLength) {
  Model model = numbered_box(100, 100, 100);
  Options options = with_local(20, {{"Vertex1", 0.5}, {"Edge7", 2.0}});
  options.gradation = 0.4;
  SizeField field = size_of(model, options);
  std::mt19937 random(3);
  auto number = [&] { return std::uniform_real_distribution<double>(0, 100)(random); };
  for (std::size_t f = 0; f < 6; ++f) {
    const Surface& surface = *model.faces[f].surface;
    for (int i = 0; i < 300; ++i) {
      Vec2 p{number(), number()}, q{number(), number()};
      double a = field.faces[f].at(p, surface), b = field.faces[f].at(q, surface);
      EXPECT_LE(std::abs(a - b), 0.4 * norm(surface.point(p) - surface.point(q)) + 1e-12);
      EXPECT_LE(a, 20);
      EXPECT_LE(a, 0.5 + 0.4 * norm(surface.point(p) - model.vertices[0]) + 1e-12);
    }
  }
  EXPECT_NEAR(field.given_at(model.edges[0], model.vertices[0]), 0.5, 1e-12);
}

TEST(LocalSizes, ASolidIsItsFacesAndTheLeastOfSeveralCounts) {
  Model model = numbered_box(10, 10, 10);
  SizeField field = size_of(model, with_local(5, {{"Solid1", 2.0}, {"Face2", 1.0}, {"Face2", 3.0}}));
  EXPECT_EQ(field.face_h, (std::vector<double>{2, 1, 2, 2, 2, 2}));
}

TEST(LocalSizes, AMediumTakesTheWavelengthInIt) {
  Options options;
  options.frequency = 3e9;
  options.local = {{"Solid1", std::nullopt, 4.0, 1.0}};
  check(options);
  EXPECT_NEAR(local_length(options, options.local[0]), 0.5 * target_length(options), 1e-12);
}

TEST(LocalSizes, PartsThatAreNotThereAreRefusedWithWhatIs) {
  EXPECT_EQ(refusal("Face7"), "local names Face7, but the model has Face1 to Face6; name one of these.");
  EXPECT_EQ(refusal("Edge13"), "local names Edge13, but the model has Edge1 to Edge12; name one of these.");
  EXPECT_EQ(refusal("Vertex9"), "local names Vertex9, but the model has Vertex1 to Vertex8; name one of these.");
  EXPECT_EQ(refusal("Solid2"), "local names Solid2, but the model has only Solid1; name that.");
  EXPECT_EQ(refusal("Solid1"), "");
}

TEST(LocalSizes, OneThatIsNotShorterIsNoted) {
  Model model = numbered_box(10, 10, 10);
  EXPECT_EQ(size_of(model, with_local(2, {{"Face1", 1.0}})).local->notes().size(), 0u);
  SizeField field = size_of(model, with_local(2, {{"Face1", 3.0}}));
  ASSERT_EQ(field.local->notes().size(), 1u);
  EXPECT_EQ(field.local->notes()[0], "The length 3 mm of Face1 has no effect: the target length is 2 mm.");
  EXPECT_EQ(field.face_h[0], 2);
}

// From h0 the length grows as h0 + g s: the integral of ds / h has a closed form.
TEST(LocalSizes, AnEdgeIsDividedByTheIntegralOverTheLengthsAskedFor) {
  Model model = numbered_box(1000, 10, 10);
  const double h0 = 0.01, g = 0.6, h = 50, until = (h - h0) / g;
  SizeField field = size_of(model, with_local(h, {{"Vertex1", h0}}));
  for (const Edge& edge : model.edges) {
    if (edge.length < 1000 || (edge.start != 0 && edge.end != 0)) continue;
    EdgeMetric metric(edge, field);
    EXPECT_NEAR(metric.weight(), std::log(h / h0) / g + (1000 - until) / h, 0.02 * metric.weight());
    double at = edge.start == 0 ? 0 : 1000;
    EXPECT_NEAR(metric.size_at_length(at), h0, 1e-12);
  }
}

TEST(LocalSizes, ArePartOfThePredictionAndOfTheLimit) {
  Model model = numbered_box(100, 100, 100);
  SizeField plain = size_of(model, with_local(10, {})), field = size_of(model, with_local(10, {{"Face1", 1.0}}));
  EXPECT_NEAR(plain.predicted[0], 100, 1e-9);
  EXPECT_NEAR(field.predicted[0], 10000, 1e-6);
  EXPECT_FALSE(field.faces[0].is_graded());
  double with_neighbours = 0, without = 0;
  for (std::size_t f = 0; f < 6; ++f) with_neighbours += field.predicted[f], without += plain.predicted[f];
  EXPECT_GT(with_neighbours, without - 100 + 10000 + 4 * 100);  // rows beside each common edge
  Options options = with_local(10, {{"Face1", 1.0}});
  options.max_elements = 5000;
  EXPECT_THROW(size_of(model, options), Error);
}

/// Square plate of side 100 with n x n square holes of side 2 at equal distances.
Model perforated(int n) {
  fake::Builder builder;
  std::vector<std::vector<Coedge>> loops;
  auto add_square = [&](Vec3 at, double side, bool is_hole) {
    const int first = builder.vertex(at);
    for (Vec3 to : {Vec3{side, 0, 0}, Vec3{side, side, 0}, Vec3{0, side, 0}}) builder.vertex(at + to);
    std::vector<Coedge>& loop = loops.emplace_back();
    for (int i = 0; i < 4; ++i) {
      const Coedge coedge = builder.use(builder.line(first + i, first + (i + 1) % 4), is_hole);
      loop.insert(is_hole ? loop.begin() : loop.end(), coedge);
    }
  };
  add_square({}, 100, false);
  const double pitch = 100.0 / n;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) add_square({(i + 0.5) * pitch - 1, (j + 0.5) * pitch - 1, 0}, 2, true);
  builder.face(std::make_shared<fake::Plane>(Vec3{}, Vec3{1, 0, 0}, Vec3{0, 1, 0}), 1e4, loops);
  Model model = builder.take();
  for (Face& face : model.faces) add_images(model, face), face.origin = 0;
  for (std::size_t e = 0; e < model.edges.size(); ++e) model.edges[e].origins = {static_cast<int>(e)};
  model.read_edges = static_cast<int>(model.edges.size());
  return model;
}

TEST(LocalSizes, HolesNearerToEachOtherThanHGiveTheirSidesLength) {
  Options options;
  auto at_hole = [&](int holes, double h) {
    options.size = h;
    const double corner = 50.0 / holes - 1;
    return LocalSizes(perforated(holes), options, h).at({corner, corner, 0}, h);
  };
  EXPECT_NEAR(at_hole(10, 12), 2, 1e-9);
  EXPECT_EQ(at_hole(10, 9), 9) << "10 apart";
  EXPECT_EQ(at_hole(10, 3.9), 3.9);
  EXPECT_EQ(at_hole(5, 12), 12) << "20 apart";
  EXPECT_NEAR(at_hole(2, 200), 2, 1e-9) << "the face is smaller than h";
  EXPECT_EQ(at_hole(1, 200), 200) << "a single hole";
}

}  // namespace
}  // namespace paver
