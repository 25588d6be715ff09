"""Media, ports and wires: in arrays, files and the report, the same on any number of ranks."""
import importlib.util
import json
import subprocess
import sys

import pytest

import paver

# In a process of its own, as it brings another CAD kernel along.
SCRIPT = """import sys, json, gmsh
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.open(sys.argv[1])
names = [(dim, gmsh.model.getPhysicalName(dim, tag)) for dim, tag in gmsh.model.getPhysicalGroups()]
sides = gmsh.model.getBoundary(gmsh.model.getEntities(3), combined=False, oriented=True)
print(json.dumps({"names": names, "sides": [tag for _, tag in sides]}), flush=True)
"""


def options():
    return {"size": 8, "medium": {"FR4": {"parts": "Solid1", "eps_r": 4.4, "tan_d": 0.02}},
            "port": {"Feed": ["Edge1", "Vertex8"], "Load": "Face2"}, "wire": {"Mast": {"parts": ["Edge7"], "radius": "0.5 mm"}}}


def test_dicts_are_the_texts_of_the_command_line(example):
    model = paver.Model(example("box.step"))
    one = paver.mesh(model, **options())
    other = paver.mesh(model, size=8, medium="FR4=Solid1,eps-r:4.4,tan-d:0.02", wire="Mast=Edge7,radius:0.5",
                       port=["Feed=Edge1,Vertex8", "Load=Face2"])
    for result in (one, other):
        assert result.face_groups[1] == "Load" and result.face_groups.count("Load") == 1
        assert [group for group in result.edge_groups if group] == ["Feed", "Mast"]
        assert result.point_names == ["Feed"]
        assert result.volumes == [("Solid1", "FR4", [1, 2, 3, 4, 5, 6])]
        assert result.report["media"] == [{"name": "FR4", "parts": ["Solid1"], "eps_r": 4.4, "mu_r": 1.0, "tan_d": 0.02,
                                           "conductor": False}]
        assert {face["back_medium"] for face in result.report["faces"]} == {"FR4"}
        assert result.report["wires"] == [{"name": "Mast", "parts": ["Edge7"], "radius": 0.5}]
    assert one.report["checksum"] == other.report["checksum"]
    assert (one.quads == paver.mesh(model, size=8).quads).all(), "names change no element"


@pytest.mark.parametrize("version, ascii", [("4.1", True), ("4.1", False), ("2.2", True), ("2.2", False)])
def test_files_have_the_groups(example, tmp_path, version, ascii):
    if importlib.util.find_spec("gmsh") is None:
        pytest.skip("without gmsh")
    result = paver.mesh(example("box.step"), **options())
    result.write(tmp_path / "box.msh", msh_version=version, ascii=ascii)
    again = paver.SurfaceMesh(result.order, result.nodes, result.quads, result.triangles, result.quad_faces,
                              result.triangle_faces, result.lines, result.line_edges, result.points)
    again.write(tmp_path / "again.msh", msh_version=version, ascii=ascii, face_names=[
        group or name for group, name in zip(result.face_groups, result.face_names)], edge_names=result.edge_names,
        edge_groups=result.edge_groups, point_names=result.point_names, volumes=result.volumes)
    assert (tmp_path / "again.msh").read_bytes() == (tmp_path / "box.msh").read_bytes()
    found = json.loads(subprocess.run([sys.executable, "-c", SCRIPT, tmp_path / "box.msh"], check=True,
                                      capture_output=True, text=True).stdout.splitlines()[-1])
    names = {tuple(entry) for entry in found["names"]}
    assert {(2, "Load"), (1, "Feed"), (1, "Mast"), (0, "Feed")} <= names
    if version == "4.1":
        assert (3, "FR4") in names
        assert sorted(found["sides"]) == [1, 2, 3, 4, 5, 6]


@pytest.mark.parametrize("ranks", [2])
def test_ranks_write_the_same_bytes(example, tmp_path, ranks):
    if not any(info["name"] == "ranks" for info in paver.options()):
        pytest.skip("built without MPI")
    paver.mesh(example("box.step"), output=tmp_path / "one.msh", **options())
    paver.mesh(example("box.step"), output=tmp_path / "more.msh", ranks=ranks, **options())
    assert (tmp_path / "one.msh").read_bytes() == (tmp_path / "more.msh").read_bytes()
