"""Mesh objects in analyses of the FEM workbench. Run inside FreeCAD: freecadcmd -t TestPaver."""
import os
import shutil
import tempfile
import unittest

import FreeCAD
import ObjectsFem
import Part

from paver_wb import mesh_object, meshing

LENGTH, WIDTH, RADIUS, THICKNESS, PRESSURE = 100.0, 20.0, 20.0, 2.0, 0.01  # mm, MPa
YOUNG, POISSON = 210000.0, 0.3


class InAnalysis(unittest.TestCase):
    """A document with an analysis of a surface, clamped at an edge, under pressure."""

    def setUp(self):
        self.document = FreeCAD.newDocument("PaverAnalysis", hidden=True)
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)
        self.folder.cleanup()

    def members_of(self, source, edge, **options):
        """(mesh, pressure) of an analysis that can be solved, the mesh not made yet."""
        document = self.document
        analysis = ObjectsFem.makeAnalysis(document, "Analysis")
        make = getattr(ObjectsFem, "makeSolverCalculixCcxTools", None) or ObjectsFem.makeSolverCalculiXCcxTools
        solver = make(document)
        solver.WorkingDir = self.folder.name
        material = ObjectsFem.makeMaterialSolid(document)
        material.Material = {**material.Material, "Name": "Steel", "YoungsModulus": f"{YOUNG} MPa",
                             "PoissonRatio": str(POISSON)}
        thickness = ObjectsFem.makeElementGeometry2D(document, THICKNESS)
        fixed = ObjectsFem.makeConstraintFixed(document)
        fixed.References = [(source, edge)]
        pressure = ObjectsFem.makeConstraintPressure(document)
        pressure.References, pressure.Pressure = [(source, "Face1")], PRESSURE
        mesh = mesh_object.add(document, source, **options)
        for member in (solver, material, thickness, fixed, pressure, mesh):
            analysis.addObject(member)
        document.recompute()
        return mesh, pressure

    def displacements(self):
        """Vector of each node, as CalculiX finds it."""
        from femtools import ccxtools
        runner = ccxtools.FemToolsCcx(self.document.Analysis)
        runner.update_objects()
        runner.setup_working_dir(self.folder.name)
        runner.setup_ccx()
        self.assertEqual(runner.check_prerequisites(), "")
        runner.purge_results()
        runner.write_inp_file()
        self.assertFalse(runner.ccx_run())
        runner.load_results()
        result, = (thing for thing in self.document.Objects if thing.isDerivedFrom("Fem::FemResultObject"))
        return dict(zip(result.NodeNumbers, result.DisplacementVectors))


