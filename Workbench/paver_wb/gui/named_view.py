"""How media, ports and wires look in the tree. Documents name this module and its view providers."""
from paver_wb.gui.base.view import ChildViewProvider


class NamedViewProvider(ChildViewProvider):
    panel = ("paver_wb.gui.named_panel", "NamedPanel")


class MediumViewProvider(NamedViewProvider):
    icon = "Paver_Medium.svg"


class PortViewProvider(NamedViewProvider):
    icon = "Paver_Port.svg"


class WireViewProvider(NamedViewProvider):
    icon = "Paver_Wire.svg"
