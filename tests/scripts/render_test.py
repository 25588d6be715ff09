"""scripts/meshfile.py and scripts/render.py on hand-made meshes."""
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../scripts"))
import meshfile  # noqa: E402
import render  # noqa: E402

ASCII22 = """$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
2 7 "Face1"
$EndPhysicalNames
$Nodes
5
1 0 0 0
2 2 0 0
3 2 2 0
9 0 2 0
4 3 1 0
$EndNodes
$Elements
2
1 3 2 7 1 1 2 3 9
2 2 2 7 1 2 4 3
$EndElements
"""

ASCII41 = """$MeshFormat
4.1 0 8
$EndMeshFormat
$Entities
0 0 1 0
5 0 0 0 1 1 0 1 7 0
$EndEntities
$Nodes
1 4 1 4
2 5 0 4
1
2
3
4
0 0 0
1 0 0
1 1 0
0 1 0
$EndNodes
$Elements
1 1 1 1
2 5 3 1
1 1 2 3 4
$EndElements
"""

# The mesh of ASCII22.
VTU = """<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian"><UnstructuredGrid>
<Piece NumberOfPoints="5" NumberOfCells="2">
<Points><DataArray type="Float64" NumberOfComponents="3">0 0 0 2 0 0 2 2 0 0 2 0 3 1 0</DataArray></Points>
<Cells><DataArray type="Int32" Name="connectivity">0 1 2 3 1 4 2</DataArray>
<DataArray type="Int32" Name="offsets">4 7</DataArray><DataArray type="UInt8" Name="types">9 5</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>
"""


def read_text(text):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "a.msh")
        with open(path, "w") as f:
            f.write(text)
        return meshfile.read(path)


def quads(nodes, rows, order=1):
    none = np.zeros(0, np.int64)
    return meshfile.Mesh(order=order, nodes=np.array(nodes, float), quads=np.array(rows), quad_tag=np.ones(len(rows)),
                         triangles=np.zeros((0, 3 if order == 1 else 6), np.int64), triangle_tag=none,
                         lines=np.zeros((0, order + 1), np.int64), line_tag=none)


class Reading(unittest.TestCase):
    def test_reads_version_2_with_gaps_in_the_numbers(self):
        mesh = read_text(ASCII22)
        self.assertEqual(mesh.quads.tolist(), [[0, 1, 2, 3]])
        self.assertEqual(mesh.triangles.tolist(), [[1, 4, 2]])
        self.assertEqual((mesh.names, mesh.physical), ({(2, 7): "Face1"}, {(2, 1): 7}))

    def test_reads_version_4(self):
        mesh = read_text(ASCII41)
        self.assertEqual((mesh.quads.tolist(), mesh.quad_tag.tolist()), ([[0, 1, 2, 3]], [5]))
        self.assertEqual(mesh.physical, {(2, 5): 7})

    def test_refuses_a_truncated_file(self):
        with self.assertRaises(ValueError):
            read_text(ASCII22[:ASCII22.index("$EndNodes")])

    def test_scaled_jacobian_of_known_shapes(self):
        square, flat = meshfile.scaled_jacobian(read_text(ASCII22))
        self.assertAlmostEqual(square[0], 1)
        self.assertAlmostEqual(flat[0], 2 / np.sqrt(3) * np.sqrt(0.5))


class Drawing(unittest.TestCase):
    def test_the_nearer_of_two_squares_hides_the_other(self):
        square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        kite = [(0, 0), (1, 0), (0.3, 0.3), (0, 1)]  # inverted: magenta
        nodes = [(x, y, 1) for x, y in square] + [(x, y, 0) for x, y in kite]
        mesh = quads(nodes, [[0, 1, 2, 3], [4, 5, 6, 7]])
        for view, hidden in (("z", True), ("-z", False)):
            pixels = np.asarray(render.render(mesh, render.VIEWS[view], (200, 200), edges=False))
            magenta = ((pixels[..., 0] > 200) & (pixels[..., 1] < 30) & (pixels[..., 2] > 200)).sum()
            self.assertEqual(magenta == 0, hidden)

    def test_order_2_sides_are_drawn_curved(self):
        nodes = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (1, -0.5, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 1, 0)]
        image = np.asarray(render.render(quads(nodes, [range(9)], 2), render.VIEWS["z"], (300, 300), edges=False)).astype(int)
        blue = (image[..., 2] > image[..., 0] + 30)[:, :200]
        low = [np.flatnonzero(blue[:, x]).max() for x in (60, 140)]
        self.assertGreater(low[1] - low[0], 10)

    def test_a_large_element_is_filled_without_holes(self):
        mesh = quads([(0, 0, 0), (3, 0, 1), (3, 2, 0), (0, 2, 1)], [[0, 1, 2, 3]])
        image = np.asarray(render.render(mesh, render.VIEWS["z"], (400, 300), edges=False)).astype(int)
        row = np.flatnonzero((image[150] != 255).any(1) & (np.arange(400) < 350))
        self.assertEqual(len(row), row.max() - row.min() + 1)


