"""Several frequencies, and a large mesh."""
TITLE = "Several frequencies, and large"
ABOUT = "A wind generator from 30 MHz to 1.4 GHz: a series with its table, then a large mesh in processes of its own, with log and time left."
MODEL = "wind_generator.brep"


def walk(it):
    it.step("Open the model", f"Choose the workbench **Paver** and {it.open('wind_generator.brep')}; {it.look()} and "
            f"{it.command('Std_ViewFitAll')} show it from a corner.", "The tower is 24 m high, and the rear edges of the blades are a few "
            "millimetres wide.")
    it.step("Create a mesh", f"Click on {it.select('wind_generator')} and choose {it.command('Paver_CreateMesh')}.",
            f"Click {it.press('Frequency')} and write {it.write('Frequency', '30 MHz')}: about {it.predicts()} elements.")
    it.step("See what is small", f"Tick {it.press('Preview')}: *{it.previews()}*.", "What is merged is orange in the 3D view, and dark "
            f"colours are short elements.{it.snap()} Untick {it.press('Preview')} and press {it.press('OK')}.")
    it.step("A series", f"Choose {it.command('Paver_Series')} and write the frequencies {it.write('Vary', '30 MHz, 60 MHz, 120 MHz')}, which "
            "stand beside *Vary*; below, a range can be filled in.", "Elements per wavelength or lengths can be varied as well.")
    it.step("Run it", f"Press {it.press('Run')}. The table fills while FreeCAD can be used: from {it.ran('30 MHz', 'Elements')} elements and "
            f"{it.ran('30 MHz', 'Unknowns')} unknowns at 30 MHz to {it.ran('120 MHz', 'Elements')} and {it.ran('120 MHz', 'Unknowns')} at "
            "120 MHz, with the worst that was found.")
    it.step("Look at each", f"Click on the row of {it.row('60 MHz')} and press {it.press('Close')}: its mesh stands alone in the 3D view, "
            "below the series in the tree.", "The table comes again by a double click on the series.")
    it.step("A large one", f"Hide {it.select('PaverMesh 60 MHz')} with {it.command('Std_ToggleVisibility')}, double-click on "
            f"{it.double_click('PaverMesh')}, press {it.press('Show model')} and write {it.write('Frequency', '1.4 GHz')}: about {it.predicts()} elements.",
            f"Under {it.press('More options')} choose {it.choose('Mesh in', 'Own process')} for *Mesh in* and write "
            f"{it.write('MPI processes', '2')} for *MPI processes*, which share the work.")
    it.step("While it runs", f"Press {it.press('Mesh')}{it.running()}: the panel and the status bar show how far it is and, once that can be "
            "told, how long it will still take.", "*Stop* ends it within a second and leaves all as it was.")
    it.step("What it took", f"Fold {it.press('More options')} again and scroll down: the mesh has {it.meshed()} elements"
            f"{it.scroll('Result')}.", "The last rows are the seconds of the run and of its stages, which the log has, too.")
    it.step("Export", f"Press {it.press('OK')}, choose {it.export('generator.msh')}, write a name and press **Save**.",
            "It is written while FreeCAD can be used, and the status bar tells when that is done.")
