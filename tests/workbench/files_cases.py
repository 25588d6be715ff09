"""Statistics, checks, exports and imports of mesh objects. Run inside FreeCAD: freecadcmd -t TestPaver."""
import os

import FreeCAD
import numpy as np
import Part

from mesh_cases import InDocument
from paver_wb import core, export_mesh, file_types, import_mesh, mesh_check, mesh_object, meshing, series, statistics
from paver_wb.formats import fem_mesh, raw_mesh


class WithMesh(InDocument):
    def meshed(self, *parts, **options):
        mesh = mesh_object.add(self.document, list(parts) or self.box, **(options or {"size": 5}))
        self.document.recompute()
        return mesh, meshing.mesh(mesh)

    def path(self, name):
        return os.path.join(self.folder.name, name)


class Statistics(WithMesh):
    def test_figures_are_those_of_the_report(self):
        mesh, result = self.meshed()
        figures, quality = statistics.of_object(mesh), result.report["quality"]
        self.assertEqual((figures.quads, figures.triangles, figures.nodes),
                         (quality["quads"], quality["triangles"], quality["nodes"]))
        self.assertAlmostEqual(figures.areas.sum(), quality["mesh_area"], 6)
        self.assertAlmostEqual(figures.lengths.mean() / figures.target, quality["length_mean"], 9)
        self.assertAlmostEqual(figures.sj.min(), quality["sj"]["all"]["min"], 12)
        self.assertTrue((figures.users == 2).all())
        self.assertIsNone(figures.wave)

    def test_unknowns_of_a_closed_mesh(self):
        mesh, _ = self.meshed(size=10, order=1)
        figures = statistics.of_object(mesh)
        self.assertEqual(figures.triangles, 0)
        edges = 2 * figures.quads  # four sides, each shared by two
        self.assertEqual(len(figures.edges), edges)
        self.assertEqual([statistics.unknowns(figures, order) for order in (1, 2)],
                         [edges, 2 * edges + 4 * figures.quads])

    def test_unknowns_of_an_open_sheet_leave_out_its_border(self):
        sheet = self.add("Part::Plane", Length=20, Width=10)
        mesh, _ = self.meshed(sheet, size=5)
        figures = statistics.of_object(mesh)
        self.assertEqual((figures.quads, statistics.unknowns(figures)), (8, 4 * 1 + 2 * 3))

    def test_wavelengths(self):
        mesh, _ = self.meshed(frequency="3 GHz", divisions=20, eps_r=4)
        figures = statistics.of_object(mesh)
        self.assertAlmostEqual(figures.wave.length, 299792458e3 / 3e9 / 2, 9)
        self.assertAlmostEqual(figures.target * 20, figures.wave.length, 9)
        table = {(row.group, row.name): row for row in statistics.rows(figures)}
        self.assertEqual(table["Edge length", "Target"].in_waves, "0.05 λ")
        self.assertTrue(table["Element area", "Mean"].in_waves.endswith(" λ²"))
        self.assertEqual(statistics.of_object(mesh, frequency=1e9).wave.length, 3 * figures.wave.length)
        self.assertIn("Elements per λ²", statistics.text(figures))

    def test_histograms_count_every_value(self):
        for values in (np.linspace(0, 1, 100), np.full(7, 2.5), np.zeros(3), np.array([1, np.nan])):
            counts, limits = statistics.histogram(values)
            self.assertEqual((counts.sum(), len(limits)), (np.isfinite(values).sum(), len(counts) + 1))
        self.assertEqual(statistics.memory(16 * 1000 ** 2), "15.3 MiB")


