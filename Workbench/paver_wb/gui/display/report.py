"""What is told about an element."""
from paver_wb.base.texts import counted
from paver_wb.base.units import area_text, lengths_text
from paver_wb.gui.display.colouring import translate
from paver_wb.statistics import number


def element_name(element):
    """As FreeCAD names it in selections: element 0 is "Elem1"."""
    return f"Elem{element + 1}"


def element_number(name):
    """0 of "Elem1"; None for the name of anything else."""
    digits = name[len("Elem"):]
    return int(digits) - 1 if name.startswith("Elem") and digits.isdigit() and int(digits) > 0 else None


def information(mesh, element, wave=None):
    """Figures of an element of a DrawnMesh as a dict; lengths in mm, `lengths_in_wavelengths` only with a wavelength."""
    is_quad = element < mesh.quad_count
    lengths = [float(x) for x in mesh.edge_lengths[element][:4 if is_quad else 3]]
    made = {"name": element_name(element), "kind": "quad" if is_quad else "triangle", "order": mesh.order,
            "face": mesh.face_names[mesh.faces[element]], "sj": float(mesh.quality.sj[element]),
            "jacobian_ratio": float(mesh.quality.jacobian_ratio[element]),
            "validity": ("valid", "inverted", "undecided")[mesh.quality.validity[element]],
            "area": float(mesh.quality.area[element]), "lengths": lengths, "target": mesh.target,
            "centre": tuple(float(x) for x in mesh.centres[element])}
    if wave:
        made["lengths_in_wavelengths"] = [x / wave for x in lengths]
    return made


def kind_text(info):
    return translate("Paver", "Quad") if info["kind"] == "quad" else translate("Paver", "Triangle")


def rows(info):
    """(name, value) texts, the first one a heading without a value."""
    shown = {"valid": translate("Paver", "valid, proven"), "inverted": translate("Paver", "inverted"),
             "undecided": translate("Paver", "undecided")}[info["validity"]]
    made = [(f"{kind_text(info)} {info['name']}", ""),
            (translate("Paver", "Face"), info["face"]),
            (translate("Paver", "Scaled Jacobian"), f"{info['sj']:.4f}"),
            (translate("Paver", "Order {}").format(info["order"]),
             shown + ", " + translate("Paver", "Jacobian ratio {}").format(f"{info['jacobian_ratio']:.3f}")),
            (translate("Paver", "Edges"), lengths_text(info["lengths"]))]
    if "lengths_in_wavelengths" in info:
        made.append((translate("Paver", "Edges / \u03bb"), ", ".join(f"{x:.3g}" for x in info["lengths_in_wavelengths"])))
    if info["target"]:
        made.append((translate("Paver", "Longest / target"), f"{max(info['lengths']) / info['target']:.3f}"))
    return made + [(translate("Paver", "Area"), area_text(info["area"]))]


def elements_text(count):
    return counted(count, translate("Paver", "{} element"), translate("Paver", "{} elements")).format(number(count))


def line(info):
    """All of it in one line, for the status bar."""
    text = f"{kind_text(info)} {info['name']}, {info['face']}, SJ {info['sj']:.3f}, " + translate(
        "Paver", "edges {}").format(lengths_text(info["lengths"]))
    if "lengths_in_wavelengths" in info:
        text += " = " + ", ".join(f"{x:.3g}" for x in info["lengths_in_wavelengths"]) + " \u03bb"
    return text
