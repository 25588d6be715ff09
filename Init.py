"""FreeCAD runs this at its start, without a window too: `import paver` works in macros and in the Python console.

It is run as text, so it does not know its own path: the folder is the entry of sys.path that FreeCAD just made for it.
"""


def _add_bindings():
    import os
    import sys
    for folder in list(sys.path):
        bindings = os.path.join(folder, "bindings")
        if os.path.isfile(os.path.join(bindings, "paver", "__init__.py")):
            if bindings not in sys.path:
                sys.path.append(bindings)
            return


_add_bindings()
