"""The tutorials, in the order of the list."""
import importlib

NAMES = ["one_body", "touching_parts", "board", "imported", "series"]


def tutorial(name):
    """The module that walks through it."""
    return importlib.import_module(name)
