"""What commands and panels do: as lines of Python that the console shows; to documents in one step of undo."""
import FreeCADGui


def python_name(obj):
    return f'FreeCAD.getDocument("{obj.Document.Name}").getObject("{obj.Name}")'


def references_text(references):
    """[(object, elements)] as text for Python."""
    listed = ", ".join(f"({python_name(thing)}, {list(elements) or ['']!r})" for thing, elements in references)
    return f"[{listed}]"


def call_text(function, *arguments, **values):
    """A call as text for Python. arguments: texts; values: by name."""
    return f"{function}({', '.join([*arguments, *(f'{name}={value!r}' for name, value in values.items())])})"


def do(line, module=""):
    """Runs a line of Python, a call of `module` where that is given, which the console shows."""
    if module:
        FreeCADGui.addModule(module)
    FreeCADGui.doCommand(f"{module}.{line}" if module else line)


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
