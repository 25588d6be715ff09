"""One meshing as data: what a run needs and what it gives. Knows nothing of documents, so that it runs in any thread, and
in a process without FreeCAD."""
from typing import NamedTuple

from paver_wb import core
from paver_wb.formats import mesh_file
from paver_wb.formats.mesh_file import BOTH


class Job(NamedTuple):
    """What a run needs.

    shape: FreeCAD's binary stream of all that is meshed, each where it stands; name: of it, in messages; labels: of its
        faces, "Ground plane/Face3", none of a single object.
    options: as paver.mesh takes them.
    sources: names of the objects in the shape, in its order.
    digest: of the shape; decisive: text that is equal for equal options.
    """

    shape: bytes
    name: str
    labels: list
    options: dict
    sources: tuple
    digest: str
    decisive: str

    def model(self):
        """A paver.Model of the shape."""
        return core.load().Model(self.shape, self.name, self.labels)


class Place(NamedTuple):
    """A face or an edge of a source: its number in Job.sources, and "Face3" or "Edge7" of it."""

    source: int
    element: str


def face_names(sources, result):
    """Names of groups: "Face3" of a single source, "Box_Face3" where several are meshed together; "Box_Face3 + Rod_Face1"
    for what these have in common."""
    names = [face["name"] for face in result.report["faces"]]
    if len(sources) < 2:
        return names
    own = {}
    for source, part in reversed(list(zip(sources, result.parts))):  # the first one names what several share
        for number, face in enumerate(part.faces):
            own[f"Face{face + 1}"] = f"{source}_Face{number + 1}"
    return [BOTH.join(own.get(face, face) for face in name.split(BOTH)) for name in names]


def place_of(model, error):
    """Where in the sources an error is; None when it names neither a face nor an edge of them."""
    for kind, name in (("Face", error.face and error.face.split(BOTH)[0]), ("Edge", error.edge)):
        if not name or not name[len(kind):].isdigit():
            continue
        number = int(name[len(kind):]) - 1
        for source, part in enumerate(model.parts()):
            found = (part.faces if kind == "Face" else part.edges).tolist()
            if number in found:
                return Place(source, f"{kind}{found.index(number) + 1}")
    return None


def failures(job, mesh):
    """[(Place, reason)] of the faces that a StoredMesh of the job lacks."""
    found = []
    for i, face in enumerate(mesh.report["faces"]):
        if face["status"] == "failed":
            source, element = place_of_name(job.sources, mesh.face_names[i])
            found.append((Place(source, element), face["reason"]))
    return found


def place_of_name(sources, name):
    """(number of the source, "Face3") of a name that face_names made."""
    name = name.split(BOTH)[0]
    for number, source in enumerate(sources):
        element = name[len(source) + 1:]
        if len(sources) > 1 and name.startswith(source + "_Face") and element[4:].isdigit():
            return number, element
    return 0, name


def run(job, progress=None, cancel=None, model=None):
    """paver.Result of a job. Faces that fail are left out.

    model: the one of the job, where it was read before. FaceError when no face can be meshed; other errors as
    paver.mesh has them. Each error has the Place it is at as `.place`.
    """
    paver = core.load()
    model = model or job.model()
    try:
        result = paver.mesh(model, progress=progress, cancel=cancel, partial=True, **job.options)
        if len(result.quads) + len(result.triangles) == 0:
            result._data.check()
        return result
    except paver.Error as error:
        error.place = place_of(model, error)
        raise


def stored(job, result):
    """The StoredMesh of a job's result."""
    return mesh_file.of_result(result, face_names(job.sources, result))


def store(job, path, progress, cancel=None, model=None):
    """The StoredMesh of a job, written to `path` too. Arguments and errors as those of run()."""
    made = stored(job, run(job, progress, cancel, model))
    progress(core.stages()[-1][0], 0.0)
    mesh_file.write(made, path)
    return made
