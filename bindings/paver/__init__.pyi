import os
import threading
from typing import Any, Callable, Literal, NamedTuple, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

__version__: str

Quantity = Any  # FreeCAD.Units.Quantity
Length = Union[float, str, Quantity]  # mm, or "30 mm"
Frequency = Union[float, str, Quantity]  # Hz, or "9 GHz"
Angle = Union[float, str, Quantity]  # degrees, or "0.5 rad"
Medium = dict[str, float]  # eps_r, mu_r
Named = Union[dict[str, Union[str, Sequence[str], dict[str, Any]]], str, Sequence[str]]  # {"Feed": ["Edge5"]}
Local = Union[dict[Union[str, tuple[str, ...]], Union[Length, Medium]], str, Sequence[str]]  # {"Face3": "2 mm"}
Path = Union[str, os.PathLike[str]]
Shape = Any  # Part.Shape, or an object of a FreeCAD document
Source = Union[Model, Shape, Sequence[Shape], Path, bytes, bytearray, memoryview]
Progress = Callable[[str, float], Optional[bool]]
Point = tuple[float, float, float]

class Error(Exception):
    code: str
    face: Optional[str]
    edge: Optional[str]
    point: Optional[Point]
    stage: str
    remedy: str
    def __init__(self, text: str, code: str = ..., remedy: str = ..., stage: str = ..., face: Optional[str] = ...,
                 edge: Optional[str] = ..., point: Optional[Point] = ...) -> None: ...

class OptionError(Error, ValueError): ...
class InputError(Error): ...
class LimitError(Error): ...
class OutputError(Error): ...
class Cancelled(Error): ...

class FaceError(Error):
    faces: tuple[str, ...]
    result: Optional[Result]

class OutOfMemory(Error, MemoryError): ...
class InternalError(Error, RuntimeError): ...
class Cancel(threading.Event): ...

class Prediction(NamedTuple):
    target_length: float
    elements: float
    memory_mib: float
    face_elements: NDArray[np.float64]
    merges: list[dict[str, Any]]
    contacts: list[dict[str, Any]]

class Part(NamedTuple):
    faces: NDArray[np.int32]
    edges: NDArray[np.int32]
    vertices: NDArray[np.int32]
    solids: NDArray[np.int32]

class ElementQuality(NamedTuple):
    sj: NDArray[np.float64]
    jacobian_ratio: NDArray[np.float64]
    area: NDArray[np.float64]
    validity: NDArray[np.int8]

class Tessellation(NamedTuple):
    points: NDArray[np.float32]
    normals: NDArray[np.float32]
    triangles: NDArray[np.int32]
    triangle_indices: NDArray[np.int32]
    triangle_elements: NDArray[np.int32]
    outlines: NDArray[np.int32]
    outline_indices: NDArray[np.int32]
    outline_edges: NDArray[np.int32]
    outline_elements: NDArray[np.int32]

class SurfaceMesh:
    def __init__(self, order: int, nodes: NDArray[np.float64], quads: NDArray[np.int32], triangles: NDArray[np.int32],
                 quad_faces: NDArray[np.int32], triangle_faces: NDArray[np.int32], lines: NDArray[np.int32],
                 line_edges: NDArray[np.int32], points: NDArray[np.int32] = ...) -> None: ...
    def write(self, path: Path, *, face_names: Sequence[str] = (), edge_names: Sequence[str] = (),
              edge_groups: Sequence[str] = (), point_names: Sequence[str] = (),
              volumes: Sequence[tuple[str, str, Sequence[int]]] = (),
              msh_version: Literal["4.1", "2.2"] = "4.1", ascii: bool = False, progress: Optional[Progress] = None,
              cancel: Optional[threading.Event] = None) -> None: ...
    def quality(self) -> ElementQuality: ...
    def tessellate(self, subdivision: int = 2, apart: bool = False) -> Tessellation: ...

class PickTree:
    def __init__(self, tessellation: Tessellation) -> None: ...
    def hits(self, origin: Sequence[float], direction: Sequence[float]) -> list[tuple[int, float]]: ...

class Model:
    name: str
    path: str
    def __init__(self, shape: Source, name: Optional[str] = None, labels: Optional[list[str]] = None) -> None: ...
    def parts(self, progress: Optional[Progress] = None, cancel: Optional[threading.Event] = None) -> list[Part]: ...

class Result:
    @property
    def order(self) -> int: ...
    @property
    def nodes(self) -> NDArray[np.float64]: ...
    @property
    def quads(self) -> NDArray[np.int32]: ...
    @property
    def triangles(self) -> NDArray[np.int32]: ...
    @property
    def lines(self) -> NDArray[np.int32]: ...
    @property
    def quad_faces(self) -> NDArray[np.int32]: ...
    @property
    def triangle_faces(self) -> NDArray[np.int32]: ...
    @property
    def line_edges(self) -> NDArray[np.int32]: ...
    @property
    def further_edges(self) -> NDArray[np.int32]: ...
    @property
    def node_edges(self) -> NDArray[np.int32]: ...
    @property
    def points(self) -> NDArray[np.int32]: ...
    @property
    def node_targets(self) -> NDArray[np.float64]: ...
    @property
    def face_names(self) -> list[str]: ...
    @property
    def face_groups(self) -> list[str]: ...
    @property
    def volumes(self) -> list[tuple[str, str, list[int]]]: ...
    @property
    def edge_groups(self) -> list[str]: ...
    @property
    def point_names(self) -> list[str]: ...
    @property
    def edge_names(self) -> list[str]: ...
    @property
    def report(self) -> dict[str, Any]: ...
    @property
    def table(self) -> str: ...
    @property
    def failed_faces(self) -> dict[str, str]: ...
    @property
    def parts(self) -> list[Part]: ...
    def quality(self) -> ElementQuality: ...
    def tessellate(self, subdivision: int = 2, apart: bool = False) -> Tessellation: ...
    def write(self, path: Optional[Path] = None, *, report: Optional[Path] = None,
              msh_version: Literal["4.1", "2.2"] = "4.1", ascii: bool = False, progress: Optional[Progress] = None,
              cancel: Optional[threading.Event] = None) -> None: ...

