"""The first look at a document that was made without a window: it keeps no view of its own."""
import re
import zipfile

import FreeCAD
import FreeCADGui
from PySide import QtCore

from paver_wb import mesh_object

CORNER = "orientation 0.74290609 0.30772209 0.59447289 1.2170947"  # FreeCAD's isometric view
AGAIN = 50  # ms, while a mesh is being read beside the window
_waiting = set()  # names of documents


def has_view(document):
    """Whether its file keeps a view. One that is no archive (an unsaved document's, a backup's) is left alone."""
    try:
        with zipfile.ZipFile(document.FileName) as file:
            return "GuiDocument.xml" in file.namelist()
    except (OSError, zipfile.BadZipFile):
        return True


def look_later(document):
    """Shows all of a document from a corner, once it is open and its meshes are drawn."""
    if document.Name not in _waiting and not has_view(document):
        _waiting.add(document.Name)
        start(document.Name, camera_of(view_of(document.Name)))


def start(name, camera):
    QtCore.QTimer.singleShot(AGAIN, lambda: look(name, camera))


def view_of(name):
    """The 3D view of a document that is open and has one in front, else None."""
    view = FreeCADGui.getDocument(name).ActiveView if name in FreeCAD.listDocuments() else None
    return view if hasattr(view, "viewIsometric") else None


def camera_of(view):
    """Where it stands and what it sees, less the planes that drawing sets anew."""
    lines = view.getCamera().splitlines() if view else []
    return [line for line in lines if line.split()[:1] in (["position"], ["orientation"], ["height"], ["heightAngle"])]


def is_ready(document):
    """FreeCAD may come to its events while it opens a document."""
    return not document.Restoring and not any(obj.ViewObject.Proxy.display.is_pending()
                                              for obj in mesh_object.meshes_of(document))


def look(name, camera):
    """camera: that of the beginning; who has chosen another one since keeps it."""
    view = view_of(name)
    if view and not is_ready(FreeCAD.getDocument(name)):
        start(name, camera)
        return
    _waiting.discard(name)
    if view and camera_of(view) == camera:
        show_all(view)


def show_all(view):
    """All of the document, from a corner and at once: FreeCAD 1.0's viewIsometric turns by and by, and what is fitted
    meanwhile does not fit in the end."""
    view.setCamera(re.sub("orientation .*", CORNER, view.getCamera()))
    view.fitAll()
