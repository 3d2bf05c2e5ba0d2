"""B-splines of degree 1, 2 or 3 with few spans along the curves of a boundary document; for few_elements."""
import bisect
import math

SHARP = 1e-3  # radians: where tangents turn by more, a curve has a corner that every fit keeps


def blossom(degree, knot, point, span, arguments):
    """The value of the span's polar form; knot(i) and point(i) continue periodically on closed curves."""
    d = [point(span - degree + j) for j in range(degree + 1)]
    for r in range(1, degree + 1):
        for j in range(degree, r - 1, -1):
            low, high = knot(span - degree + j), knot(span + 1 + j - r)
            w = (arguments[r - 1] - low) / (high - low)
            d[j] = tuple((1 - w) * a + w * b for a, b in zip(d[j - 1], d[j]))
    return d[degree]


def spans_of(curve):
    """The Bézier polygons of a curve of a boundary document, in its direction."""
    p, knots = curve["degree"], curve["knots"]
    points = list(zip(curve["points"][::2], curve["points"][1::2]))
    m = len(points)
    if curve["closed"]:
        period = knots[-1] - knots[0]
        knot = lambda i: knots[i % m] + (i // m) * period
        point = lambda i: points[i % m]  # basis function i starts at knot i
        indices = range(m)
    else:
        knot, point, indices = knots.__getitem__, points.__getitem__, range(p, m)
    polygons = []
    for i in indices:
        a, b = knot(i), knot(i + 1)
        if a < b:
            polygons.append([blossom(p, knot, point, i, [a] * (p - k) + [b] * k) for k in range(p + 1)])
    for one, other in zip(polygons, polygons[1:] + polygons[:1] if curve["closed"] else polygons[1:]):
        one[-1] = other[0]
    return polygons


def evaluate(polygon, t):
    """Point and derivative."""
    points = list(polygon)
    while len(points) > 2:
        points = [((1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1]) for a, b in zip(points, points[1:])]
    (a, b), p = points, len(polygon) - 1
    return ((1 - t) * a[0] + t * b[0], (1 - t) * a[1] + t * b[1]), (p * (b[0] - a[0]), p * (b[1] - a[1]))


def direction(polygon, t):
    _, (x, y) = evaluate(polygon, t)
    if math.hypot(x, y) < 1e-300:
        (x, y), (u, v) = polygon[0], polygon[-1]
        x, y = u - x, v - y
    length = math.hypot(x, y)
    return x / length, y / length


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def chains_of(polygons, closed):
    """The spans between corners; a closed curve is turned so that it starts at a corner, if it has one."""
    def is_corner(one, other):
        u, v = direction(one, 1), direction(other, 0)
        return abs(math.atan2(cross(u, v), u[0] * v[0] + u[1] * v[1])) > SHARP

    if closed:
        for k in range(len(polygons)):
            if is_corner(polygons[k - 1], polygons[k]):
                polygons = polygons[k:] + polygons[:k]
                break
    chains = [[polygons[0]]]
    for one, other in zip(polygons, polygons[1:]):
        if is_corner(one, other):
            chains.append([])
        chains[-1].append(other)
    return chains


class Chain:
    """A smooth curve of several spans, run by a parameter from 0 to their number."""

    def __init__(self, polygons, per_span=12):
        self.polygons = polygons
        self.samples = []  # parameter and place
        for k, polygon in enumerate(polygons):
            self.samples += [(k + j / per_span, evaluate(polygon, j / per_span)[0]) for j in range(per_span)]
        self.samples.append((len(polygons), polygons[-1][-1]))
        self.parameters = [s for s, _ in self.samples]

    def piece(self, s):
        k = min(int(s), len(self.polygons) - 1)
        return self.polygons[k], s - k

    def place(self, s):
        return evaluate(*self.piece(s))[0]

    def tangent(self, s, from_left):
        polygon, t = self.piece(s)
        if from_left and t == 0 and s > 0:
            polygon, t = self.polygons[int(s) - 1], 1
        return direction(polygon, t)

    def between(self, s0, s1):
        """The samples of a part, and where they are less dense than 16, places evenly spread by parameter too."""
        low, high = bisect.bisect_right(self.parameters, s0), bisect.bisect_left(self.parameters, s1)
        known = self.samples[low:high]
        if len(known) >= 16:
            return [place for _, place in known]
        more = [s0 + (s1 - s0) * (j + 1) / 17 for j in range(16)]
        return [place for _, place in sorted(known + [(s, self.place(s)) for s in more])]


def nearest(polygon, t, q):
    """The parameter in [0, 1] of the place of a span nearest to q, from a guess."""
    for _ in range(4):
        (x, y), (u, v) = evaluate(polygon, t)
        square = u * u + v * v
        if square == 0:
            break
        t = min(1.0, max(0.0, t + ((q[0] - x) * u + (q[1] - y) * v) / square))
    return t


def deviation(polygon, places, limit):
    """The greatest distance of places, in their order, from a span; infinite as soon as the limit is passed."""
    most = 0
    for k, q in enumerate(places):
        (x, y), _ = evaluate(polygon, nearest(polygon, (k + 1) / (len(places) + 1), q))
        most = max(most, math.hypot(q[0] - x, q[1] - y))
        if most > limit:
            return math.inf
    return most


def fit_span(chain, s0, s1, degree):
    """A Bézier curve for a part of the chain: its ends, and for degrees 2 and 3 its end tangents; None: there is none."""
    a, b = chain.place(s0), chain.place(s1)
    if degree == 1:
        return [a, b]
    u, v = chain.tangent(s0, False), chain.tangent(s1, True)
    chord = (b[0] - a[0], b[1] - a[1])
    length = math.hypot(*chord)
    if length == 0:
        return None
    if max(abs(cross(u, chord)), abs(cross(v, chord))) < 1e-9 * length:
        if u[0] * chord[0] + u[1] * chord[1] <= 0:
            return None
        return [tuple(x + k / degree * (y - x) for x, y in zip(a, b)) for k in range(degree + 1)]
    if degree == 2:
        turn = cross(u, v)
        if abs(turn) < 1e-9:
            return None
        far, back = cross(chord, v) / turn, cross(u, chord) / turn
        if far <= 0 or back <= 0:
            return None
        return [a, (a[0] + far * u[0], a[1] + far * u[1]), b]
    # Cubic: the two handles' lengths, by least squares of the distance across the fit.
    places = chain.between(s0, s1)
    steps = [math.dist(p, q) for p, q in zip([a] + places, places + [b])]
    total, run, at = sum(steps), 0, []
    for step in steps[:-1]:
        run += step
        at.append(run / total)
    polygon = None
    for round in range(7):
        m11 = m12 = m22 = r1 = r2 = 0
        for t, q in zip(at, places):
            w1, w2 = 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t)
            w0, w3 = (1 - t) ** 3 + w1, t ** 3 + w2
            e = (q[0] - w0 * a[0] - w3 * b[0], q[1] - w0 * a[1] - w3 * b[1])
            p1, p2 = (w1 * u[0], w1 * u[1]), (-w2 * v[0], -w2 * v[1])
            if round > 0:  # only what is across the curve counts
                x, y = direction(polygon, t)
                e, p1, p2 = (cross((x, y), e), 0), (cross((x, y), p1), 0), (cross((x, y), p2), 0)
            m11 += p1[0] ** 2 + p1[1] ** 2
            m12 += p1[0] * p2[0] + p1[1] * p2[1]
            m22 += p2[0] ** 2 + p2[1] ** 2
            r1 += p1[0] * e[0] + p1[1] * e[1]
            r2 += p2[0] * e[0] + p2[1] * e[1]
        determinant = m11 * m22 - m12 * m12
        if abs(determinant) < 1e-12 * m11 * m22:
            return polygon
        far, back = (r1 * m22 - r2 * m12) / determinant, (r2 * m11 - r1 * m12) / determinant
        if far <= 0 or back <= 0:
            return polygon
        polygon = [a, (a[0] + far * u[0], a[1] + far * u[1]), (b[0] - back * v[0], b[1] - back * v[1]), b]
        at = [nearest(polygon, t, q) for t, q in zip(at, places)]
    return polygon


