"""CAD from elsewhere: what is merged, findings one by one, what to do until a mesh is sound."""
TITLE = "Imported CAD, until it is sound"
ABOUT = "An armoured vehicle for 60 MHz, whose parts run into each other: the outer skin, what is small, findings one by one, and what to do about them."
MODEL = "gallery/armoured_vehicle.step"
POOR = "scaled Jacobian"


def walk(it):
    it.step("Open the model", f"Choose the workbench **Paver** and {it.open('armoured_vehicle.step')}; {it.look()} and "
            f"{it.command('Std_ViewFitAll')} show it from a corner.", "Hull, turret, gun and wheels are solids that run into each other.")
    it.step("Create a mesh", f"Click on {it.select('Armoured vehicle')} in the tree and choose {it.command('Paver_CreateMesh')}.",
            f"Click {it.press('Frequency')} and write {it.write('Frequency', '60 MHz')}: about {it.predicts()} elements, half a metre long.")
    it.step("Only the outer skin", f"Open {it.press('More options')} and choose {it.choose('Parts that touch', 'union')} for *Parts that touch*: "
            "what lies inside of other parts is left out.", "Below *Merge edges below* and *Merge faces below* stand the shares of the target "
            "length under which edges and faces count as small.")
    it.step("See what is small", f"Close {it.press('More options')} and tick {it.press('Preview')}: *{it.previews()}*.",
            "Orange lines and points would be edges and faces that are merged with their neighbours, dark colours are short elements.")
    it.step("Mesh", f"Untick {it.press('Preview')} and press {it.press('Mesh')}.", f"The mesh has {it.meshed()} elements, and the verdict is a "
            f"warning: it can be used, but a solver may suffer from some of its elements.")
    it.step("The first finding", f"Press {it.press('Details')} and click on the first line: *{it.finding(POOR)}*.",
            "Lines stand in order: errors, warnings, notes, what is good; the view goes to the elements, with rings.")
    it.step("One by one", f"Press {it.press('Next')} to see each from near, and tick {it.press('Only these')} to see them without the rest.",
            f"Figures of the element stand below: *{it.says('CheckFigures')}*.")
    it.step("What to do", f"Untick {it.press('Only these')}, click on the line once more{it.again(POOR)}, press {it.press('Close')} and "
            f"{it.press('OK')}, and choose {it.command('Paver_Refine')}: the elements stand for their face.",
            f"Write {it.write('Length', '300 mm')}{it.snap()} and press {it.press('OK')}.")
    it.step("Mesh again, check again", f"Click on {it.select('PaverMesh')}, choose {it.command('Paver_Mesh')}, which makes {it.remeshed()} "
            f"elements, and {it.command('Paver_Check')}: the poor ones are gone, *{it.finding(POOR)}*.",
            "Warnings may stay where you know why, as short edges that the model itself has.")
    it.step("Finer, and export", f"{it.press('Close')} that, double-click on {it.double_click('PaverMesh')}, write {it.write('Elements per λ', '30')} "
            f"and press {it.press('Mesh')}: with {it.meshed()} elements the panel says **{it.good()}**, which means that nothing fails, folds, "
            f"is poor or too long.{it.snap()}", f"{it.export('vehicle.msh')} writes it to a file.")