class Checks(WithMesh):
    def levels(self, mesh):
        return {finding.text: finding.level for finding in mesh_check.check(mesh)}

    def test_a_sound_mesh(self):
        mesh, _ = self.meshed()
        self.assertEqual(set(self.levels(mesh).values()), {mesh_check.GOOD})
        mesh.Size = 4
        self.assertEqual(mesh_check.verdict(mesh_check.check(mesh)), mesh_check.WARNING)

    def test_open_sheets_triangles_and_poor_elements_are_found(self):
        sheet = Part.Face(Part.makePolygon([(0, 0, 0), (100, 0, 0), (100, 5, 0), (0, 0, 0)]))
        mesh, result = self.meshed(self.add("Part::Feature", Shape=sheet), size=30, elements="all-triangle")
        findings = mesh_check.check(mesh)
        texts = [f.text for f in findings]
        free, = (f for f in findings if "are free" in f.text)
        self.assertEqual(len(free.elements), len({n for n in free.elements}))
        self.assertTrue(set(free.elements) <= set(range(1, len(result.triangles) + 1)))
        of_triangles, = (f for f in findings if "are triangles" in f.text)
        self.assertEqual(of_triangles.elements, tuple(range(1, len(result.triangles) + 1)))
        self.assertFalse(any("All elements are quads" in text for text in texts))

    def test_failed_faces_are_errors(self):
        bow_tie = Part.Face(Part.makePolygon([(0, 0, 0), (10, 10, 0), (10, 0, 0), (2, 9, 0), (0, 0, 0)]))
        both = Part.makeCompound([bow_tie, Part.makePlane(5, 5, FreeCAD.Vector(30, 0, 0))])
        mesh, _ = self.meshed(self.add("Part::Feature", Shape=both), size=2)
        self.assertEqual(mesh_check.check(mesh)[0].level, mesh_check.ERROR)

    def test_open_solids_are_warnings(self):
        solid = Part.Solid(Part.Shell(Part.makeBox(10, 20, 30).Faces[1:]))
        mesh, _ = self.meshed(self.add("Part::Feature", Shape=solid), size=5)
        self.assertEqual(mesh_check.check(mesh)[0].level, mesh_check.WARNING)
        self.assertIn("is open", mesh_check.check(mesh)[0].text)

    def test_wires_alone(self):
        wire = self.document.addObject("Part::Feature", "Wire")
        wire.Shape = Part.makeLine(FreeCAD.Vector(), FreeCAD.Vector(0, 0, 30))
        mesh, _ = self.meshed(wire)
        figures = statistics.of_object(mesh)
        self.assertEqual((len(figures.edges), figures.nodes), (mesh.Lines, mesh.Nodes))
        self.assertAlmostEqual(figures.lengths.sum(), 30, 6)
        self.assertEqual(statistics.unknowns(figures), 0)
        self.assertIn("Edges\t" + str(mesh.Lines), statistics.text(figures))
        statistics.charts(figures)
        findings = mesh_check.check(mesh)
        self.assertEqual(mesh_check.verdict(findings), mesh_check.GOOD)
        self.assertTrue(any("lines of wires" in finding.text for finding in findings))
        rows = series.rows_of(series.run(mesh, sizes=[3, 6]))
        self.assertEqual([(row.is_meshed, row.error, row.verdict) for row in rows], [(True, "", mesh_check.GOOD)] * 2)

    def test_one_of_a_kind_is_told_as_one(self):
        mesh, _ = self.meshed(size=5)
        figures = statistics.of_object(mesh)
        sj = figures.sj.copy()
        sj[3] = 0.1
        found = mesh_check.shape(figures._replace(sj=sj))
        self.assertEqual((found.text, found.elements), ("1 element has a scaled Jacobian below 0.3: 0.100.", (4,)))
        sj[5] = 0.2
        self.assertEqual(mesh_check.shape(figures._replace(sj=sj)).text, "2 elements have a scaled Jacobian below 0.3; the least is 0.100.")

    def test_an_object_that_is_not_meshed(self):
        with self.assertRaisesRegex(ValueError, "not meshed"):
            mesh_check.check(mesh_object.add(self.document, self.box))


