#!/usr/bin/python3
"""Draws a .msh or .vtu file as a picture: curved element edges, hidden surfaces removed, coloured by scaled Jacobian.

    scripts/render.py MESH PICTURE.png [--view iso|x|y|z|-x|-y|-z|AZIMUTH,ELEVATION] [--size 1600x1200]
                      [--zoom 4] [--at X,Y,Z] [--title TEXT] [--no-edges]

A planar mesh is looked at straight on unless --view says otherwise; angles are degrees. Elements whose scaled Jacobian
is not positive are magenta. --zoom enlarges about --at (default: the middle of the mesh). Edges of the CAD model are
drawn thicker; a .vtu file does not have them.
"""
import argparse
import math
import os
import sys

import numpy as np
from PIL import Image, ImageDraw, ImageFont

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import meshfile  # noqa: E402, makes the workbench's readers known
from paver_wb.formats import raw_mesh, read_vtu  # noqa: E402

VIEWS = {"iso": (-55, 28), "x": (0, 0), "y": (90, 0), "z": (-90, 90), "-x": (180, 0), "-y": (-90, 0), "-z": (-90, -90)}
LARGEST = 20000     # pixels, each way

OVERSAMPLE = 2      # pixels computed per pixel shown, each way
PIECE = 12.0        # wished size of the flat pieces an element is drawn with, in computed pixels
BACKGROUND = (255, 255, 255)
COLOURS = np.array([[165, 0, 38], [222, 63, 46], [249, 142, 82], [254, 212, 130], [244, 250, 176], [189, 228, 218],
                    [128, 182, 214], [84, 129, 189]], float)  # SJ 0 ... 1
INVERTED = (255, 0, 255)
FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"


# Shape functions: parameters (s, t) in [0, 1] (triangles: s + t <= 1) to weights of the nodes in Gmsh's order.

def line_weights(s, order):
    if order == 1:
        return np.stack([1 - s, s], 1)
    return np.stack([(1 - s) * (1 - 2 * s), s * (2 * s - 1), 4 * s * (1 - s)], 1)


def quad_weights(s, t, order):
    a, b = line_weights(s, order), line_weights(t, order)
    at = [(0, 0), (1, 0), (1, 1), (0, 1)]  # 0: start, 1: end, 2: middle
    if order == 2:
        at += [(2, 0), (1, 2), (2, 1), (0, 2), (2, 2)]
    return np.stack([a[:, i] * b[:, j] for i, j in at], 1)


def triangle_weights(s, t, order):
    r = 1 - s - t
    if order == 1:
        return np.stack([r, s, t], 1)
    return np.stack([r * (2 * r - 1), s * (2 * s - 1), t * (2 * t - 1), 4 * r * s, 4 * s * t, 4 * t * r], 1)


def quad_pieces(n, order):
    """Weights of the (n+1)^2 points of a quad cut n x n, and its flat triangles."""
    s, t = (g.ravel() for g in np.meshgrid(np.linspace(0, 1, n + 1), np.linspace(0, 1, n + 1)))
    a = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    triangles = np.concatenate([np.stack([a, a + 1, a + n + 2], 1), np.stack([a, a + n + 2, a + n + 1], 1)])
    return quad_weights(s, t, order), triangles


def triangle_pieces(n, order):
    at = [(i, j) for j in range(n + 1) for i in range(n + 1 - j)]
    number = {ij: k for k, ij in enumerate(at)}
    triangles = []
    for i, j in at:
        if i + j < n:
            triangles.append((number[i, j], number[i + 1, j], number[i, j + 1]))
        if i + j < n - 1:
            triangles.append((number[i + 1, j], number[i + 1, j + 1], number[i, j + 1]))
    s, t = np.array(at, float).T / n
    return triangle_weights(s, t, order), np.array(triangles)


