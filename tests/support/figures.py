"""Figures of a mesh file by numpy, and of its model by Gmsh, as JSON:  figures.py MESH MODEL TARGET-LENGTH

They stand beside those of Paver's report, with which they share no code.
"""
import json
import os
import sys

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import runs  # noqa: E402
import meshfile  # noqa: E402
import render  # noqa: E402

NODES_PER_FACE = 400  # of those whose distance to the model is looked at


def determinants(mesh, rows, weights, s, t):
    """Per element and point (s, t): x_u x x_v along the element's own direction. Differences of polynomials of degree 2
    in each variable are exact."""
    x = mesh.nodes[rows]
    along = [np.einsum("wk,ekc->ewc", weights(*up, mesh.order) - weights(*down, mesh.order), x)
             for up, down in (((s + 0.5, t), (s - 0.5, t)), ((s, t + 0.5), (s, t - 0.5)))]
    normals = np.cross(*along)
    mean = normals.mean(1)
    return np.einsum("ewc,ec->ew", normals, mean / np.linalg.norm(mean, axis=1, keepdims=True)), normals


def gauss(count):
    """Points and weights on the unit square."""
    x, w = np.polynomial.legendre.leggauss(count)
    s, t = np.meshgrid((x + 1) / 2, (x + 1) / 2)
    return s.ravel(), t.ravel(), np.outer(w, w).ravel() / 4


def area(mesh):
    s, t, w = gauss(8)
    total = 0.0
    if len(mesh.quads):
        _, normals = determinants(mesh, mesh.quads, render.quad_weights, s, t)
        total += (np.linalg.norm(normals, axis=2) @ w).sum()
    if len(mesh.triangles):  # the square folded on the triangle
        _, normals = determinants(mesh, mesh.triangles, render.triangle_weights, s * (1 - t), t)
        total += (np.linalg.norm(normals, axis=2) @ (w * (1 - t))).sum()
    return total


def inverted(mesh):
    """Elements with a determinant not above 0 in a grid of points."""
    s, t = (g.ravel() for g in np.meshgrid(*[np.linspace(0, 1, 9)] * 2))
    in_triangle = s + t <= 1 + 1e-12
    found = 0
    for rows, weights, of in ((mesh.quads, render.quad_weights, s >= 0),
                              (mesh.triangles, render.triangle_weights, in_triangle)):
        if len(rows):
            found += int((determinants(mesh, rows, weights, s[of], t[of])[0] <= 0).any(1).sum())
    return found


def edge_figures(mesh, size):
    """Lengths, border and valence. What divides faces is an edge between elements of different ones: seams do not."""
    sides, tags = runs.directed_sides(mesh)
    edges, number, uses = np.unique(runs.edge_keys(sides), axis=0, return_inverse=True, return_counts=True)
    number = number.ravel()
    lowest, highest = np.full(len(edges), tags.max()), np.zeros(len(edges), np.int64)
    np.minimum.at(lowest, number, tags)
    np.maximum.at(highest, number, tags)
    divides = (uses != 2) | (lowest != highest)
    valence = np.bincount(edges[:, :2].ravel(), minlength=len(mesh.nodes))
    valence[np.unique(edges[divides, :2])] = 0
    length = np.linalg.norm(mesh.nodes[edges[:, 1]] - mesh.nodes[edges[:, 0]], axis=1)
    return {"border edges": int((uses == 1).sum()),
            "irregular share": float((valence[valence > 0] != 4).mean()) if valence.any() else 0.0,
            "length mean": length.mean() / size, "length CV": length.std() / length.mean()}


def of_mesh(mesh, size):
    sj = np.concatenate(meshfile.scaled_jacobian(mesh))
    return {"quads": len(mesh.quads), "triangles": len(mesh.triangles), "SJ min": sj.min(), "SJ mean": sj.mean(),
            "SJ share < 0.3": (sj < 0.3).mean(), "mesh area": area(mesh), "inverted": inverted(mesh),
            **edge_figures(mesh, size)}


def distance(points, dimension, tag):
    import gmsh
    closest, _ = gmsh.model.getClosestPoint(dimension, tag, points.ravel())
    return np.linalg.norm(np.reshape(closest, (-1, 3)) - points, axis=1)


def off_face(points, tag):
    """Largest distance of points from the surface of a face or a curve around it: these may differ a little."""
    import gmsh
    off = distance(points, 2, tag)
    for _, edge in gmsh.model.getBoundary([(2, tag)], combined=False, oriented=False):
        far = off > 1e-6
        if far.any() and gmsh.model.occ.getMass(1, edge) > 0:  # a pole has no curve
            off[far] = np.minimum(off[far], distance(points[far], 1, edge))
    return off.max()


def nodes_of_face(mesh, tag, corners_only):
    """Some nodes of the elements that name a face."""
    of_face = [rows[tags == tag][:, :corners if corners_only else None].ravel() for rows, tags, corners in (
        (mesh.quads, mesh.quad_tag, 4), (mesh.triangles, mesh.triangle_tag, 3))]
    nodes = np.unique(np.concatenate(of_face))
    return mesh.nodes[nodes[::-(-len(nodes) // NODES_PER_FACE) or 1]]


def of_model(model, mesh):
    """Its area, and the largest distance of corners and of all nodes from the face that their elements name."""
    import gmsh
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setString("Geometry.OCCTargetUnit", "MM")
    gmsh.model.occ.importShapes(model)
    gmsh.model.occ.synchronize()
    faces = [tag for _, tag in gmsh.model.getEntities(2)]
    empty = set(faces) - set(mesh.quad_tag) - set(mesh.triangle_tag)
    off = [max(off_face(nodes_of_face(mesh, tag, corners_only), tag) for tag in faces if tag not in empty)
           for corners_only in (True, False)]
    found = {"CAD area": sum(gmsh.model.occ.getMass(2, tag) for tag in faces), "corners off the model": off[0],
             "nodes off the model": off[1], "faces without elements": len(empty)}
    gmsh.finalize()
    return found


def main():
    mesh = meshfile.read(sys.argv[1])
    found = {**of_mesh(mesh, float(sys.argv[3])), **of_model(sys.argv[2], mesh)}
    print(json.dumps({name: float(value) for name, value in found.items()}))


if __name__ == "__main__":
    main()