def fit_chain(chain, degree, tolerance, whole_loop):
    """Spans, each as long as the tolerance allows, or as ends where one of the chain's spans does, if these are fewer; then
    of much the same error, with a tolerance that is no greater."""
    def acceptable(s0, s1, limit):
        polygon = fit_span(chain, s0, s1, degree)
        if polygon is None or deviation(polygon, chain.between(s0, s1), limit) > limit:
            return None
        return polygon

    def greedy(limit, most, snaps):
        end, s, result = len(chain.polygons), 0.0, []
        step = end / 3 if whole_loop else end
        while s < end:
            if len(result) == most:
                return None
            reach = min(end, s + step)
            best = acceptable(s, reach, limit)
            if best is None:
                low, high = s, reach
                for _ in range(40):
                    middle = (low + high) / 2
                    polygon = acceptable(s, middle, limit)
                    if polygon is None:
                        high = middle
                    else:
                        low, best = middle, polygon
                    if best is not None and high - low < 0.01 * (low - s):
                        break
                if best is None:
                    raise ValueError("no span fits")
                reach = low
                whole = acceptable(s, math.floor(low), limit) if snaps and math.floor(low) > s else None
                if whole is not None:
                    best, reach = whole, math.floor(low)
            result.append(best)
            s = reach
        return result

    free, snapped = greedy(tolerance, math.inf, False), greedy(tolerance, math.inf, True)
    snaps = len(snapped) < len(free)
    spans = snapped if snaps else free
    low, high = 0, tolerance
    for _ in range(5):
        even = greedy((low + high) / 2, len(spans), snaps)
        if even is None:
            low = (low + high) / 2
        else:
            high, spans = (low + high) / 2, even
    return spans


def fit_curve(curve, degree, tolerance):
    """The curve of a boundary document with other spans: knots of multiplicity `degree`."""
    polygons = spans_of(curve)
    chains = chains_of(polygons, curve["closed"])
    spans = []
    for chain in chains:
        spans += fit_chain(Chain(chain), degree, tolerance, curve["closed"] and len(chains) == 1)
    n, points = len(spans), []
    if curve["closed"]:
        knots = [0] + [k for k in range(1, n + 1) for _ in range(degree)]
        for k in range(1, n + 1):
            points += spans[k % n][:-1]
    else:
        knots = [0] * (degree + 1) + [k for k in range(1, n) for _ in range(degree)] + [n] * (degree + 1)
        for span in spans:
            points += span[:-1]
        first, last = tuple(curve["points"][:2]), tuple(curve["points"][-2:])
        points = [first] + points[1:] + [last]
    return dict(curve, degree=degree, knots=knots, points=[c for point in points for c in point])


def fit_boundary(boundary, degree, tolerance):
    return dict(boundary, curves=[fit_curve(curve, degree, tolerance) for curve in boundary["curves"]])