class Canvas:
    """Depth, element number and light of the nearest surface per pixel. x right, y up, z towards the eye."""

    def __init__(self, width, height):
        self.width, self.height = width, height
        self.depth = np.full(width * height, -np.inf)
        self.element = np.full(width * height, -1, np.int64)
        self.light = np.zeros(width * height)

    def put(self, pixel, z, element, light):
        """Keeps, per pixel, the nearest of what is there and what comes; pixels may come more than once."""
        better = z > self.depth[pixel]
        while better.any():
            pixel, z, element, light = pixel[better], z[better], element[better], light[better]
            self.depth[pixel] = z
            won = self.depth[pixel] == z
            self.element[pixel[won]], self.light[pixel[won]] = element[won], light[won]
            better = z > self.depth[pixel]

    def draw(self, p, element):
        """Triangles p (n x 3 corners x 3, in pixels), row of pixels by row of pixels."""
        normal = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
        length = np.linalg.norm(normal, axis=1)
        low = np.maximum(np.ceil(p[:, :, 1].min(1) - 0.5), 0).astype(int)
        high = np.minimum(np.floor(p[:, :, 1].max(1) - 0.5), self.height - 1).astype(int)
        keep = (np.abs(normal[:, 2]) > 1e-9 * np.maximum(length, 1e-300)) & (high >= low)
        p, normal, element, length, low, high = (a[keep] for a in (p, normal, element, length, low, high))
        light = np.abs(normal[:, 2]) / length
        of, iy = spread(low, high - low + 1)

        # Each row's part inside the triangle: between the crossings of its sides with the middle of the row.
        y = iy + 0.5
        left, right = np.full(len(of), -np.inf), np.full(len(of), np.inf)
        sign = np.sign(normal[:, 2])
        for k in range(3):
            a, side = p[:, k], p[:, (k + 1) % 3] - p[:, k]
            inwards = (-sign * side[:, 1])[of]  # > 0: the inside lies to the right
            with np.errstate(divide="ignore", invalid="ignore"):
                x = (a[:, 0] - a[:, 1] * side[:, 0] / side[:, 1])[of] + y * (side[:, 0] / side[:, 1])[of]
            left = np.where(inwards > 0, np.fmax(left, x), left)
            right = np.where(inwards < 0, np.fmin(right, x), right)
        first = np.maximum(np.ceil(left - 0.5 - 1e-6), 0).astype(int)
        last = np.minimum(np.floor(right - 0.5 + 1e-6), self.width - 1).astype(int)
        row, ix = spread(first, np.maximum(last - first + 1, 0))
        slope_x, slope_y = -normal[:, 0] / normal[:, 2], -normal[:, 1] / normal[:, 2]
        base = (p[:, 0, 2] - p[:, 0, 0] * slope_x - p[:, 0, 1] * slope_y)[of] + y * slope_y[of]
        of_pixel = of[row]
        z = base[row] + (ix + 0.5) * slope_x[of_pixel]
        self.put(iy[row] * self.width + ix, z, element[of_pixel], light[of_pixel])


def spread(first, count):
    """For i with `count[i]` members: i repeated, and first[i], first[i] + 1, ..."""
    of = np.repeat(np.arange(len(count)), count)
    start = np.cumsum(count) - count
    return of, np.arange(len(of)) - start[of] + first[of]


def view_axes(angles, mesh):
    """Rows: right, up, towards the eye, which stands at (azimuth, elevation) in degrees."""
    normal = plane_normal(mesh.nodes) if angles is None else None
    if normal is not None:
        eye = normal if normal[np.abs(normal).argmax()] > 0 else -normal
        angles = np.degrees([np.arctan2(eye[1], eye[0]), np.arcsin(np.clip(eye[2], -1, 1))])
        if abs(eye[2]) > 1 - 1e-9:
            angles[0] = -90
    a, e = np.radians(VIEWS["iso"] if angles is None else angles)
    right = np.array([-np.sin(a), np.cos(a), 0])
    eye = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    return np.array([right, np.cross(eye, right), eye])


def plane_normal(nodes):
    """Unit normal when all nodes lie in a plane, else None."""
    centred = nodes - nodes.mean(0)
    _, values, axes = np.linalg.svd(centred, full_matrices=False)
    return axes[2] if values[2] <= 1e-9 * values[0] else None


def project(mesh, axes, width, height, zoom, at):
    """Nodes in computed pixels, fitted into the picture with room for bar and title."""
    p = mesh.nodes @ axes.T
    lo, hi = p.min(0), p.max(0)
    middle = (lo + hi) / 2 if at is None else np.asarray(at) @ axes.T
    span = np.maximum(hi - lo, 1e-300)
    scale = zoom * min(0.84 * width / span[0], 0.84 * height / span[1])
    return (p - middle) * scale + (0.46 * width, 0.49 * height, 0)


