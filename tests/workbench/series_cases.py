"""Series of meshes of one mesh object. Run inside FreeCAD: freecadcmd -t TestPaver."""
import os

import FreeCAD

from mesh_cases import InDocument
from paver_wb import core, mesh_check, mesh_object, meshing, properties, refinement, series
from paver_wb.children import named_parts


class SeriesOfMeshes(InDocument):
    def add_mesh(self, *parts, **options):
        mesh = mesh_object.add(self.document, list(parts) or self.box, **(options or {"frequency": "60 GHz", "divisions": 2}))
        self.document.clearUndos()
        return mesh

    def table(self, obj):
        return [(step.text, row and row.elements) for step, row in zip(series.steps_of(obj), series.rows_of(obj))]

    def test_values_are_lists_ranges_and_texts(self):
        for option, given, wanted in (
                ("frequency", "2 GHz, 1GHz; 1e9,", [1e9, 2e9]), ("frequency", ["1 GHz", 4e9], [1e9, 4e9]),
                ("frequency", "1GHz:4GHz:3", [1e9, 2.5e9, 4e9]), ("frequency", "1GHz : 4GHz : 3 : log", [1e9, 2e9, 4e9]),
                ("divisions", "6, 8, 10:14:3", [6, 8, 10, 12, 14]), ("size", ["1 cm", 2], [2, 10]),
                ("size", [FreeCAD.Units.Quantity("1 in")], [25.4])):
            self.assertEqual(series.values_of(option, given), wanted, given)
        for option, given in (("frequency", "3 mm"), ("divisions", "x"), ("divisions", "-6"),
                              ("size", ""), ("size", []), ("size", [float("nan")]), ("divisions", "6:8:1"), ("divisions", "8:6:3"),
                              ("divisions", "6:8:x"), ("divisions", "6:8:3:lin"), ("divisions", "1:2:201")):
            with self.assertRaisesRegex(ValueError, r"^[A-Z].*\.$", msg=given):
                series.values_of(option, given)

    def test_steps_are_meshes_with_the_options_and_refinements_of_theirs(self):
        mesh = self.add_mesh(frequency="60 GHz", divisions=2, order=1, elements="all-triangle")
        refinement.make(mesh, ["Face1"], "1 mm")
        refinement.make(mesh, ["Face2"], eps_r=4)
        named_parts.make_port(mesh, ["Face3"], name="Feed")
        obj = series.run(mesh, frequencies="30 GHz, 60 GHz")
        self.assertEqual([child.Status for child in obj.Meshes], ["Up to date"] * 2)
        for child, row, frequency in zip(obj.Meshes, series.rows_of(obj), (30e9, 60e9)):
            alone = properties.given(child)
            self.assertEqual(alone, {**properties.given(mesh), "frequency": frequency})
            self.assertEqual(refinement.decisive(child), refinement.decisive(mesh))
            self.assertEqual(named_parts.decisive(child), named_parts.decisive(mesh), "under the same names")
            self.assertEqual((row.elements, row.verdict), (child.Triangles, mesh_check.verdict(mesh_check.check(child))))
            self.assertAlmostEqual(row.least_sj, child.WorstScaledJacobian, 9)
        self.assertEqual((mesh.Status, mesh.Part.Visibility), ("Not meshed", True))
        self.assertEqual(mesh_object.stored(obj.Meshes[1]).report["checksum"], meshing.mesh(mesh).report["checksum"])

    def test_a_step_that_fails_is_a_row_that_says_why(self):
        mesh = self.add_mesh(size=5)
        obj = series.run(mesh, sizes=[0.001, "5 mm", 10])
        first, *others = series.rows_of(obj)
        self.assertIn("elements are predicted", first.error)
        self.assertFalse(first.is_meshed)
        self.assertEqual([row.error for row in others], ["", ""])
        self.assertEqual([child.Status for child in obj.Meshes], ["Not meshed", "Up to date", "Up to date"])

    def test_it_is_saved_undone_and_deleted(self):
        mesh = self.add_mesh()
        obj = series.run(mesh, divisions=[2, 3])
        table = self.table(obj)
        self.assertEqual(self.document.UndoNames, ["Mesh Series 3 / λ", "Mesh Series 2 / λ", "Series of PaverMesh"])
        self.document.undo()
        self.assertEqual(self.table(obj), [table[0], (table[1][0], None)])
        self.document.redo()
        self.assertEqual(self.table(obj), table)
        self.reopen()
        obj, = series.of_document(self.document)
        self.assertEqual((self.table(obj), obj.Mesh.Name), (table, "PaverMesh"))
        self.assertEqual([child.Status for child in obj.Meshes], ["Up to date"] * 2)
        self.assertEqual(series.mesh_of(obj, 1).Divisions, 3)
        self.document.removeObject(obj.Meshes[0].Name)
        self.assertEqual((series.mesh_of(obj, 0), series.mesh_of(obj, 1).Divisions), (None, 3))
        self.document.UndoMode = 1
        mesh = mesh_object.meshes_of(self.document)[0]
        series.add(mesh, divisions=[2, 3])
        count = len(self.document.Objects)
        self.document.undo()
        self.assertEqual(len(self.document.Objects), count - 3)

    def test_files_only_leave_no_mesh_in_the_document(self):
        mesh, count = self.add_mesh(), len(self.document.Objects)
        obj = series.run(mesh, divisions="2, 3", formats=["msh", "inp"], folder=self.folder.name)
        self.assertEqual((len(self.document.Objects), obj.Meshes), (count + 1, []))
        stem = f"{self.document.Name}-{mesh.Name}"
        wanted = {f"{stem}-divisions{n}.{ending}" for n in (2, 3) for ending in ("msh", "inp")}
        self.assertEqual(set(os.listdir(self.folder.name)), wanted | {stem + "-series.csv"})
        self.assertEqual({os.path.basename(file) for row in series.rows_of(obj) for file in row.files}, wanted)

    def test_a_file_that_cannot_be_written_is_told_in_its_row(self):
        mesh = self.add_mesh()
        obj = series.add(mesh, divisions=[2, 3], formats=["msh", "inp"], folder=self.folder.name)
        os.mkdir(os.path.join(self.folder.name, f"{self.document.Name}-{mesh.Name}-divisions2.msh"))
        rows = [done.row for done in series.work(obj)]
        self.assertTrue(rows[0].is_meshed and rows[0].error and not rows[0].files)
        self.assertEqual((len(rows[1].files), rows[1].error), (2, ""))

    def test_a_stop_keeps_what_is_done_and_the_rest_may_be_done_later(self):
        obj, cancel = series.add(self.add_mesh(), divisions=[2, 3, 4]), core.load().Cancel()
        for _ in series.work(obj, cancel=cancel):
            cancel.set()
        self.assertEqual([bool(row) for row in series.rows_of(obj)], [True, False, False])
        self.assertEqual([done.step.value for done in series.work(obj)], [3, 4])
        self.assertTrue(all(series.rows_of(obj)))

    def test_rows_of_before_a_change_are_none_to_rely_on_and_are_done_again(self):
        mesh = self.add_mesh(size=5)
        for formats in ([], ["msh"]):
            obj = series.run(mesh, sizes=[5, 10], formats=formats, folder=self.folder.name if formats else "")
            self.assertEqual((self.verdicts(obj), series.steps_to_do(obj)), ([mesh_check.GOOD] * 2, []))
            table = self.table(obj)
            self.box.Length = 40
            self.document.recompute()
            self.assertEqual(self.verdicts(obj), [mesh_check.WARNING] * 2)
            self.assertIn("this row is of before", series.rows_of(obj)[0].reason)
            self.assertEqual(len(list(series.work(obj))), 2, "no table of two models")
            self.assertEqual(self.verdicts(obj), [mesh_check.GOOD] * 2)
            self.assertNotEqual(self.table(obj), table)
            self.box.Length = 10
            self.document.recompute()
        mesh.Order = 1
        self.assertEqual(self.verdicts(obj), [mesh_check.WARNING] * 2)

    def test_rows_are_those_of_the_model_when_it_is_opened_again(self):
        mesh = self.add_mesh(self.add("Part::Sphere", Radius=10 / 3), size=2)
        self.document.recompute()
        made = [series.run(mesh, sizes=[2, 3], formats=["msh"], folder=self.folder.name) for _ in range(2)]
        mesh.Order = 1
        series.put_row(made[1], 0, None)
        self.reopen()
        first, _ = series.of_document(self.document)
        first.Mesh.Order = 2
        self.assertEqual(self.verdicts(first), [mesh_check.GOOD] * 2)
        first.Mesh.Part.Radius = 4
        self.document.recompute()
        self.assertEqual(self.verdicts(first), [mesh_check.WARNING] * 2)

    def verdicts(self, obj):
        return [row.verdict for row in series.rows_of(obj)]

    def test_what_is_refused_leaves_the_document_as_before(self):
        mesh, empty = self.add_mesh(size=3), mesh_object.add(self.document, [])
        count = len(self.document.Objects)
        for obj, arguments in ((mesh, {}), (mesh, {"sizes": [1], "frequencies": [1e9]}), (mesh, {"divisions": [6, 8]}),
                               (mesh, {"sizes": "1 GHz"}), (mesh, {"sizes": [1], "formats": ["doc"], "folder": self.folder.name}),
                               (mesh, {"sizes": [1], "formats": ["msh"], "folder": "/nowhere"}), (empty, {"sizes": [1]})):
            with self.assertRaisesRegex(ValueError, r"^.*\.$", msg=arguments):
                series.add(obj, **arguments)
        self.assertEqual(len(self.document.Objects), count)
