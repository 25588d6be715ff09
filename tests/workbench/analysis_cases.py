"""Mesh objects in analyses of the FEM workbench. Run inside FreeCAD: freecadcmd -t TestPaver."""
import os
import shutil
import tempfile
import unittest

import FreeCAD
import ObjectsFem

from paver_wb import mesh_object, meshing

LENGTH, WIDTH, THICKNESS, PRESSURE = 100.0, 20.0, 2.0, 0.01  # mm, MPa
YOUNG, POISSON = 210000.0, 0.3


class Strip(unittest.TestCase):
    """A strip, clamped at one end, under pressure."""

    def setUp(self):
        self.document = FreeCAD.newDocument("PaverAnalysis", hidden=True)
        self.plane = self.document.addObject("Part::Plane", "Plane")
        self.plane.Length, self.plane.Width = LENGTH, WIDTH
        self.document.recompute()
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        FreeCAD.closeDocument(self.document.Name)
        self.folder.cleanup()

    def clamped_edge(self):
        """Name of the edge at x = 0."""
        return next(f"Edge{i}" for i, e in enumerate(self.plane.Shape.Edges, 1) if e.BoundBox.XMax < 1e-9)

    def add_analysis(self, **options):
        """(mesh, pressure) of an analysis that can be solved, the mesh not made yet."""
        document = self.document
        analysis = ObjectsFem.makeAnalysis(document, "Analysis")
        solver = ObjectsFem.makeSolverCalculixCcxTools(document)
        solver.WorkingDir = self.folder.name
        material = ObjectsFem.makeMaterialSolid(document)
        material.Material = {**material.Material, "Name": "Steel", "YoungsModulus": f"{YOUNG} MPa",
                             "PoissonRatio": str(POISSON)}
        thickness = ObjectsFem.makeElementGeometry2D(document, THICKNESS)
        fixed = ObjectsFem.makeConstraintFixed(document)
        fixed.References = [(self.plane, self.clamped_edge())]
        pressure = ObjectsFem.makeConstraintPressure(document)
        pressure.References, pressure.Pressure = [(self.plane, "Face1")], PRESSURE
        mesh = mesh_object.add(document, self.plane, **options)
        for member in (solver, material, thickness, fixed, pressure, mesh):
            analysis.addObject(member)
        document.recompute()
        return mesh, pressure

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
        from femtools import ccxtools
        mesh, _ = self.add_analysis(size=5)
        meshing.mesh(mesh)
        runner = ccxtools.FemToolsCcx(self.document.Analysis)
        runner.update_objects()
        runner.setup_working_dir(self.folder.name)
        runner.setup_ccx()
        self.assertEqual(runner.check_prerequisites(), "")
        runner.purge_results()
        runner.write_inp_file()
        self.assertFalse(runner.ccx_run())
        runner.load_results()
        results = [thing for thing in self.document.Objects if thing.isDerivedFrom("Fem::FemResultObject")]
        largest = max(vector.Length for vector in results[0].DisplacementVectors)
        beam = 12 * PRESSURE * LENGTH**4 / (8 * YOUNG * THICKNESS**3)
        self.assertLess(largest, 1.02 * beam)
        self.assertGreater(largest, 0.98 * (1 - POISSON**2) * beam)
