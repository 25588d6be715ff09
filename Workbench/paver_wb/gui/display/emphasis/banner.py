"""The banner on top of the 3D view while a mesh that is seen there is out of date."""
import FreeCAD
from PySide import QtCore, QtGui

from paver_wb import mesh_object
from paver_wb.gui.base.background import Later
from paver_wb.gui.display.fields import put
from paver_wb.gui.display.panels import MARGIN, UPPER_MIDDLE, ViewPanel, font, sheet, text_size

MOST_BANNERS = 4  # one below the other
PAD, GAP = 10, 6
SHEET, RIM, INK = (255, 233, 168, 240), (196, 120, 0, 255), (45, 32, 0, 255)
MOST_WIDTH = 420
translate = FreeCAD.Qt.translate


class Banner(ViewPanel):
    """In the middle of the upper rim. `text`: what it says, empty while it is hidden."""

    text = ""

    def __init__(self):
        super().__init__(UPPER_MIDDLE)

    def attach(self, vobj):
        """Shows it in all display modes, FEM's too."""
        put(vobj.RootNode, self.switch)

    def tell(self, lines, row=0):
        """lines: heading and text; none to hide it."""
        if (self.text, row) != ("\n".join(lines), getattr(self, "row", None)):
            self.text, self.row = "\n".join(lines), row
            self.show(picture(*lines, row) if lines else None)


def picture(heading, text, row=0):
    """QImage of a sheet with two lines, in the given row from the top."""
    fonts = font(10, True), font(9)
    lines = [QtGui.QFontMetrics(f).elidedText(t, QtCore.Qt.ElideMiddle, MOST_WIDTH) for f, t in zip(fonts, (heading, text))]
    sizes = [text_size(line, f) for line, f in zip(lines, fonts)]
    width, height = max(size.width() for size in sizes) + 2 * PAD, sum(size.height() for size in sizes) + PAD
    image, painter = sheet(width, height, (0, MARGIN + row * (height + GAP), 0), SHEET, RIM)
    painter.setPen(QtGui.QColor(*INK))
    y = PAD / 2
    for line, of_font, size in zip(lines, fonts, sizes):
        painter.setFont(of_font)
        painter.drawText(QtCore.QRectF(0, y, width, size.height()), QtCore.Qt.AlignCenter, line)
        y += size.height()
    painter.end()
    return image


def renew(document):
    """Those of all meshes of a document."""
    row = 0
    for obj in mesh_object.meshes_of(document):
        display = getattr(obj.ViewObject.Proxy, "display", None)
        if display is None:
            continue
        is_shown = obj.Status == mesh_object.OUT_OF_DATE and obj.ViewObject.Visibility and row < MOST_BANNERS
        if is_shown:
            display.banner.stand_in(*place_of(obj, display))
            display.banner.tell([translate("Paver", "Out of date: {}").format(obj.Label), mesh_object.changes_text(obj)], row)
            row += 1
        else:
            display.banner.tell([])


renewals = Later(renew)


def place_of(obj, display):
    """(centre, extent) of what is seen of a mesh."""
    if display.mesh is not None:
        low, high = (FreeCAD.Vector(*(float(x) for x in corner)) for corner in display.mesh.extent)
    else:
        box = obj.FemMesh.BoundBox
        if not box.isValid():
            return (0, 0, 0), 1
        low, high = FreeCAD.Vector(box.XMin, box.YMin, box.ZMin), FreeCAD.Vector(box.XMax, box.YMax, box.ZMax)
    return tuple((low + high) / 2), (high - low).Length or 1.0
