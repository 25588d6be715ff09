"""Cross-sections of bodies of revolution, by Fourier's series about the axis: an independent check of the solver.

The same equation and Galerkin test as src/moments, but without a mesh of the surface: a generator of straight segments,
along it T / rho with T linear between nodes, about the axis constants on segments [Mautz69]; every mode is a small matrix.
"""
import numpy as np
from scipy.special import jv

ETA = 376.730313668
NEAR = 3         # segments nearer than so many lengths have finer rules
CUT = np.pi / 8  # of the angle about the axis: below it steps follow the distance


def _gauss(count, start=0.0, end=1.0):
    x, w = np.polynomial.legendre.leggauss(count)
    return start + (end - start) * (x + 1) / 2, w * (end - start) / 2


def _rules():
    """(s, s', weight) over two segments that are the same, follow each other, are near."""
    x, wx = _gauss(10)
    y, wy = _gauss(6)
    u, v = np.meshgrid(x ** 3, y, indexing="ij")  # u: |s - s'|, about which the kernel is a logarithm
    w = (np.outer(3 * x * x * wx, wy) * (1 - u)).ravel()
    low, high = ((1 - u) * v).ravel(), ((1 - u) * v + u).ravel()
    same = np.r_[low, high], np.r_[high, low], np.r_[w, w]
    r, share = np.meshgrid(x ** 2, y, indexing="ij")  # of the distance from the common end
    w = (np.outer(2 * x * wx, wy) * r).ravel()
    one, other = r.ravel(), (r * share).ravel()
    following = 1 - np.r_[one, other], np.r_[other, one], np.r_[w, w]
    s, t = (a.ravel() for a in np.meshgrid(y, y, indexing="ij"))
    return {"same": same, "following": following, "near": (s, t, np.outer(wy, wy).ravel())}


def kernels(rho, z, rho2, z2, k, modes):
    """(modes, n): integrals of exp(-jkR) / 4 pi R cos(m angle) over all angles, between circles of those radii and places."""
    found = np.empty((modes, len(rho)), complex)
    wide, weights = _gauss(3 * modes, CUT, np.pi)
    cosines = np.cos(np.outer(wide, np.arange(modes))) * (weights / (2 * np.pi))[:, None]
    steps, step_weights = _gauss(28)
    for at in range(0, len(rho), 20_000):
        part = slice(at, at + 20_000)
        squares = (rho[part] - rho2[part]) ** 2 + (z[part] - z2[part]) ** 2
        product = rho[part] * rho2[part]
        r = np.sqrt(squares[:, None] + 4 * product[:, None] * np.sin(wide / 2) ** 2)
        value = (np.exp(-1j * k * r) / r) @ cosines
        width = np.sqrt(squares / product)  # angle = width sinh(u): even steps where the distance grows
        last = np.arcsinh(CUT / width)
        angle = width[:, None] * np.sinh(last[:, None] * steps)
        r = np.sqrt(squares[:, None] + 4 * product[:, None] * np.sin(angle / 2) ** 2)
        narrow = np.exp(-1j * k * r) / r * np.sqrt(angle ** 2 + width[:, None] ** 2) * last[:, None] * step_weights / (2 * np.pi)
        twice, before, now = 2 * np.cos(angle), np.cos(angle), np.ones_like(angle)
        for m in range(modes):
            found[m, part] = value[:, m] + np.einsum("ij,ij->i", narrow, now)
            before, now = now, twice * now - before
    return found


class Generator:
    """Nodes (n, 2), place along the axis and radius, from axis to axis."""

    def __init__(self, nodes):
        self.nodes, self.count = nodes, len(nodes) - 1
        step = np.diff(nodes, axis=0)
        self.length = np.hypot(*step.T)
        self.along, self.out = (step / self.length[:, None]).T  # of the direction: parts along the axis and away from it

    def at(self, segment, s):
        """(place along the axis, radius) at the shares s of segments."""
        return (self.nodes[segment] * (1 - s)[:, None] + self.nodes[segment + 1] * s[:, None]).T

    def pairs(self):
        """{kind of pair: (first, second segments)}, first <= second; far ones are left out."""
        middle = (self.nodes[1:] + self.nodes[:-1]) / 2
        distance = np.hypot(*(middle[:, None] - middle[None]).transpose(2, 0, 1))
        is_near = np.triu(distance < NEAR * np.maximum.outer(self.length, self.length), 2)
        every = np.arange(self.count)
        return {"same": (every, every), "following": (every[:-1], every[1:]), "near": np.nonzero(is_near)}


class Points:
    """Both ends of pairs of points with their weights, and what functions are there, as sparse columns."""

    def __init__(self, generator, first, second, s, t, weight):
        g = generator
        self.weight = weight * g.length[first] * g.length[second]
        self.place = g.at(first, s), g.at(second, t)
        self.segments, self.shares = (first, second), (s, t)
        self.tangent_out = g.out[first] * g.out[second]
        self.tangent_along = g.along[first] * g.along[second]


def _near_points(generator):
    for kind, (first, second) in generator.pairs().items():
        s, t, w = _rules()[kind]
        count, n = len(first), len(s)
        yield Points(generator, np.repeat(first, n), np.repeat(second, n), np.tile(s, count), np.tile(t, count), np.tile(w, count))


