"""The help page, in a dock of FreeCAD's window."""
import os

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from paver_wb.base.paths import PAGES

translate = FreeCAD.Qt.translate
NAME = "Paver_HelpPage"


def language():
    """Two letters of the language that FreeCAD shows, "en" for one there is no page in."""
    name = FreeCADGui.getLocale() if hasattr(FreeCADGui, "getLocale") else "English"
    known = {"German": "de"}
    return known.get(name, "en")


def page():
    """Path of the page in the user's language."""
    path = os.path.join(PAGES, f"help_{language()}.md")
    return path if os.path.exists(path) else os.path.join(PAGES, "help_en.md")


def follow(browser, url):
    """Goes to another page there; anything else is the desktop's."""
    target = browser.source().resolved(url)
    if target.isLocalFile() and target.path().endswith(".md"):
        browser.setSource(target)
    else:
        QtGui.QDesktopServices.openUrl(target)


def show():
    """Shows the page; gives its dock."""
    main = FreeCADGui.getMainWindow()
    dock = main.findChild(QtGui.QDockWidget, NAME)
    if dock is None:
        dock = QtGui.QDockWidget(translate("Paver", "Help on Paver"), main)
        dock.setObjectName(NAME)
        browser = QtGui.QTextBrowser()
        browser.setObjectName(NAME + "Text")
        browser.setOpenLinks(False)
        browser.anchorClicked.connect(lambda url: follow(browser, url))
        browser.document().setDocumentMargin(12)
        dock.setWidget(browser)
        main.addDockWidget(QtCore.Qt.RightDockWidgetArea, dock)
        main.resizeDocks([dock], [460], QtCore.Qt.Horizontal)
    dock.widget().setSource(QtCore.QUrl.fromLocalFile(page()))
    dock.show()
    dock.raise_()
    return dock
