"""A board with media: substrate, conductors, a terminal."""
TITLE = "A board with media"
ABOUT = "A microstrip filter for 5 GHz: a substrate and vias as media, shorter elements where the wavelength is shorter, a terminal, groups in the file."
MODEL = "gallery/microstrip_filter.step"


def walk(it):
    it.step("Open the model", f"Choose the workbench **Paver** and {it.open('microstrip_filter.step')}; {it.look()} and "
            f"{it.command('Std_ViewFitAll')} show it from a corner.",
            f"Unfold {it.unfold('Microstrip filter')}: *Solid* is the board, *Solid001* and *Solid002* are vias, the shells are sheets of metal.")
    it.step("Create a mesh", f"Click on {it.select('Microstrip filter')} and choose {it.command('Paver_CreateMesh')}.", f"Click {it.press('Frequency')} and write {it.write('Frequency', '5 GHz')}: about "
            f"{it.predicts()} elements.{it.snap()} Press {it.press('OK')}.")
    it.step("The substrate", f"Click on {it.select('Solid')} in the tree and choose {it.command('Paver_Medium')}.",
            f"Write the name {it.write('Name', 'Substrate')}, *εr* {it.write('εr', '4.4')} and the loss tangent "
            f"{it.write('Loss tangent', '0.02')}{it.snap()}, and press {it.press('OK')}.")
    it.step("The vias", f"Click on {it.select('Solid001')} and, with Ctrl, on {it.add('Solid002')}; choose {it.command('Paver_Medium')}.",
            f"Write the name {it.write('Name', 'Vias')}, choose {it.choose('Conductor', 'Yes')} for *Conductor*{it.snap()} and press {it.press('OK')}.")
    it.step("The terminals", f"Click on {it.select('Shell001')}, the line, in the tree and choose {it.command('Paver_Port')}: the whole of it is "
            f"meant, name it {it.write('Name', 'Line')}{it.snap()} and press {it.press('OK')}.",
            "In the 3D view a click there could as well mean the board below.")
    it.step("What the media change", f"Choose {it.command('Std_ViewFitAll')}, double-click on {it.double_click('PaverMesh')} and tick "
            f"{it.press('Preview')}: *{it.previews()}*.", f"Target lengths follow the wavelength in the substrate, and about {it.predicts()} "
            "elements are predicted now.")
    it.step("Mesh", f"Untick {it.press('Preview')}, which would cover the mesh, and press {it.press('Mesh')}.",
            f"The mesh has {it.meshed()} elements (scaled Jacobian: {it.figure('Scaled Jacobian')}), and *Contacts* says "
            f"*{it.figure('Contacts')}*: sheets, board and vias share their nodes.")
    it.step("Check the lengths", f"Press {it.press('OK')} and choose {it.command('Paver_Statistics')}.",
            f"The wavelength in the densest medium is {it.statistic('Wavelength', 1, 'In the densest medium')}, and no edge is longer than "
            f"{it.statistic('Longest edge', 2, 'In the densest medium')} of it.")
    it.step("Export", f"{it.press('Close')} that, choose {it.export('filter.msh')}, write a name and press **Save**.",
            f"The file has **{it.group('filter.msh', 'Line')}** and a group for each face; **{it.group('filter.msh', 'Substrate')}** and "
            f"**{it.group('filter.msh', 'Vias')}** have the faces around each medium.")
