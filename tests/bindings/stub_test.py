"""The stub file says what is there: the same names, the same arguments; everything public is documented."""
import ast
import inspect
import os

import paver
from conftest import BINDINGS


def stub():
    with open(os.path.join(BINDINGS, "paver", "__init__.pyi")) as file:
        return ast.parse(file.read())


def arguments_of(node):
    """[(name, has a default)] of a function in the stub."""
    args = node.args
    plain = args.posonlyargs + args.args
    defaults = [False] * (len(plain) - len(args.defaults)) + [True] * len(args.defaults)
    named = list(zip(plain, defaults)) + [(a, d is not None) for a, d in zip(args.kwonlyargs, args.kw_defaults)]
    return [(a.arg, has_default) for a, has_default in named]


def arguments_at_run_time(function):
    return [(p.name, p.default is not p.empty) for p in inspect.signature(function).parameters.values()]


def test_names():
    nodes = {n.name: n for n in stub().body if isinstance(n, (ast.FunctionDef, ast.ClassDef))}
    assert sorted(nodes) == sorted(paver.__all__)
    assert os.path.exists(os.path.join(BINDINGS, "paver", "py.typed"))


def test_functions():
    for node in stub().body:
        if isinstance(node, ast.FunctionDef):
            assert arguments_of(node) == arguments_at_run_time(getattr(paver, node.name)), node.name


def test_classes():
    for node in stub().body:
        if not isinstance(node, ast.ClassDef):
            continue
        real = getattr(paver, node.name)
        bases = [ast.unparse(base) for base in node.bases]
        assert not bases or bases == ["NamedTuple"] or [b.rsplit(".")[-1] for b in bases] == [
            b.__name__ for b in real.__bases__], node.name
        for item in node.body:
            if isinstance(item, ast.FunctionDef) and not item.decorator_list:
                assert arguments_of(item) == arguments_at_run_time(getattr(real, item.name)), (node.name, item.name)
        properties = {i.name for i in node.body if isinstance(i, ast.FunctionDef) and i.decorator_list}
        assert properties == {n for n, v in vars(real).items() if isinstance(v, property)} or hasattr(real, "_fields")
        if bases == ["NamedTuple"]:
            assert [i.target.id for i in node.body if isinstance(i, ast.AnnAssign)] == list(real._fields)


def test_fields_of_objects(box):
    model, error = paver.Model(box), paver.Error("Text.")
    classes = {n.name: n for n in stub().body if isinstance(n, ast.ClassDef)}
    for thing in (model, error):
        fields = [i.target.id for i in classes[type(thing).__name__].body if isinstance(i, ast.AnnAssign)]
        assert sorted(fields) == sorted(n for n in vars(thing) if not n.startswith("_"))


def test_everything_public_is_documented():
    for name in paver.__all__:
        thing = getattr(paver, name)
        assert inspect.getdoc(thing), name
        if inspect.isclass(thing):
            own = {n: v for n, v in vars(thing).items() if not n.startswith("_") and (callable(v) or
                                                                                      isinstance(v, property))}
            assert all(inspect.getdoc(v) for v in own.values()), name
            for field in getattr(thing, "_fields", ()):
                assert field in thing.__doc__, (name, field)


def test_all_arrays_are_in_the_table_of_the_page():
    with open(os.path.join(BINDINGS, "README.md")) as file:
        page = file.read()
    for name, value in vars(paver.Result).items():
        if isinstance(value, property) and "int32" in value.__doc__ + "float64" and "(" in value.__doc__[:2]:
            assert f"`{name}`" in page, name
