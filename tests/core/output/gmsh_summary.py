"""What Gmsh itself finds in a .msh file, as JSON; used by write_outputs_test.cpp.  gmsh_summary.py MESH"""
import json
import sys

import gmsh

FAMILY = {"Quadrilateral": "quads", "Triangle": "triangles", "Line": "lines"}


def area_of(kind):
    """Area of all elements of one type, by quadrature on the curved elements."""
    points, weights = gmsh.model.mesh.getIntegrationPoints(kind, "Gauss8")
    _, determinants, _ = gmsh.model.mesh.getJacobians(kind, points)
    return sum(d * w for d, w in zip(determinants, list(weights) * (len(determinants) // len(weights))))


def summary(path):
    gmsh.initialize()
    gmsh.option.setNumber("General.Verbosity", 0)
    gmsh.open(path)
    mesh = gmsh.model.mesh
    found = {"nodes": len(mesh.getNodes()[0]), "area": 0, "per_face": {}, "per_edge": {}, "groups": {},
             "sides_of_face": {}}
    for kind, tags, _ in zip(*mesh.getElements()):
        name, dimension, order, *_ = mesh.getElementProperties(kind)
        found[FAMILY[name.split()[0]]] = len(tags)
        found["order"] = order
        if dimension == 2:
            found["area"] += area_of(kind)
    for dimension, entity in gmsh.model.getEntities():
        count = sum(len(t) for t in mesh.getElements(dimension, entity)[1])
        if dimension in (1, 2):
            found["per_face" if dimension == 2 else "per_edge"][entity] = count
        if dimension == 2:
            sides = gmsh.model.getBoundary([(2, entity)], oriented=False)
            found["sides_of_face"][entity] = sorted(tag for _, tag in sides)
    for dimension, group in gmsh.model.getPhysicalGroups():
        name = gmsh.model.getPhysicalName(dimension, group)
        found["groups"][name] = [int(e) for e in gmsh.model.getEntitiesForPhysicalGroup(dimension, group)]
    gmsh.finalize()
    return found


if __name__ == "__main__":
    print(json.dumps(summary(sys.argv[1])))
