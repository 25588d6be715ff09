"""The workbench is made of layers: a module imports only its own layer and those before it in LAYERS of paver_wb, also inside
of functions, and no modules import each other in a circle. A folder has at most 16 modules."""
import ast
import collections
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../support"))
import repo  # noqa: E402

PACKAGE, ROOM = "paver_wb", "Workbench/"


def modules():
    """{name of a module without the package's: its file}."""
    names = {re.sub(r"(/__init__)?\.py$", "", name[len(ROOM):]).replace("/", "."): name
             for name in repo.files(".py", under=ROOM + PACKAGE)}
    return {name[len(PACKAGE) + 1:]: file for name, file in names.items() if name != PACKAGE}


def layers():
    """LAYERS, read without running it."""
    tree = ast.parse(repo.text(f"{ROOM}{PACKAGE}/__init__.py"))
    return next(ast.literal_eval(node.value) for node in tree.body
                if isinstance(node, ast.Assign) and node.targets[0].id == "LAYERS")


def imports(file, known):
    """[(line, module)] of a file, wherever in it."""
    found = []
    for node in ast.walk(ast.parse(repo.text(file))):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            whole = [f"{node.module}.{alias.name}" for alias in node.names]
            names = [name if name[len(PACKAGE) + 1:] in known else node.module for name in whole]
        else:
            continue
        found += [(node.lineno, name[len(PACKAGE) + 1:]) for name in names if name.startswith(PACKAGE + ".")]
    return found


def layer_of(module, order):
    """Number of the layer: that of the longest name which begins the module's."""
    fitting = [layer for layer in order if not layer or module == layer or module.startswith(layer + ".")]
    return order.index(max(fitting, key=len))


def circle(graph):
    """A path that leads back to its beginning, or None."""
    done = set()

    def visit(module, path):
        if module in path:
            return path[path.index(module):] + [module]
        if module in done:
            return None
        found = next(filter(None, (visit(other, path + [module]) for other in graph[module])), None)
        done.add(module)
        return found
    return next(filter(None, (visit(module, []) for module in graph)), None)


def main():
    known, order, faults, graph = modules(), layers(), [], {}
    for module, file in known.items():
        graph[module] = [name for _, name in imports(file, known) if name in known]
        faults += [f"{file}:{line}: {name}: its layer comes after" for line, name in imports(file, known)
                   if layer_of(name, order) > layer_of(module, order)]
    faults += [f"LAYERS: there is no {layer}" for layer in order if layer and layer not in known]
    found = circle(graph)
    if found:
        faults.append("in a circle: " + " -> ".join(found))
    folders = collections.Counter(map(os.path.dirname, known.values()))
    faults += [f"{folder}: {count} modules, at most 16" for folder, count in folders.items() if count > 16]
    repo.finish(faults)


if __name__ == "__main__":
    main()
