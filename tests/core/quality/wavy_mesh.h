// A mesh with curved quads and triangles made in code, of any order, as smooth or as torn as wanted.
#pragma once

#include <cmath>
#include <random>

#include "paver/result.h"
#include "quality/jacobian/lattice.h"

namespace paver::fake {

/// n x n cells of 10 mm on a wavy sheet; two faces, left and right of edge 4; edges 0 to 3 around them. Every fifth
/// cell is two triangles. Nodes are moved at random by up to `noise` mm. Coordinates are multiples of 2^-20 mm, so that
/// the mesh is the same with every library of sines.
class WavyMesh {
 public:
  WavyMesh(int order, int n, double noise) : p_(order), n_(n), width_(n * order + 1) {
    mesh_.order = order;
    add_nodes(noise);
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) add_cell(i, j);
    }
    for (int k = 0; k < n; ++k) {
      add_line(0, k, 0, 1, 0), add_line(1, n, k, 0, 1), add_line(2, k, n, 1, 0), add_line(3, 0, k, 0, 1);
      add_line(4, n / 2, k, 0, 1);
    }
  }

  MeshResult result() const {
    MeshResult result;
    result.mesh = mesh_;
    result.face_names = {"left \"wing\"", "Face2"};
    result.report.faces.resize(2);
    result.report.faces[0].name = "Face1";
    result.report.faces[1].name = "Face2";
    return result;
  }

 private:
  int node(int i, int j) const { return j * width_ + i; }

  static double rounded(double x) { return std::round(x * 1048576) / 1048576; }

  void add_nodes(double noise) {
    std::mt19937 random(7);  // its numbers are the same everywhere
    auto shift = [&] { return noise * (static_cast<double>(random()) / 2147483648.0 - 1); };
    double step = 10.0 / p_;
    for (int j = 0; j < width_; ++j) {
      for (int i = 0; i < width_; ++i) {
        double x = step * i, y = step * j;
        mesh_.nodes.push_back({rounded(x + 3 * std::sin(y / 9) + shift()), rounded(y + 2 * std::sin(x / 7) + shift()),
                               rounded(8 * std::sin(x / 20) * std::cos(y / 30) + shift())});
        int edge = j == 0 ? 0 : j == width_ - 1 ? 2 : i == width_ - 1 ? 1 : i == 0 ? 3 : i == n_ / 2 * p_ ? 4 : -1;
        mesh_.node_edge.push_back(edge);
      }
    }
  }

  void add_cell(int i, int j) {
    int face = i < n_ / 2 ? 0 : 1, a = i * p_, b = j * p_;
    if ((i + 2 * j) % 5 != 0) {
      for (auto [u, v] : lagrange_nodes(ElementShape::quad, p_)) mesh_.quads.push_back(node(a + u, b + v));
      mesh_.quad_face.push_back(face);
      return;
    }
    for (auto [u, v] : lagrange_nodes(ElementShape::triangle, p_)) mesh_.triangles.push_back(node(a + u + v, b + v));
    for (auto [u, v] : lagrange_nodes(ElementShape::triangle, p_)) mesh_.triangles.push_back(node(a + u, b + u + v));
    mesh_.triangle_face.insert(mesh_.triangle_face.end(), 2, face);
  }

  void add_line(int edge, int i, int j, int di, int dj) {
    for (int k : {0, p_}) mesh_.lines.push_back(node(i * p_ + k * di, j * p_ + k * dj));
    for (int k = 1; k < p_; ++k) mesh_.lines.push_back(node(i * p_ + k * di, j * p_ + k * dj));
    mesh_.line_edge.push_back(edge);
  }

  int p_, n_, width_;
  SurfaceMesh mesh_;
};

}  // namespace paver::fake