class Strip(InAnalysis):
    def setUp(self):
        super().setUp()
        self.plane = self.document.addObject("Part::Plane", "Plane")
        self.plane.Length, self.plane.Width = LENGTH, WIDTH
        self.document.recompute()

    def add_analysis(self, **options):
        at_zero = next(f"Edge{i}" for i, e in enumerate(self.plane.Shape.Edges, 1) if e.BoundBox.XMax < 1e-9)
        return self.members_of(self.plane, at_zero, **options)

    def group_sizes(self, mesh):
        return {mesh.FemMesh.getGroupName(g): len(mesh.FemMesh.getGroupElements(g)) for g in mesh.FemMesh.Groups}

    def test_groups_for_members_that_refer_to_faces(self):
        mesh, pressure = self.add_analysis(size=10)
        meshing.mesh(mesh)
        count = mesh.Quads + mesh.Triangles
        self.assertEqual(self.group_sizes(mesh), {"Face1": count, pressure.Name + "_Faces": count})
        pressure.References = []
        meshing.fill(mesh)
        self.assertEqual(self.group_sizes(mesh), {"Face1": count})

    def test_groups_of_several_objects(self):
        box = self.document.addObject("Part::Box", "Box")
        box.Placement.Base.z = 50
        self.document.recompute()
        mesh, pressure = self.add_analysis(size=5)
        mesh.MoreParts = [box]
        pressure.References = [(box, ("Face2", "Face3")), (self.plane, "Face1")]
        meshing.mesh(mesh)
        sizes = self.group_sizes(mesh)
        self.assertEqual(sizes[pressure.Name + "_Faces"],
                         sizes["Box_Face2"] + sizes["Box_Face3"] + sizes["Plane_Face1"])

    def test_what_two_objects_have_in_common_is_in_the_groups_of_both(self):
        box = self.document.addObject("Part::Box", "Box")  # stands on the plane
        box.Length = box.Width = box.Height = 1
        self.document.recompute()
        mesh, pressure = self.add_analysis(size=1)
        mesh.MoreParts = [box]
        pressure.References = [(self.plane, "Face1")]
        meshing.mesh(mesh)
        sizes = self.group_sizes(mesh)
        common = [name for name in sizes if " + " in name]
        self.assertEqual(len(common), 1, sizes)
        self.assertEqual(sizes[pressure.Name + "_Faces"], sizes["Plane_Face1"] + sizes[common[0]])

    def test_groups_are_there_again_in_a_reopened_document(self):
        mesh, _ = self.add_analysis(size=10)
        meshing.mesh(mesh)
        sizes, path = self.group_sizes(mesh), os.path.join(self.folder.name, "strip.FCStd")
        self.document.saveAs(path)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.openDocument(path, hidden=True)
        self.assertEqual(self.group_sizes(self.document.getObject("PaverMesh")), sizes)

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_calculix_bends_the_strip_as_theory_says(self):
        """Deflection q L^4 / (8 E I) of the free end, between that of a beam and that of a plate bent to a cylinder."""
        mesh, _ = self.add_analysis(size=5)
        meshing.mesh(mesh)
        largest = max(vector.Length for vector in self.displacements().values())
        beam = 12 * PRESSURE * LENGTH**4 / (8 * YOUNG * THICKNESS**3)
        self.assertLess(largest, 1.02 * beam)
        self.assertGreater(largest, 0.98 * (1 - POISSON**2) * beam)


