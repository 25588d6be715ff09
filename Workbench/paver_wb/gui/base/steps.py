"""What the panel does to documents: as lines of Python that the console shows, in one step of undo."""
import FreeCADGui


def python_name(obj):
    return f'FreeCAD.getDocument("{obj.Document.Name}").getObject("{obj.Name}")'


def in_step(document, name, modules, lines):
    """Runs lines of Python as one step of undo; what they raise ends it without a trace."""
    for module in modules:
        FreeCADGui.addModule(module)
    document.openTransaction(name)
    try:
        for line in lines:
            FreeCADGui.doCommand(line)
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()
