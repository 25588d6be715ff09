"""The help page, in a dock of FreeCAD's window."""
import os

import FreeCADGui
from PySide import QtCore, QtGui

from paver_wb.base.paths import PAGES
from paver_wb.gui.base.widgets import translate

NAME = "Paver_HelpPage"


def page():
    """Path of the page in the language that FreeCAD shows, in English for one there is no page in."""
    name = FreeCADGui.getLocale() if hasattr(FreeCADGui, "getLocale") else "English"
    return os.path.join(PAGES, "help_de.md" if name == "German" else "help_en.md")


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
        browser = QtGui.QTextBrowser(objectName=NAME + "Text", openLinks=False)
        browser.anchorClicked.connect(lambda url: follow(browser, url))
        browser.document().setDocumentMargin(12)
        dock.setWidget(browser)
        main.addDockWidget(QtCore.Qt.RightDockWidgetArea, dock)
        main.resizeDocks([dock], [460], QtCore.Qt.Horizontal)
    dock.widget().setSource(QtCore.QUrl.fromLocalFile(page()))
    dock.show()
    dock.raise_()
    return dock
