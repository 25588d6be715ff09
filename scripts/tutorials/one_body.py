"""A closed body: size by frequency, colours, check, statistics, a refinement."""
TITLE = "One closed body"
ABOUT = "A cone-sphere with a slot for 3 GHz: size by frequency, colours, check and statistics, shorter elements in one place."
MODEL = "gallery/conesphere_slot.step"


def walk(it):
    it.step("Open the model", f"Choose the workbench **Paver**, then {it.open('conesphere_slot.step')} in the menu *File*.",
            f"Turn it with {it.look()} and {it.command('Std_ViewRotateLeft')}, and show all of it with {it.command('Std_ViewFitAll')}.")
    it.step("Create a mesh", f"Click on {it.select('Conesphere slot')} in the tree, then on {it.command('Paver_CreateMesh')}.",
            f"Its panel opens, with a length to begin with, which comes to about {it.predicts()} elements.")
    it.step("Give the frequency", f"Click {it.press('Frequency')} and write {it.write('Frequency', '3 GHz')}.",
            f"The panel shows the wavelength ({it.says('Wavelength')}), takes a tenth of it as the target length, and predicts "
            f"{it.predicts()} elements.")
    it.step("Mesh", f"Press {it.press('Mesh')}: a mesh of {it.meshed()} elements takes the place of the model, in colours of the scaled "
            f"Jacobian ({it.figure('Scaled Jacobian')}; 1 is a square).", "The panel scrolls to its *Result*, which begins with the worst "
            "that was found.")
    it.step("Look at the lengths", f"Press {it.press('OK')} above to close the panel, and choose {it.command('Paver_ColourLength')} in the "
            "list of the button with the coloured grid.", "White is the target length; the slot and the tip have shorter edges.")
    it.step("Check", f"Choose {it.command('Paver_Check')} and click on the first line: *{it.finding('scaled Jacobian')}*.",
            "The view goes there and puts rings around them: they lie at the tip, where elements run out into a point.")
    it.step("Statistics", f"{it.press('Close')} that and choose {it.command('Paver_Statistics')}: edges are "
            f"{it.statistic('Mean', 2, 'Edge length')} long in the mean, and there are {it.statistic('Elements per λ²', 2)} elements per λ².",
            f"A solver with rooftops has {it.statistic('Basis order 1 (rooftops, RWG)')} unknowns, whose full matrix takes "
            f"{it.statistic('Basis order 1 (rooftops, RWG)', 2)}.")
    it.step("Refine", f"{it.press('Close')} that, show all with {it.command('Std_ViewFitAll')}, click on an "
            f"element of the sphere and choose {it.refine('Face5')}.", f"Write {it.write('Length', '5 mm')}{it.snap()} and press "
            f"{it.press('OK')}.")
    it.step("Mesh again", "The mesh is grey now, as it is out of date: click on "
            f"{it.select('PaverMesh')} in the tree and choose {it.command('Paver_Mesh')}.",
            f"It has {it.remeshed()} elements, which grow from 5 mm on the sphere.")
    it.step("Export", f"Choose {it.export('conesphere.msh')}, write a name and press **Save**.",
            "A Gmsh file has all nodes of the curved elements, and a group for each face; the list below the name has other formats.")