class Files(WithMesh):
    def test_own_formats_are_as_the_result_writes_them_also_after_opening(self):
        mesh, result = self.meshed(self.add("Part::Cone", Radius1=3, Radius2=9, Height=8), size=2)
        result.write(self.path("one.vtu"))
        result.write(self.path("one.msh"), msh_version="2.2", ascii=True)
        name = mesh.Name
        self.reopen()
        mesh = self.document.getObject(name)
        export_mesh.write(mesh, self.path("two.vtu"))
        export_mesh.write(mesh, self.path("two.msh"), msh_version="2.2", ascii=True)
        for ending in ("vtu", "msh"):
            with open(self.path("one." + ending), "rb") as one, open(self.path("two." + ending), "rb") as two:
                self.assertEqual(one.read(), two.read(), ending)

    def test_every_format_is_written_and_leaves_the_document_as_it_was(self):
        mesh, result = self.meshed()
        mesh.FemMeshFilled = False
        for ending in (*export_mesh.OWN, *export_mesh.FEM):
            path = export_mesh.write(mesh, self.path("mesh." + ending))
            self.assertGreater(os.path.getsize(path), 1000, ending)
        self.assertFalse(mesh.FemMeshFilled)
        self.assertEqual(len(os.listdir(self.folder.name)), len(export_mesh.OWN) + len(export_mesh.FEM))

    def test_every_export_is_read_back_with_all_it_has(self):
        """Quads and triangles of both orders, alone and with a wire, and the wire alone."""
        cone = self.add("Part::Cone", Radius1=3, Radius2=9, Height=8)
        wire = self.add("Part::Feature", Shape=Part.makeLine(FreeCAD.Vector(30, 0, 0), FreeCAD.Vector(30, 0, 20)))
        refused = []
        for parts, elements, order in [(parts, *way) for parts in ([cone], [cone, wire], [wire])
                                       for way in (("quad-dominant", 2), ("all-triangle", 2), ("quad-dominant", 1))]:
            mesh, result = self.meshed(*parts, size=3, elements=elements, order=order)
            wanted = mesh.Quads + mesh.Triangles, mesh.Lines
            for ending in (*export_mesh.OWN, *export_mesh.FEM):
                path, what = self.path("mesh." + ending), (len(parts), elements, order, ending)
                try:
                    export_mesh.write(mesh, path)
                except export_mesh.CannotHold as error:
                    self.assertRegex(str(error), "use (another format|[.]msh)")
                    refused.append((ending, order, bool(wanted[0]), bool(wanted[1])))
                    continue
                if ending in export_mesh.FEM:
                    nodes, faces, lines = fem_mesh.counts_in(path, "." + ending)
                    self.assertEqual((faces, lines) if ending != "stl" else faces >= wanted[0],
                                     wanted if ending != "stl" else True, what)
                elif wanted[0]:
                    read = import_mesh.read(path)
                    self.assertEqual(len(read.quads) + len(read.triangles), wanted[0], what)
                os.remove(path)
            self.document.removeObject(mesh.Name)
        self.assertEqual(set(refused), {("z88", 1, True, False), ("z88", 1, True, True), ("z88", 2, True, True),
                                        ("stl", 1, False, True), ("stl", 2, False, True)})
        self.assertEqual(os.listdir(self.folder.name), [])

    def test_an_empty_or_cut_file_is_an_error_and_does_not_stay(self):
        mesh, _ = self.meshed()
        real = fem_mesh.of_mesh
        self.addCleanup(setattr, fem_mesh, "of_mesh", real)

        class Cut:
            """A FemMesh that does not write all of itself, as on a full disk."""

            def __init__(self, fem, share):
                self.fem, self.share = fem, share

            def __getattr__(self, name):
                return getattr(self.fem, name)

            def write(self, path):
                self.fem.write(path)
                os.truncate(path, int(self.share * os.path.getsize(path)))

            def writeABAQUS(self, path, *_):
                self.write(path)
        for share in (0, 0.5, 0.9):
            fem_mesh.of_mesh = lambda *arguments: Cut(real(*arguments), share)
            for ending in export_mesh.FEM:
                with self.assertRaises(export_mesh.NotWritten, msg=(share, ending)):
                    export_mesh.write(mesh, self.path("mesh." + ending))
        self.assertEqual(os.listdir(self.folder.name), [])

    def test_what_cannot_be_written_is_said(self):
        mesh, _ = self.meshed()
        for path, says in (("mesh.xyz", "none of the endings"), ("no/mesh.msh", "no"), ("no/mesh.unv", "no")):
            with self.assertRaisesRegex(export_mesh.NotWritten, says):
                export_mesh.write(mesh, self.path(path))
        self.assertEqual(os.listdir(self.folder.name), [])

    def test_what_is_exported_is_imported_again(self):
        for elements, order in (("quad-dominant", 2), ("all-triangle", 1), ("quad-dominant", 1)):
            mesh, result = self.meshed(size=6, elements=elements, order=order)
            for ending, more in (("msh", {}), ("msh", {"ascii": True}), ("msh", {"msh_version": "2.2"}),
                                 ("msh", {"msh_version": "2.2", "ascii": True}), ("vtu", {}), ("vtu", {"ascii": True}),
                                 ("unv", {}), ("med", {}), ("inp", {})):
                path = export_mesh.write(mesh, self.path("mesh." + ending), **more)
                read = import_mesh.add(self.document, path)
                what = (elements, order, ending, more)
                self.assertEqual((read.Status, read.Quads, read.Triangles, read.Watertight),
                                 ("Up to date", mesh.Quads, mesh.Triangles, True), what)
                self.assertAlmostEqual(read.WorstScaledJacobian, mesh.WorstScaledJacobian, 5, what)
                figures, own = statistics.of_object(read), statistics.of_object(mesh)
                self.assertAlmostEqual(figures.areas.sum(), own.areas.sum(), 3, what)
                self.assertAlmostEqual(figures.lengths.mean(), own.lengths.mean(), 5, what)
                if ending != "inp":
                    self.assertEqual(sorted(mesh_object.stored(read).face_names), sorted(result.face_names), what)
                self.assertEqual(read.FemMesh.FaceCount, mesh.FemMesh.FaceCount)
                self.document.removeObject(read.Name)

    def test_no_format_is_offered_that_is_written_but_not_read(self):
        mesh, _ = self.meshed()
        for ending in [ending for ending in export_mesh.FEM if "." + ending in import_mesh.FEM]:
            path = export_mesh.write(mesh, self.path("mesh." + ending))
            self.assertTrue(len(import_mesh.read(path).nodes), ending)

    def test_an_imported_mesh_is_checked_saved_and_exported(self):
        mesh, _ = self.meshed()
        read = import_mesh.add(self.document, export_mesh.write(mesh, self.path("wing.msh")))
        self.assertEqual((read.Label, read.Part), ("wing", None))
        self.assertEqual({f.level for f in mesh_check.check(read)}, {mesh_check.GOOD})
        name = read.Name
        self.reopen()
        read = self.document.getObject(name)
        export_mesh.write(read, self.path("again.vtu"))
        self.assertEqual(import_mesh.read(self.path("again.vtu")).quads.shape, mesh_object.stored(read).quads.shape)
        with self.assertRaisesRegex(core.load().InputError, "no object to mesh"):
            meshing.mesh(read)

    def test_freecads_own_import_and_export(self):
        self.assertIn("paver_wb.file_types", FreeCAD.getImportType("msh"))
        self.assertIn("paver_wb.file_types", FreeCAD.getExportType("msh"))
        mesh, _ = self.meshed()
        path = self.path("own.msh")
        file_types.export([self.box, mesh], path)
        read = file_types.insert(path, self.document.Name)
        self.assertEqual((read.Quads, self.document.UndoNames[0]), (mesh.Quads, "Import mesh"))
        other = file_types.open(path)
        self.assertEqual(mesh_object.meshes_of(other)[0].Quads, mesh.Quads)
        FreeCAD.closeDocument(other.Name)
        with self.assertRaisesRegex(ValueError, "Select one mesh"):
            file_types.export([self.box], path)

    def test_mixed_orders_become_one(self):
        points = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0), (2, 1, 0), (1.5, -0.1, 0), (2, 0.5, 0),
                           (1.5, 1, 0), (1, 0.5, 0)], float)
        raw = raw_mesh.RawMesh(points, np.arange(10), [("quad4", np.array([[0, 1, 2, 3]]), "a"),
                                                       ("quad8", np.array([[1, 4, 5, 2, 6, 7, 8, 9]]), "b")])
        tables = raw_mesh.tables(raw)
        self.assertEqual((tables.order, tables.quads.shape, tables.names), (2, (2, 9), ["a", "b"]))
        np.testing.assert_allclose(tables.nodes[tables.quads[0, 8]], (0.5, 0.5, 0))
        np.testing.assert_allclose(tables.nodes[tables.quads[1, 8]], (1.5, 0.45, 0))

    def test_damaged_files_are_refused_in_a_sentence(self):
        mesh, _ = self.meshed(size=20)
        whole = {ending: open(export_mesh.write(mesh, self.path("mesh." + ending)), "rb").read()
                 for ending in ("msh", "vtu", "unv")}
        text = open(export_mesh.write(mesh, self.path("text.msh"), ascii=True), "rb").read()
        broken = [("empty.msh", b""), ("text.msh", b"hello\n"), ("text.vtu", b"hello"), ("mesh.xyz", b"?"),
                  ("old.msh", b"$MeshFormat\n1 0 8\n$EndMeshFormat\n"), ("text.unv", b"hello"),
                  ("no_end.msh", text[:text.index(b"$EndElements")].rstrip()),
                  ("cut.msh", whole["msh"][:len(whole["msh"]) // 2]), ("cut.vtu", whole["vtu"][:len(whole["vtu"]) // 2])]
        before = len(self.document.Objects)
        for name, content in broken:
            with open(self.path(name), "wb") as file:
                file.write(content)
            with self.assertRaisesRegex(raw_mesh.Damaged, "cannot be read: .*[.]$", msg=name):
                import_mesh.add(self.document, self.path(name))
        with self.assertRaisesRegex(raw_mesh.Damaged, "cannot be read"):
            import_mesh.add(self.document, self.path("nowhere.msh"))
        self.assertEqual(len(self.document.Objects), before)