class Later(Strip):
    """What is added to an analysis, or changed in it, when the mesh is there."""

    def setUp(self):
        super().setUp()
        preferences = FreeCAD.ParamGet(mesh_object.PREFERENCES)
        self.addCleanup(preferences.RemInt, "FillLimit")
        preferences.SetInt("FillLimit", 10)  # all meshes here are larger

    def largest(self):
        return max(vector.Length for vector in self.displacements().values())

    def beam(self, pressure=PRESSURE):
        return 12 * pressure * LENGTH**4 / (8 * YOUNG * THICKNESS**3)

    def without_pressure(self, source=None):
        """(mesh, analysis), the mesh made before it joins the analysis, which has no pressure."""
        mesh, pressure = self.add_analysis(size=5)
        self.document.removeObject(pressure.Name)
        self.document.Analysis.removeObject(mesh)
        if source:
            mesh.Part = source
        meshing.mesh(mesh)
        self.assertFalse(mesh.FemMeshFilled)
        self.document.Analysis.addObject(mesh)
        return mesh, self.document.Analysis

    def add_pressure(self, source, element="Face1"):
        pressure = ObjectsFem.makeConstraintPressure(self.document)
        pressure.References, pressure.Pressure = [(source, element)], PRESSURE
        return pressure

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_a_pressure_that_is_added_later_acts_at_any_size(self):
        mesh, analysis = self.without_pressure()
        self.assertTrue(mesh.FemMeshFilled)
        analysis.addObject(self.add_pressure(self.plane))
        self.assertAlmostEqual(self.largest() / self.beam(), 1, delta=0.1)

    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_a_pressure_on_a_feature_inside_of_what_is_meshed_acts(self):
        part = self.document.addObject("App::Part", "Assembly")
        part.addObject(self.plane)
        self.document.recompute()
        mesh, analysis = self.without_pressure(part)
        analysis.addObject(self.add_pressure(self.plane))
        self.assertAlmostEqual(self.largest() / self.beam(), 1, delta=0.1)

    def test_groups_follow_members(self):
        mesh, analysis = self.without_pressure()
        count, pressure = mesh.Quads + mesh.Triangles, self.add_pressure(self.plane)
        name = pressure.Name + "_Faces"
        self.assertEqual(self.group_sizes(mesh), {"Face1": count})
        analysis.addObject(pressure)
        self.assertEqual(self.group_sizes(mesh), {"Face1": count, name: count})
        pressure.References = []
        self.assertEqual(self.group_sizes(mesh), {"Face1": count})
        pressure.References = [(self.plane, "Face1")]
        self.assertEqual(self.group_sizes(mesh), {"Face1": count, name: count})
        meshing.mesh(mesh)
        self.assertEqual(self.group_sizes(mesh), {"Face1": count, name: count})
        self.document.removeObject(pressure.Name)
        self.assertEqual(self.group_sizes(mesh), {"Face1": count})
        for kind, make in (("thickness", lambda: ObjectsFem.makeElementGeometry2D(self.document, THICKNESS)),
                           ("material", lambda: ObjectsFem.makeMaterialSolid(self.document))):
            member = make()
            analysis.addObject(member)
            member.References = [(self.plane, "Face1")]
            self.assertEqual(self.group_sizes(mesh)[member.Name + "_Faces"], count, kind)

    def test_undo_takes_groups_back(self):
        mesh, analysis = self.without_pressure()
        self.document.UndoMode = 1
        before = self.group_sizes(mesh)
        self.document.openTransaction("Pressure")
        analysis.addObject(self.add_pressure(self.plane))
        self.document.commitTransaction()
        after = self.group_sizes(mesh)
        self.document.undo()
        self.assertEqual(self.group_sizes(mesh), before)
        self.document.redo()
        self.assertEqual(self.group_sizes(mesh), after)


class Pipe(InAnalysis):
    @unittest.skipUnless(shutil.which("ccx"), "CalculiX is not installed")
    def test_calculix_widens_a_pipe_as_theory_says(self):
        """As Lamé's thick pipe at the free end, where the clamp is no longer felt: curved quads, and curved triangles.
        CalculiX gives shells their thickness, so the pressure acts on the inside."""
        pipe = self.document.addObject("Part::Feature", "Pipe")
        pipe.Shape = next(f for f in Part.makeCylinder(RADIUS, LENGTH).Faces if isinstance(f.Surface, Part.Cylinder))
        self.document.recompute()
        clamped = next(f"Edge{i}" for i, e in enumerate(pipe.Shape.Edges, 1) if e.BoundBox.ZMax < 1e-9)
        mesh, _ = self.members_of(pipe, clamped, size=8)
        inner, outer = RADIUS - THICKNESS / 2, RADIUS + THICKNESS / 2
        expected = (PRESSURE / YOUNG * inner**2 / (outer**2 - inner**2) *
                    ((1 - POISSON) * RADIUS + (1 + POISSON) * outer**2 / RADIUS))
        for elements, kind in (("quad-dominant", "Quads"), ("all-triangle", "Triangles")):
            with self.subTest(elements=elements):
                mesh.Elements = elements
                meshing.mesh(mesh)
                self.assertGreater(getattr(mesh, kind), 150)
                moved, nodes = self.displacements(), mesh.FemMesh.Nodes
                free = [n for n, at in nodes.items() if at.z > LENGTH - 1e-6]
                self.assertGreater(len(free), 30)
                for n in free:
                    radial = FreeCAD.Vector(nodes[n].x, nodes[n].y, 0).normalize()
                    self.assertAlmostEqual(abs(moved[n].dot(radial)), expected, delta=0.01 * expected)
