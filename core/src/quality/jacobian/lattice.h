// Lattices of Lagrange nodes and Bernstein coefficients on the reference square and triangle.
#pragma once

#include <utility>
#include <vector>

#include "quality/jacobian/dense.h"
#include "quality/jacobian/jacobian.h"

namespace paver {

/// Integer steps (i, j) from 0 to the degree; (u, v) = (i, j) / degree.
using LatticePoint = std::pair<int, int>;

/// Lagrange nodes of order p in Gmsh's order: corners, inner nodes of each side in turn, then the inside likewise.
std::vector<LatticePoint> lagrange_nodes(ElementShape shape, int p);

/// Bernstein coefficients of one degree: by rising i, then j; the triangle has those with i + j <= degree.
std::vector<LatticePoint> bernstein_lattice(ElementShape shape, int degree);

/// Where (i, j) lies in bernstein_lattice.
int bernstein_index(ElementShape shape, int degree, int i, int j);

/// Number of coefficients as a real number's binomial: degree over i.
long double binomial(int degree, int i);

/// Value at (u, v) of the Bernstein polynomial (i, j) of a degree; for the square it is a product of two.
long double bernstein(ElementShape shape, int degree, LatticePoint index, long double u, long double v);

/// Derivatives of the same by u and v.
std::pair<long double, long double> bernstein_slope(ElementShape shape, int degree, LatticePoint index, long double u,
                                                    long double v);

/// Control points of an element, in the order of bernstein_lattice, from its nodes, in that of lagrange_nodes.
Dense node_to_control(ElementShape shape, int order);

/// Points and weights of the n-point Gauss-Legendre rule on [0, 1].
std::vector<std::pair<double, double>> gauss_rule(int n);

}  // namespace paver