def draw_faces(canvas, mesh, p):
    """All elements, each cut as finely as its size in the picture asks for."""
    first = 0
    for rows, corners, cut in ((mesh.quads, 4, quad_pieces), (mesh.triangles, 3, triangle_pieces)):
        if len(rows):
            box = np.ptp(p[rows][:, :, :2], axis=1).max(1)
            off = ((p[rows][:, :, :2].max(1) < 0) | (p[rows][:, :, :2].min(1) > (canvas.width, canvas.height))).any(1)
            n = np.clip(np.ceil(box / PIECE), 1, 512)
            if mesh.order > 1:
                n = np.maximum(n, 2)
            n = 2**np.ceil(np.log2(n)).astype(int)
            for k in np.unique(n):
                weights, triangles = cut(k, mesh.order)
                chosen = np.flatnonzero((n == k) & ~off)
                for part in np.array_split(chosen, max(1, len(chosen) * len(triangles) // 400_000)):
                    points = np.einsum("wk,ekc->ewc", weights, p[rows[part]])
                    number = np.repeat(first + part, len(triangles))
                    canvas.draw(points[:, triangles].reshape(-1, 3, 3), number)
        first += len(rows)


def draw_lines(canvas, p, rows, element, order, radius, mask):
    """Marks in `mask` the pixels of the lines `rows` where they are not hidden: a pixel counts as visible when the
    line's own element (or, with element None, anything no nearer than the line) is what the pixel or one beside it
    shows."""
    pixels = np.linalg.norm(np.diff(p[rows[:, :2]][:, :, :2], axis=1)[:, 0], axis=1)
    n = 2**np.ceil(np.log2(np.clip(2 * pixels, 8, 4096))).astype(int)
    image = canvas.element.reshape(canvas.height, canvas.width)
    depth = canvas.depth.reshape(canvas.height, canvas.width)
    for k in np.unique(n):
        chosen = np.flatnonzero(n == k)
        for part in np.array_split(chosen, max(1, len(chosen) * k // 2_000_000)):
            points = np.einsum("wk,ekc->ewc", line_weights(np.linspace(0, 1, k + 1), order), p[rows[part]])
            points = points.reshape(-1, 3)
            ix, iy = np.floor(points[:, 0]).astype(int), np.floor(points[:, 1]).astype(int)
            seen = (ix >= 2) & (iy >= 2) & (ix < canvas.width - 2) & (iy < canvas.height - 2)
            ix, iy, z = ix[seen], iy[seen], points[seen, 2]
            own = np.repeat(element[part], k + 1)[seen]
            visible = np.zeros(len(ix), bool)
            for dx, dy in ((0, 0), (1, 0), (-1, 0), (0, 1), (0, -1)):
                visible |= image[iy + dy, ix + dx] == own
                visible |= np.abs(depth[iy + dy, ix + dx] - z) < 1.5
            mark(mask, ix[visible], iy[visible], radius)


def mark(mask, ix, iy, radius):
    height, width = mask.shape
    reach = int(np.ceil(radius))
    for dx in range(-reach, reach + 1):
        for dy in range(-reach, reach + 1):
            if dx * dx + dy * dy <= radius * radius:
                mask[np.clip(iy + dy, 0, height - 1), np.clip(ix + dx, 0, width - 1)] = True


def colours(sj):
    at = np.clip(sj, 0, 1) * (len(COLOURS) - 1)
    table = np.stack([np.interp(at, np.arange(len(COLOURS)), COLOURS[:, c]) for c in range(3)], 1)
    table[sj <= 0] = INVERTED
    return table


def font(size):
    try:
        return ImageFont.truetype(FONT, size)
    except OSError:
        return ImageFont.load_default()


def draw_legend(image, lines):
    """Colour bar on the right, text on the top left."""
    draw = ImageDraw.Draw(image)
    width, height = image.size
    text = font(max(11, height // 60))
    x, top, tall, wide = int(0.93 * width), int(0.25 * height), int(0.5 * height), max(8, width // 70)
    for i in range(tall):
        colour = colours(np.array([max(1 - i / tall, 1e-9)]))[0]
        draw.line([(x, top + i), (x + wide, top + i)], fill=tuple(int(c) for c in colour))
    for value in (0, 0.2, 0.4, 0.6, 0.8, 1):
        draw.text((x + wide + 5, top + (1 - value) * tall), f"{value:g}", fill=(0, 0, 0), font=text, anchor="lm")
    draw.text((x, top - height // 40), "SJ", fill=(0, 0, 0), font=text, anchor="lm")
    for i, line in enumerate(lines):
        draw.text((width // 80, height // 80 + i * (height // 42)), line, fill=(0, 0, 0), font=text)


def render(mesh, view=None, size=(1600, 1200), zoom=1.0, at=None, title="", edges=True):
    """The picture as a PIL image."""
    width, height = (OVERSAMPLE * s for s in size)
    p = project(mesh, view_axes(view, mesh), width, height, zoom, at)
    canvas = Canvas(width, height)
    draw_faces(canvas, mesh, p)

    sj = np.concatenate(meshfile.scaled_jacobian(mesh))
    pixels = np.full((height * width, 3), BACKGROUND, np.uint8)
    drawn = np.flatnonzero(canvas.element >= 0)
    shade = 0.55 + 0.45 * canvas.light[drawn, None]
    pixels[drawn] = colours(sj)[canvas.element[drawn]] * shade
    pixels = pixels.reshape(height, width, 3)
    if edges:
        mask = np.zeros((height, width), bool)
        rows, element = meshfile.sides(mesh)
        typical = np.median(np.linalg.norm(np.diff(p[rows[:, :2]][:, :, :2], axis=1)[:, 0], axis=1))
        draw_lines(canvas, p, rows, element, mesh.order, 1 if typical > 14 else 0, mask)
        pixels[mask] = pixels[mask] // 4
        if len(mesh.lines):
            mask[:] = False
            draw_lines(canvas, p, mesh.lines, np.full(len(mesh.lines), -2), mesh.order, 2 if typical > 14 else 1, mask)
            pixels[mask] = (0, 0, 0)
    image = Image.fromarray(pixels[::-1]).resize(size, Image.BOX)
    counts = f"{len(mesh.quads)} quads, {len(mesh.triangles)} triangles, order {mesh.order}"
    figures = f"SJ min {sj.min():.3f}, mean {sj.mean():.3f}" if len(sj) else ""
    draw_legend(image, [line for line in (title, counts, figures) if line])
    return image


def read(path):
    """The mesh of a .msh or .vtu file; ValueError says why there is none."""
    if not path.lower().endswith(".vtu"):
        mesh = meshfile.read(path)
        if len(mesh.quads) + len(mesh.triangles) == 0:
            raise ValueError("it has no triangles and no quads")
        return mesh
    with open(path, "rb") as f:
        found = raw_mesh.tables(read_vtu.read(f.read()))
    return meshfile.Mesh(order=found.order, nodes=found.nodes, quads=found.quads, quad_tag=found.quad_faces,
                         triangles=found.triangles, triangle_tag=found.triangle_faces,
                         lines=np.zeros((0, found.order + 1), np.int64), line_tag=np.zeros(0, np.int64))


def numbers(text, count):
    """`count` finite numbers between commas, or None."""
    try:
        found = [float(part) for part in text.split(",")]
    except ValueError:
        return None
    return found if len(found) == count and all(map(math.isfinite, found)) else None


def view(text):
    angles = VIEWS.get(text) or numbers(text, 2)
    if angles is None:
        raise argparse.ArgumentTypeError(f"there is no view '{text}'; there are {', '.join(VIEWS)} and AZIMUTH,ELEVATION"
                                         " in degrees, e.g. 30,20.")
    return angles


def picture_size(text):
    sides = text.split("x")
    if len(sides) != 2 or not all(side.isdecimal() and 1 <= int(side) <= LARGEST for side in sides):
        raise argparse.ArgumentTypeError(f"'{text}' is no size; write WIDTHxHEIGHT in pixels, each up to {LARGEST}, "
                                         "e.g. 1600x1200.")
    return int(sides[0]), int(sides[1])


def point(text):
    found = numbers(text, 3)
    if found is None:
        raise argparse.ArgumentTypeError(f"'{text}' is no point; write X,Y,Z in mm, e.g. 10,0,-2.5.")
    return found


def zoom(text):
    found = numbers(text, 1)
    if found is None or found[0] <= 0:
        raise argparse.ArgumentTypeError(f"'{text}' is no enlargement; write a number above 0, e.g. 4.")
    return found[0]


class Parser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(2, f"render: {message.rstrip('.')}.\n")


def joined(arguments):
    """--view -x as --view=-x: what begins with - would be an option."""
    found = []
    for argument in arguments:
        if found and found[-1] in ("--view", "--at", "--zoom"):
            found[-1] += "=" + argument
        else:
            found.append(argument)
    return found


def main():
    parser = Parser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh")
    parser.add_argument("picture")
    parser.add_argument("--view", type=view)
    parser.add_argument("--size", default="1600x1200", type=picture_size)
    parser.add_argument("--zoom", default=1.0, type=zoom)
    parser.add_argument("--at", type=point)
    parser.add_argument("--title")
    parser.add_argument("--no-edges", action="store_true")
    a = parser.parse_args(joined(sys.argv[1:]))
    title = os.path.basename(a.mesh) if a.title is None else a.title
    path = a.mesh
    try:
        mesh = read(a.mesh)
        image = render(mesh, a.view, a.size, a.zoom, a.at, title, not a.no_edges)
        path = a.picture
        image.save(a.picture)
    except (OSError, ValueError) as error:
        sys.exit(f"render: {path}: {getattr(error, 'strerror', None) or error}.")


if __name__ == "__main__":
    main()