def _far_points(generator):
    n = generator.count
    is_far = np.triu(np.ones((n, n), bool))
    for first, second in generator.pairs().values():
        is_far[first, second] = False
    first, second = np.nonzero(is_far)
    x, w = _gauss(2)
    for i in range(2):
        for j in range(2):
            yield Points(generator, first, second, np.full(len(first), x[i]), np.full(len(first), x[j]),
                         np.full(len(first), w[i] * w[j]))


def matrices(generator, k, modes):
    """(modes, 2n - 1, 2n - 1): one matrix of each mode; first the functions along the generator, then those about the axis."""
    n = generator.count
    size, factor = 2 * n + 1, 2j * np.pi * k * ETA
    total = np.zeros((modes, size, size), complex)  # with both nodes on the axis, which have no function
    for points in [*_near_points(generator), *_far_points(generator)]:
        g = kernels(points.place[0][1], points.place[0][0], points.place[1][1], points.place[1][0], k, modes + 1) * points.weight
        for m in range(modes):
            _add(total[m], generator, points, g[m], g[abs(m - 1)], g[m + 1], k, m)
    # Every pair has been added once, the first before the second: the other order follows by symmetry.
    sign = np.where(np.arange(size) <= n, 1, -1)
    total = factor * (total + total.transpose(0, 2, 1) * np.outer(sign, sign))
    keep = np.r_[1:n, n + 1:size]
    return total[:, keep][:, :, keep]


def _add(matrix, generator, points, g, below, above, k, m):
    """Adds the pairs of points; those on one segment, whose rule has both orders, by half."""
    n, (p, q), (s, t) = generator.count, points.segments, points.shares
    by = np.where(p == q, 0.5, 1.0)
    g, below, above = g * by, below * by, above * by
    even, odd = (below + above) / 2, 1j * (below - above) / 2
    rho, rho2 = points.place[0][1], points.place[1][1]
    slope, slope2 = 1 / generator.length[p], 1 / generator.length[q]
    straight = points.tangent_out * even + points.tangent_along * g

    def add(row, column, values):
        np.add(matrix, np.bincount(row * len(matrix) + column, values.real, matrix.size).reshape(matrix.shape)
               + 1j * np.bincount(row * len(matrix) + column, values.imag, matrix.size).reshape(matrix.shape), out=matrix)

    for i, a, da in ((p, 1 - s, -slope), (p + 1, s, slope)):
        for j, b, db in ((q, 1 - t, -slope2), (q + 1, t, slope2)):
            add(i, j, a * b * straight - da * db * g / k ** 2)
        add(i, n + 1 + q, -a * rho2 * generator.out[p] * odd - 1j * m * da * g / k ** 2)
    for j, b, db in ((q, 1 - t, -slope2), (q + 1, t, slope2)):
        add(n + 1 + p, j, rho * b * generator.out[q] * odd + 1j * m * db * g / k ** 2)
    add(n + 1 + p, n + 1 + q, rho * rho2 * even - m * m * g / k ** 2)


def waves(generator, k, m, angles):
    """(functions, angles, 2): moments of plane waves from `angles` to the axis, polarised in the plane with it and across."""
    n = generator.count
    x, w = _gauss(4)
    found = np.zeros((2 * n + 1, len(angles), 2), complex)
    sine, cosine = np.sin(angles), np.cos(angles)
    for share, weight in zip(x, w):
        z, rho = generator.at(np.arange(n), np.full(n, share))
        argument = k * np.outer(rho, sine)
        phase = 2 * np.pi * weight * generator.length[:, None] * np.exp(1j * k * np.outer(z, cosine))
        j0, low, high = (1j ** i * jv(i, argument) for i in (m, m - 1, m + 1))
        even, odd = (low + high) / 2 * phase, (low - high) / 2j * phase  # of cos and of sin
        out, along = generator.out[:, None], generator.along[:, None]
        for p, t in enumerate((out * cosine * even - along * sine * j0 * phase, out * odd)):
            found[:n, :, p] += (1 - share) * t
            found[1:n + 1, :, p] += share * t
        found[n + 1:, :, 0] -= rho[:, None] * cosine * odd
        found[n + 1:, :, 1] += rho[:, None] * even
    return found[np.r_[1:n, n + 1:2 * n + 1]]


def monostatic(nodes, k, angles, modes):
    """Amplitudes (angles, 2): field in the plane with the axis, and across it."""
    generator = Generator(np.asarray(nodes, float))
    sign = np.r_[np.ones(generator.count - 1), -np.ones(generator.count)]
    found = np.zeros((len(angles), 2), complex)
    for m, matrix in enumerate(matrices(generator, k, modes)):
        given = waves(generator, k, m, angles)
        current = np.linalg.solve(matrix, given.reshape(len(sign), -1)).reshape(given.shape)
        for p in range(2):
            back = given[:, :, p] * (sign if p == 0 else -sign)[:, None]
            found[:, p] += (1 if m == 0 else 2) * (back * current[:, :, p]).sum(0)
    return -1j * k * ETA / (4 * np.pi) * found
