"""Texts of the property editor. Documents keep them in English; FreeCAD translates what it shows, in the context
"App::Property". scripts/translations collects them from the calls of tip(). Names of properties stay those of scripts, as in
all of FreeCAD."""


def tip(text):
    """Marks a tooltip or the name of a group."""
    return text


# Tooltips of the options as properties.tooltip makes them of the core's table.
OPTIONS = [
    tip('Target length of the element edges, e.g. 30, "30 mm", 1.5in. 0: not given'),
    tip('Working frequency instead of size, e.g. 3GHz, "300 MHz", 9e9. 0: not given'),
    tip("Elements per wavelength [10]"),
    tip("Relative permittivity of the medium [1]"),
    tip("Relative permeability of the medium [1]"),
    tip("Largest turn of the surface per element edge, degrees [45; 75 where that stays as close]. 0: not given"),
    tip("Largest growth of the element size per unit of length [0.6]"),
    tip("Target length of a part where shorter: Face3=2mm, Edge5,Vertex2=0.5, Solid1=eps-r:4; may be repeated. Besides "
        "those of the refinements"),
    tip("Stop before meshing when more elements are predicted [2000000]"),
    tip("Order of the elements, 1 or 2 [2]"),
    tip("quad-dominant; all-quad: triangles only where nothing else is possible; all-triangle [quad-dominant]"),
    tip("Mesh large faces at K times the target length first and divide that mesh: off, auto, 4 to 8 [auto]"),
    tip("Threads to work on; 0: all cores [0]"),
    tip("Processes that share the work, by MPI; 0: without MPI [0]"),
    tip("Parts that touch: imprint: share faces and edges; union: only the outer skin is left; none: as drawn [imprint]"),
    tip("Largest gap between faces or parts that is closed; 0: never sew [chosen by what it closes]. Negative: automatic"),
    tip("Refuse models that are not clean, naming what is wrong, instead of repairing them [off]"),
]