class Calls(unittest.TestCase):
    """The program as it is called."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = scratch.name
        self.mesh = self.file("a.msh", ASCII22)
        self.picture = os.path.join(self.folder, "a.png")

    def file(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w") as f:
            f.write(text)
        return path

    def call(self, *arguments):
        return subprocess.run([sys.executable, render.__file__, *arguments], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True)

    def drawn(self, mesh, *options):
        """The picture of a mesh, as an array."""
        done = self.call(mesh, self.picture, "--size", "200x150", "--title", "", *options)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with render.Image.open(self.picture) as image:
            return np.asarray(image).astype(int)

    def refused(self, says, *arguments):
        done = self.call(*arguments)
        self.assertNotEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"\Arender: [^\n]*\.\n\Z")
        self.assertIn(says, done.stderr)
        self.assertFalse(os.path.exists(self.picture))

    def test_views_by_name_and_by_angles(self):
        same = {"z": "-90,90", "-x": "180,0", "iso": "-55,28"}
        for name, angles in same.items():
            self.assertTrue((self.drawn(self.mesh, "--view", name) == self.drawn(self.mesh, "--view", angles)).all())
        self.assertFalse((self.drawn(self.mesh, "--view", "iso") == self.drawn(self.mesh, "--view", "z")).all())
        self.drawn(self.mesh, "--at", "-1,-2,-3", "--zoom", "2")

    def test_bad_arguments_are_one_sentence(self):
        paths = self.mesh, self.picture
        for bad in ("top", "30", "1,2,3", "nan,0", "30,x", "--no-edges", ""):
            self.refused(f"there is no view '{bad}'; there are iso, x, y, z, -x, -y, -z and AZIMUTH,ELEVATION", *paths,
                         "--view", bad)
        for bad in ("1600", "0x5", "ax5", "5x6x7", "100000x100000", "5.5x6"):
            self.refused(f"'{bad}' is no size", *paths, "--size", bad)
        for bad in ("1,2", "1,2,inf", "here"):
            self.refused(f"'{bad}' is no point", *paths, "--at", bad)
        for bad in ("0", "-1", "much"):
            self.refused(f"'{bad}' is no enlargement", *paths, "--zoom", bad)

    def test_bad_files_are_one_sentence(self):
        self.refused("none.msh: No such file", os.path.join(self.folder, "none.msh"), self.picture)
        self.refused("none.vtu: No such file", os.path.join(self.folder, "none.vtu"), self.picture)
        self.refused("text.msh", self.file("text.msh", "solid\n"), self.picture)
        self.refused("text.vtu", self.file("text.vtu", "solid\n"), self.picture)
        self.refused("type 21", self.file("b.msh", ASCII22.replace("1 3 2 7 1 ", "1 21 2 7 1 ")), self.picture)
        self.refused("c.msh", self.file("c.msh", ASCII22.replace("2 2 2 7 1 2 4 3\n", "")), self.picture)
        self.refused("a.nonsense", self.mesh, os.path.join(self.folder, "a.nonsense"))
        self.refused("no/a.png: No such file", self.mesh, os.path.join(self.folder, "no", "a.png"))

    def test_vtu_is_drawn_as_msh(self):
        vtu = self.file("a.vtu", VTU)
        self.assertTrue((self.drawn(vtu) == self.drawn(self.mesh)).all())


if __name__ == "__main__":
    unittest.main()