def mesh(shape: Source, *, size: Optional[Length] = None, frequency: Optional[Frequency] = None,
         divisions: Optional[float] = None, eps_r: Optional[float] = None, mu_r: Optional[float] = None,
         max_turn: Optional[Angle] = None, aspect: Optional[float] = None, gradation: Optional[float] = None, tip: Optional[float] = None, grade_edges: Optional[float] = None,
         gap: Optional[Literal["one", "refine:2", "refine:3", "refine:4", "refine:5", "refine:6", "refine:7", "refine:8"]] = None,
         chord_error: Optional[Length] = None,
         local: Optional[Local] = None, max_elements: Optional[int] = None, medium: Optional[Named] = None,
         port: Optional[Named] = None, wire: Optional[Named] = None, merge: Optional[float] = None, merge_width: Optional[float] = None, order: Optional[int] = None,
         elements: Optional[Literal["quad-dominant", "all-quad", "all-triangle"]] = None,
         multilevel: Optional[Literal["off", "auto", "4", "5", "6", "7", "8"]] = None,
         threads: Optional[int] = None, ranks: Optional[int] = None,
         connect: Optional[Literal["imprint", "union", "none"]] = None, sew_tolerance: Optional[Length] = None,
         strict: Optional[bool] = None, output: Optional[Path] = None, report: Optional[Path] = None,
         repaired: Optional[Path] = None, msh_version: Literal["4.1", "2.2"] = "4.1",
         ascii: bool = False, quiet: bool = True, partial: bool = False, progress: Optional[Progress] = None,
         cancel: Optional[threading.Event] = None, name: Optional[str] = None) -> Result: ...
def predict(shape: Source, *, size: Optional[Length] = None, frequency: Optional[Frequency] = None,
            divisions: Optional[float] = None, eps_r: Optional[float] = None, mu_r: Optional[float] = None,
            max_turn: Optional[Angle] = None, aspect: Optional[float] = None, gradation: Optional[float] = None, tip: Optional[float] = None, grade_edges: Optional[float] = None,
         gap: Optional[Literal["one", "refine:2", "refine:3", "refine:4", "refine:5", "refine:6", "refine:7", "refine:8"]] = None,
         chord_error: Optional[Length] = None,
            local: Optional[Local] = None, max_elements: Optional[int] = None, medium: Optional[Named] = None,
         port: Optional[Named] = None, wire: Optional[Named] = None, merge: Optional[float] = None, merge_width: Optional[float] = None, order: Optional[int] = None,
            elements: Optional[Literal["quad-dominant", "all-quad", "all-triangle"]] = None,
            multilevel: Optional[Literal["off", "auto", "4", "5", "6", "7", "8"]] = None,
            threads: Optional[int] = None, ranks: Optional[int] = None,
            connect: Optional[Literal["imprint", "union", "none"]] = None, sew_tolerance: Optional[Length] = None,
            strict: Optional[bool] = None, progress: Optional[Progress] = None, cancel: Optional[threading.Event] = None,
            name: Optional[str] = None) -> Prediction: ...
def target_lengths(shape: Source, faces: object, uv: object, points: object, *, size: Optional[Length] = None, frequency: Optional[Frequency] = None,
            divisions: Optional[float] = None, eps_r: Optional[float] = None, mu_r: Optional[float] = None,
            max_turn: Optional[Angle] = None, aspect: Optional[float] = None, gradation: Optional[float] = None, tip: Optional[float] = None, grade_edges: Optional[float] = None,
         gap: Optional[Literal["one", "refine:2", "refine:3", "refine:4", "refine:5", "refine:6", "refine:7", "refine:8"]] = None,
         chord_error: Optional[Length] = None,
            local: Optional[Local] = None, max_elements: Optional[int] = None, medium: Optional[Named] = None,
         port: Optional[Named] = None, wire: Optional[Named] = None, merge: Optional[float] = None, merge_width: Optional[float] = None, order: Optional[int] = None,
            elements: Optional[Literal["quad-dominant", "all-quad", "all-triangle"]] = None,
            multilevel: Optional[Literal["off", "auto", "4", "5", "6", "7", "8"]] = None,
            threads: Optional[int] = None, ranks: Optional[int] = None,
            connect: Optional[Literal["imprint", "union", "none"]] = None, sew_tolerance: Optional[Length] = None,
            strict: Optional[bool] = None, progress: Optional[Progress] = None, cancel: Optional[threading.Event] = None,
            name: Optional[str] = None) -> object: ...
def options() -> list[dict[str, Any]]: ...
