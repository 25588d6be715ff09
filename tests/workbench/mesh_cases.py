"""Mesh objects in documents. Run inside FreeCAD: freecadcmd -t TestPaver."""
import importlib
import os
import tempfile
import unittest
from unittest import mock

import FreeCAD
import numpy as np
import Part

from paver_wb import core, mesh_object, meshing, properties
from paver_wb.formats import fem_mesh, mesh_file

BOX = (10, 20, 30)


class InDocument(unittest.TestCase):
    """A document with a box."""

    def setUp(self):
        self.document = FreeCAD.newDocument("PaverTest", hidden=True)
        self.document.UndoMode = 1
        self.box = self.add("Part::Box", Length=BOX[0], Width=BOX[1], Height=BOX[2])
        self.document.recompute()
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)
        self.folder.cleanup()

    def add(self, kind, inside=None, placement=FreeCAD.Placement(), **values):
        thing = self.document.addObject(kind, kind.split(":")[-1])
        for name, value in values.items():
            setattr(thing, name, value)
        thing.Placement = placement
        if inside:
            inside.addObject(thing)
        return thing

    def reopen(self):
        path = os.path.join(self.folder.name, "model.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path, hidden=True)
        return path

    def expect_same_mesh(self, stored, result):
        for name in mesh_file.ARRAYS:
            np.testing.assert_array_equal(getattr(stored, name), getattr(result, name), name)

    def expect_fem_mesh(self, obj):
        """FemMesh has every element and node of what is kept, and a group for each face."""
        stored, fem = mesh_object.stored(obj), obj.FemMesh
        self.assertEqual(fem.QuadrangleCount, len(stored.quads))
        self.assertEqual(fem.TriangleCount, len(stored.triangles))
        rows = fem_mesh.serendipity(stored)
        for number, row in enumerate([r for kind in rows for r in kind], 1):
            points = [tuple(fem.getNodeById(n)) for n in fem.getElementNodes(number)]
            np.testing.assert_array_equal(points, stored.nodes[row])
        faces = np.concatenate([stored.quad_faces, stored.triangle_faces])
        groups = {fem.getGroupName(g): set(fem.getGroupElements(g)) for g in fem.Groups}
        number = len(faces)
        for name, lines in mesh_file.wires(stored).items():
            members = range(number + 1, number + 1 + len(lines))
            for member, row in zip(members, lines):
                points = [tuple(fem.getNodeById(n)) for n in fem.getElementNodes(member)]
                np.testing.assert_array_equal(points, stored.nodes[row])
            self.assertEqual(groups.pop(name), set(members))
            number += len(lines)
        self.assertEqual(groups, {stored.face_names[f]: set(np.flatnonzero(faces == f) + 1) for f in set(faces)})


class Properties(InDocument):
    def test_every_option_of_the_core_is_a_property(self):
        obj = mesh_object.add(self.document, self.box)
        self.assertEqual({n for n in obj.PropertiesList if properties.is_option(obj, n)},
                         {properties.property_name(info["name"]) for info in core.load().options()}
                         - set(mesh_object.PROPERTIES))
        for info in core.load().options():
            name = properties.property_name(info["name"])
            self.assertIn(info["help"], obj.getDocumentationOfProperty(name))
            if info["kind"] == "choice":
                self.assertEqual(obj.getEnumerationsOfProperty(name), info["choices"])
        for name in mesh_object.PROPERTIES:
            self.assertTrue(obj.getDocumentationOfProperty(name), name)

    def test_only_what_is_set_is_given(self):
        obj = mesh_object.add(self.document, self.box)
        for option in ("size", "frequency", "max_turn", "sew_tolerance", "divisions"):
            self.assertNotIn(option, properties.given(obj))
        obj.SewTolerance = 0  # never sew: a value of its own
        self.assertEqual(properties.given(obj)["sew_tolerance"], 0)
        properties.put(obj, {"frequency": "9 GHz", "divisions": "8", "max_turn": "0.5 rad", "order": "1"})
        given = properties.given(obj)
        self.assertEqual((given["frequency"], given["divisions"], given["order"]), (9e9, 8.0, 1))
        self.assertAlmostEqual(given["max_turn"], 28.6478897565)
        self.assertEqual(obj.Frequency.getValueAs("GHz").Value, 9)
        properties.put(obj, {"size": "1 in"})
        self.assertEqual((obj.Size.Value, obj.Frequency.Value), (25.4, 0))
        properties.put(obj, {"frequency": 1e9})
        self.assertEqual((obj.Size.Value, obj.Frequency.Value), (0, 1e9))

    def test_a_flag_is_a_property_that_is_on_or_off(self):
        obj = mesh_object.add(self.document, self.box)
        self.assertIs(obj.Strict, False)
        for value, kept in ((True, True), ("off", False), ("on", True), (None, False)):
            properties.put(obj, {"strict": value})
            self.assertIs(obj.Strict, kept)
            self.assertIs(properties.given(obj)["strict"], kept)
        with self.assertRaisesRegex(ValueError, "^strict is 'perhaps'"):
            properties.put(obj, {"strict": "perhaps"})

    def test_ranks_are_kept_and_refused_where_the_core_has_none(self):
        obj = mesh_object.add(self.document, self.box, size=5)
        self.assertEqual(obj.Ranks, 0)
        obj.Ranks = 2
        self.reopen()
        obj = self.document.getObject("PaverMesh")
        self.assertEqual(obj.Ranks, 2)
        if not properties.has_ranks():
            self.assertIn("Hidden", obj.getEditorMode("Ranks"))
            with self.assertRaisesRegex(ValueError, "set its property Ranks to 0"):
                meshing.mesh(obj)
            obj.Ranks = 0
            meshing.mesh(obj)

    def test_the_link_has_the_name_of_later_versions_too(self):
        is_old = FreeCAD.Version()[0] == "0"
        self.assertEqual("Shape" not in mesh_object.add(self.document, self.box).PropertiesList, is_old)
        real = mesh_object.needs_shape_link
        self.addCleanup(setattr, mesh_object, "needs_shape_link", real)
        mesh_object.needs_shape_link = lambda: True
        obj = mesh_object.add(self.document, self.box, size=5)
        meshing.mesh(obj)
        ball = self.add("Part::Sphere")
        self.assertEqual((obj.Shape, obj.Status), (self.box, "Up to date"))
        obj.Part = ball
        self.assertEqual((obj.Shape, obj.Status), (ball, "Out of date"))
        names = obj.Name, ball.Name
        self.reopen()
        obj, ball = map(self.document.getObject, names)
        self.assertEqual((obj.Shape, obj.Part), (ball, ball))
        self.assertIn("Hidden", obj.getEditorMode("Shape"))

    def test_bad_options_are_refused_in_one_sentence(self):
        for options, word in (({"sise": 3}, "sise"), ({"order": "two"}, "order"), ({"size": "3 kg"}, "size"),
                              ({"elements": "hexahedra"}, "elements")):
            before = len(self.document.Objects)
            with self.assertRaisesRegex(ValueError, word):
                mesh_object.add(self.document, self.box, **options)
            self.assertEqual(len(self.document.Objects), before)

    def test_an_older_object_gets_the_options_it_lacks(self):
        obj = mesh_object.add(self.document, self.box, size=5)
        obj.removeProperty("Gradation")
        obj.removeProperty("Watertight")
        self.reopen()
        obj = self.document.getObject("PaverMesh")
        self.assertAlmostEqual(obj.Gradation, 0.6)
        self.assertFalse(obj.Watertight)


class Meshing(InDocument):
    def test_mesh_is_what_the_core_makes(self):
        paver = core.load()
        for options in ({"size": 4}, {"size": 4, "order": 1}, {"frequency": 9e9, "elements": "all-triangle"}):
            obj = mesh_object.add(self.document, self.box, **options)
            result = meshing.mesh(obj)
            self.assertEqual(result.report["checksum"], paver.mesh(self.box, **options).report["checksum"])
            self.expect_same_mesh(mesh_object.stored(obj), result)
            self.expect_fem_mesh(obj)
            self.assertEqual((obj.Quads, obj.Triangles, obj.Nodes),
                             (len(result.quads), len(result.triangles), len(result.nodes)))
            self.assertEqual((obj.Status, obj.Watertight, obj.FailedFaces), ("Up to date", True, []))
            self.assertEqual(obj.WorstScaledJacobian, result.report["quality"]["sj"]["all"]["min"])
            self.assertEqual(obj.TargetLength.Value, result.report["target_length"])

    def test_wires_are_lines_with_a_group(self):
        self.box.Length = 10
        wire = self.document.addObject("Part::Feature", "Wire")
        wire.Shape = Part.makeLine(FreeCAD.Vector(5, 5, 10), FreeCAD.Vector(5, 5, 40))
        self.document.recompute()
        for parts, order in (([self.box, wire], 2), ([wire], 1)):
            obj = mesh_object.add(self.document, parts, size=5, order=order)
            meshing.mesh(obj)
            self.expect_fem_mesh(obj)
            self.assertEqual(obj.FemMesh.EdgeCount, obj.Lines)
            self.assertGreater(obj.Lines, 5)

    def test_points_are_nodes_with_a_group(self):
        self.box.Length = 10
        feed = self.document.addObject("Part::Feature", "Feed")
        feed.Shape = Part.Vertex(FreeCAD.Vector(3, 5, BOX[2]))
        self.document.recompute()
        obj = mesh_object.add(self.document, [self.box, feed], size=5)
        meshing.mesh(obj)
        self.reopen()
        obj, = mesh_object.meshes_of(self.document)
        meshing.fill(obj)
        groups = {obj.FemMesh.getGroupName(i): obj.FemMesh.getGroupElements(i) for i in obj.FemMesh.Groups}
        self.assertEqual([obj.FemMesh.Nodes[node] for node in groups["Feed"]], [FreeCAD.Vector(3, 5, BOX[2])])

    def test_the_radius_of_wires_leaves_the_mesh_as_it_is(self):
        obj = mesh_object.add(self.document, self.box, size=5)
        meshing.mesh(obj)
        obj.WireRadius = 0.5
        self.document.recompute()
        self.assertEqual(obj.Status, "Up to date")
        self.reopen()
        self.assertEqual([mesh.WireRadius.Value for mesh in mesh_object.meshes_of(self.document)], [0.5])

    def test_the_first_mesh_hides_its_model(self):
        obj = mesh_object.add(self.document, self.box, size=5)
        self.assertTrue(self.box.Visibility)
        meshing.mesh(obj)
        self.assertFalse(self.box.Visibility)
        self.box.Visibility = True
        meshing.mesh(obj)
        self.assertTrue(self.box.Visibility)

    def test_a_model_inside_a_part_is_not_hidden(self):
        whole = self.document.addObject("App::Part", "Whole")
        whole.addObject(self.box)
        self.document.recompute()
        meshing.mesh(mesh_object.add(self.document, self.box, size=5))
        self.assertTrue(self.box.Visibility)
        self.assertEqual(len(meshing.mesh(mesh_object.add(self.document, whole, size=5)).face_names), 6)

    def test_triangles_and_quads_together(self):
        prism = self.add("Part::Prism", Polygon=3, Circumradius=10, Height=7)
        self.document.recompute()
        obj = mesh_object.add(self.document, prism, size=50)
        meshing.mesh(obj)
        self.assertGreater(min(obj.Quads, obj.Triangles), 0)
        self.expect_fem_mesh(obj)

    def test_results_are_read_only(self):
        obj = mesh_object.add(self.document, self.box)
        for name, (_, group, _, modes) in mesh_object.PROPERTIES.items():
            if name != mesh_object.RANKS or properties.has_ranks():
                self.assertEqual(obj.getEditorMode(name), list(modes))
            self.assertEqual(bool(modes), group == mesh_object.RESULT, name)

    def test_several_objects_where_they_stand(self):
        outer = FreeCAD.Placement(FreeCAD.Vector(100, 0, 0), FreeCAD.Rotation(FreeCAD.Vector(0, 0, 1), 30))
        group = self.add("App::Part", placement=outer)
        ball = self.add("Part::Sphere", group, FreeCAD.Placement(FreeCAD.Vector(0, 50, 0), FreeCAD.Rotation()))
        link = self.add("App::Link", LinkedObject=self.box,
                        placement=FreeCAD.Placement(FreeCAD.Vector(0, 0, 200), FreeCAD.Rotation()))
        self.document.recompute()
        obj = mesh_object.add(self.document, [self.box, ball, link], size=5)
        meshing.mesh(obj)
        stored = mesh_object.stored(obj)
        names = [stored.face_names[f] for f in stored.quad_faces]
        self.assertEqual(set(names), {f"Box_Face{i}" for i in range(1, 7)} | {"Sphere_Face1"} |
                         {f"{link.Name}_Face{i}" for i in range(1, 7)})
        corners = stored.nodes[stored.quads[[n == "Sphere_Face1" for n in names], :4]].reshape(-1, 3)
        centre = outer.multVec(FreeCAD.Vector(0, 50, 0))
        np.testing.assert_allclose(np.linalg.norm(corners - np.array(tuple(centre)), axis=1), ball.Radius.Value)
        self.assertAlmostEqual(stored.nodes[:, 2].max(), 230)
        whole = mesh_object.add(self.document, group, size=5)
        self.assertEqual(len(meshing.mesh(whole).face_names), 1)

    def test_above_the_limit_on_demand_only(self):
        preferences = FreeCAD.ParamGet(mesh_object.PREFERENCES)
        preferences.SetInt("FillLimit", 10)
        self.addCleanup(preferences.RemInt, "FillLimit")
        obj = mesh_object.add(self.document, self.box, size=4)
        meshing.mesh(obj)
        self.assertEqual((obj.FemMeshFilled, obj.FemMesh.NodeCount), (False, 0))
        meshing.fill(obj)
        self.assertTrue(obj.FemMeshFilled)
        self.expect_fem_mesh(obj)
        self.document.undo()
        self.assertEqual((obj.FemMeshFilled, obj.FemMesh.NodeCount), (False, 0))

    def test_errors_and_cancel_leave_the_object_as_it_was(self):
        paver = core.load()
        obj = mesh_object.add(self.document, self.box, size=5)
        first = meshing.mesh(obj)
        obj.MaxElements = 3
        self.assertRaises(paver.LimitError, meshing.mesh, obj)
        obj.MaxElements = 10000
        self.assertRaises(paver.Cancelled, meshing.mesh, obj, progress=lambda *_: False)
        obj.Frequency = 1e9
        self.assertRaises(paver.OptionError, meshing.mesh, obj)
        self.expect_same_mesh(mesh_object.stored(obj), first)
        obj.Part = None
        with self.assertRaisesRegex(paver.InputError, "set its property Part"):
            meshing.mesh(obj)
        with self.assertRaisesRegex(ValueError, "mesh it first"):
            mesh_object.stored(mesh_object.add(self.document, self.box))

    def test_a_face_that_fails_is_named_and_the_others_are_kept(self):
        shape = Part.makeCompound([Part.makePlane(1, 1), Part.Plane().toShape()])
        faulty = self.add("Part::Feature", Shape=shape)
        obj = mesh_object.add(self.document, faulty, size=0.3)
        meshing.mesh(obj)
        self.assertEqual([text.split(":")[0] for text in obj.FailedFaces], ["Face2"])
        self.assertGreater(obj.Quads, 0)


class Keeping(InDocument):
    def test_undo_and_redo(self):
        obj = mesh_object.add(self.document, self.box, size=10)
        coarse = meshing.mesh(obj)
        obj.Size = 4
        fine = meshing.mesh(obj)
        self.assertGreater(len(fine.quads), len(coarse.quads))
        self.document.undo()
        self.expect_same_mesh(mesh_object.stored(obj), coarse)
        self.expect_fem_mesh(obj)
        self.assertEqual(obj.Quads, len(coarse.quads))
        self.document.redo()
        self.expect_same_mesh(mesh_object.stored(obj), fine)
        self.expect_fem_mesh(obj)
        self.document.undo()
        self.document.undo()
        self.assertEqual((obj.MeshFile, obj.FemMesh.NodeCount, obj.Status), ("", 0, "Not meshed"))

    def test_save_and_reopen(self):
        obj = mesh_object.add(self.document, self.box, size=4)
        result = meshing.mesh(obj)
        path = self.reopen()
        obj = self.document.getObject("PaverMesh")
        self.assertEqual(type(obj.Proxy), mesh_object.MeshProxy)
        self.expect_same_mesh(mesh_object.stored(obj), result)
        self.expect_fem_mesh(obj)
        self.assertEqual((obj.Status, obj.Part.Name, obj.Size.Value), ("Up to date", "Box", 4))
        self.assertEqual(mesh_object.stored(obj).report["checksum"], result.report["checksum"])
        import zipfile
        names = zipfile.ZipFile(path).namelist()
        self.assertEqual([n for n in names if n.endswith(".unv")], [], "FemMesh is not stored")
        meshing.mesh(obj)
        self.expect_same_mesh(mesh_object.stored(obj), result)

    def test_copies_have_a_mesh_of_their_own(self):
        obj = mesh_object.add(self.document, self.box, size=10)
        result = meshing.mesh(obj)
        copy = self.document.copyObject(obj)
        self.expect_same_mesh(mesh_object.stored(copy), result)
        obj.Size = 4
        meshing.mesh(obj)
        self.expect_same_mesh(mesh_object.stored(copy), result)
        self.expect_fem_mesh(copy)
        again = self.document.copyObject(copy)
        self.document.removeObject(copy.Name)
        self.expect_same_mesh(mesh_object.stored(again), result)
        self.reopen()
        kept = [mesh_object.stored(thing) for thing in mesh_object.meshes_of(self.document)]
        self.assertEqual(sorted(len(mesh.quads) for mesh in kept)[0], len(result.quads))
        self.assertEqual(len({len(mesh.quads) for mesh in kept}), 2)

    def test_the_module_path_in_documents_stays(self):
        for name, module in (("MeshProxy", "paver_wb.mesh_object"),):
            self.assertTrue(isinstance(getattr(importlib.import_module(module), name), type))
        proxy = mesh_object.MeshProxy.__new__(mesh_object.MeshProxy)
        self.assertEqual((proxy.dumps(), proxy.__getstate__(), proxy.Type), (None, None, "Paver::Mesh"))

    def test_files_that_are_not_packed_are_read(self):
        obj = mesh_object.add(self.document, self.box, size=10)
        result = meshing.mesh(obj)
        path = os.path.join(self.folder.name, "plain.paver")
        with mock.patch.object(mesh_file, "pack", lambda array: (array.tobytes(), None)):
            mesh_file.write(mesh_file.read(obj.MeshFile), path)
        self.expect_same_mesh(mesh_file.read(path), result)
        self.assertLess(os.path.getsize(obj.MeshFile) - os.path.getsize(path), 200)

    def test_damaged_files_are_refused(self):
        obj = mesh_object.add(self.document, self.box, size=10)
        meshing.mesh(obj)
        with open(obj.MeshFile, "rb") as file:
            whole = file.read()
        path = os.path.join(self.folder.name, "damaged.paver")
        flipped = whole[:-20] + bytes([whole[-20] ^ 1]) + whole[-19:]
        for content in (b"", whole[:50], whole[:-8], whole[:-8 * 40], flipped, b"x" * 400):
            with open(path, "wb") as file:
                file.write(content)
            with self.assertRaisesRegex(mesh_file.DamagedMesh, "mesh the object again"):
                mesh_file.read(path)


class Status(InDocument):
    def test_options_that_matter(self):
        obj = mesh_object.add(self.document, self.box, size=5)
        self.assertEqual(obj.Status, "Not meshed")
        meshing.mesh(obj)
        for name, value in (("Size", 6), ("Order", 1), ("Elements", "all-quad"), ("SewTolerance", 0)):
            before = getattr(obj, name)
            setattr(obj, name, value)
            self.assertEqual(obj.Status, "Out of date", name)
            setattr(obj, name, before)
            self.assertEqual(obj.Status, "Up to date", name)
        obj.Threads, obj.Divisions = 1, 7  # divisions: only with a frequency
        self.assertEqual(obj.Status, "Up to date")

    def test_shapes(self):
        group = self.add("App::Part")
        group.addObject(self.box)
        ball = self.add("Part::Sphere")
        self.document.recompute()
        obj = mesh_object.add(self.document, self.box, size=5)
        meshing.mesh(obj)
        self.document.recompute()
        self.assertEqual(obj.Status, "Up to date")
        self.box.Length = 11
        self.document.recompute()
        self.assertEqual(obj.Status, "Out of date")
        quads = obj.Quads
        self.box.Length = BOX[0]
        self.document.recompute()
        self.assertEqual(obj.Status, "Up to date")
        obj.MoreParts = [ball]
        self.assertEqual(obj.Status, "Out of date")
        self.document.recompute()
        self.assertEqual((obj.Status, obj.Quads), ("Out of date", quads), "recompute does not mesh")
        obj.MoreParts = []
        self.document.recompute()
        self.assertEqual(obj.Status, "Up to date")
        group.Placement.Base.x = 5
        self.document.recompute()
        self.assertEqual(mesh_object.check(obj), "Out of date")
        meshing.mesh(obj)
        self.assertEqual(obj.Status, "Up to date")

    def test_shapes_are_only_handed_over_when_they_are_other_ones(self):
        from paver import _shapes
        made, real = [], _shapes.binary
        self.addCleanup(setattr, _shapes, "binary", real)
        _shapes.binary = lambda shape: made.append(shape) or real(shape)
        group = self.add("App::Part", placement=FreeCAD.Placement(FreeCAD.Vector(3, 0, 0), FreeCAD.Rotation(1, 2, 3)))
        inner = self.add("Part::Sphere", group, FreeCAD.Placement(FreeCAD.Vector(50, 0, 0), FreeCAD.Rotation(4, 5, 6)))
        link = self.add("App::Link")
        link.LinkedObject = self.box
        link.LinkPlacement.Base.y = 70
        self.document.recompute()
        for parts in ([self.box], [group, self.box], [inner, link]):
            obj = mesh_object.add(self.document, parts, size=5)
            meshing.mesh(obj)
            mesh_object.check(obj)  # from here on they are known
            made.clear()
            for _ in range(3):
                obj.touch()
                self.document.recompute()
                self.assertEqual(mesh_object.check(obj), "Up to date")
            self.assertEqual(made, [])
            for thing in parts:
                thing.Placement.Base.z += 1
                self.document.recompute()
                self.assertEqual((mesh_object.check(obj), len(made)), ("Out of date", 1), thing.Name)
                thing.Placement.Base.z -= 1
                self.document.recompute()
                self.assertEqual((mesh_object.check(obj), len(made)), ("Up to date", 2), thing.Name)
                made.clear()
            parts[0].touch()
            inner.Radius, self.box.Length = inner.Radius.Value + 1, self.box.Length.Value + 1
            self.document.recompute()
            self.assertEqual(mesh_object.check(obj), "Out of date")
            self.document.removeObject(obj.Name)

    def test_shapes_that_files_keep_with_fewer_digits(self):
        group = self.add("App::Part", placement=FreeCAD.Placement(FreeCAD.Vector(1 / 3, 0, 0), FreeCAD.Rotation(1, 2, 3)))
        ball = self.add("Part::Sphere", group, FreeCAD.Placement(FreeCAD.Vector(50 / 7, 0, 0), FreeCAD.Rotation(4, 5, 6)))
        fixed = self.document.addObject("Part::Feature", "Fixed")
        ball.Radius = 10 / 3
        self.document.recompute()
        fixed.Shape = ball.Shape.fuse(self.box.Shape)
        names = [mesh_object.add(self.document, part, size=5).Name for part in (fixed, group)]
        for name in names:
            meshing.mesh(self.document.getObject(name))
        for _ in range(2):
            self.reopen()
            for name in names:
                obj = self.document.getObject(name)
                obj.touch()
                self.document.recompute()
                self.assertEqual(mesh_object.check(obj), "Up to date", name)
        fixed, group = self.document.Fixed, self.document.getObject(names[1]).Part
        group.Placement.Base.z = 1  # which FreeCAD does not report; saving looks
        self.reopen()
        fixed, obj = self.document.Fixed, self.document.getObject(names[0])
        self.assertEqual(self.document.getObject(names[1]).Status, "Out of date")
        self.assertEqual(mesh_object.check(self.document.getObject(names[1])), "Out of date")
        shape = fixed.Shape
        fixed.Shape = shape.scaled(1.0001)
        self.assertEqual(mesh_object.check(obj), "Out of date")
        fixed.Shape = shape
        self.assertEqual(mesh_object.check(obj), "Up to date")
        meshing.mesh(obj)
        self.assertEqual(mesh_object.check(obj), "Up to date")

    def test_reopened_documents_know_it(self):
        obj = mesh_object.add(self.document, self.box, size=5)
        meshing.mesh(obj)
        obj.Size = 6
        self.reopen()
        obj = self.document.getObject("PaverMesh")
        self.assertEqual(obj.Status, "Out of date")
        obj.Size = 5
        self.assertEqual(obj.Status, "Up to date")
        self.document.Box.Length = 99
        self.document.recompute()
        self.assertEqual(obj.Status, "Out of date")
