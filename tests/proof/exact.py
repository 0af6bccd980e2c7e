"""exact.py - the reference against exact arithmetic: random rays and spheres.

    exact.py PROGRAM    PROGRAM is exact.c, which answers them by tests/05-quadratic/exact.c

Doubles are whole numbers times a power of two, so Python's whole numbers give the discriminant without any error. The
claim: the reference never disagrees on whether the line meets the sphere, nor on whether the ray hits it, except if
|l - r| <= DOUBTFUL eps |o - c|. l is the distance of the line from the centre c, r the radius, o the ray's origin.
Both roots are also compared.
"""
import math
import random
import subprocess
import sys

from figure import dot, plus, times

RAYS = 240000
EPSILON = sys.float_info.epsilon
# Rounding moves l by at most 2.1 eps |o - c| to first order: 1/2 by o - c, 1/2 by what is taken from it to reach the
# foot of the perpendicular, 3/2 by the rest; and by 3.6 where l is next to 0.
DOUBTFUL = 4
# A root moves by d r / h where the centre moves by d; h is half the chord. So this is how far, in eps (|o - c| + r),
# the sphere would have to move to excuse the error of a root: the roundings of a, b and the two roots.
MOST_ERROR = 8
WIDEST_ULPS = 40
DIGITS = 200  # of square roots, in bits behind the point

chance = random.Random(2015)
uniform, whole = chance.uniform, chance.randint


def power_of_ten(low, high):
    return 10 ** uniform(low, high)


def in_unit_ball(least=0):
    while True:
        v = [uniform(-1, 1) for _ in range(3)]
        if least <= math.hypot(*v) <= 1:
            return v


def unit():
    v = in_unit_ball(0.1)
    return times(1 / math.hypot(*v), v)


# ---- rays and spheres, by families: each is hard in a way of its own -------------------------------
# (origin, direction, centre, radius)

def aimed(radius, radii):
    """A sphere some radii away; the ray is aimed at it or a little beside it."""
    center = times(radius * 10, in_unit_ball())
    origin = plus(center, times(radii * radius, unit()))
    way = plus(plus(center, times(1.3 * radius, in_unit_ball())), origin, -1)
    return origin, times(1 / math.hypot(*way), way), center, radius


def aimed_from_within(radius, power):
    """The same, between 1.1 and 10^power radii away."""
    return aimed(radius, power_of_ten(0.05, power))


def ordinary():
    return aimed_from_within(uniform(0.1, 3), 2)


def far():
    return aimed(uniform(0.1, 3), power_of_ten(2, 9))


def tiny():
    return aimed_from_within(power_of_ten(-12, -3), 6)


def inside():
    _, _, center, radius = aimed(power_of_ten(-3, 3), 2)
    return plus(center, times(0.999 * radius, in_unit_ball())), unit(), center, radius


def any_length():
    origin, way, center, radius = aimed_from_within(uniform(0.1, 3), 4)
    return origin, times(power_of_ten(-6, 6), way), center, radius


def behind():
    origin, way, center, radius = aimed_from_within(uniform(0.1, 3), 6)
    return origin, times(-1, way), center, radius


def tangent():
    """Whole numbers times a power of two, so exactly tangent."""
    # These are at right angles, and as long as the sum of the four squares (Euler's rotation matrix in whole numbers).
    a, b, c, d = whole(1, 9), whole(-9, 9), whole(-9, 9), whole(-9, 9)
    frame = ([a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)],
             [2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)],
             [2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d])
    aside, size, speed = 1 << whole(0, 16), 2.0 ** whole(-30, 30), whole(1, 9) * 2.0 ** whole(-20, 20)
    origin = times(whole(-9999, 9999), [1, -7, 3])
    beside = plus(times(3 * aside, frame[1]), times(4 * aside, frame[2]))
    center = plus(origin, plus(times(whole(-9, 1 << 30), frame[0]), beside))
    return times(size, origin), times(speed, frame[0]), times(size, center), \
        size * 5 * aside * (a * a + b * b + c * c + d * d)


def nearly_tangent():
    """A tangent ray whose radius is off by some units in the last place, of its own or of |o - c|."""
    if whole(0, 1) == 0:
        origin, way, center, radius = tangent()
        return origin, way, center, radius * (1 + whole(-WIDEST_ULPS, WIDEST_ULPS) * EPSILON)
    origin, way, center, _ = aimed_from_within(uniform(0.1, 3), 9)
    p = plus(origin, center, -1)
    distance = math.sqrt(max(0, dot(p, p) - dot(p, way) ** 2 / dot(way, way)))
    return origin, way, center, abs(distance + uniform(-WIDEST_ULPS, WIDEST_ULPS) / 4 * EPSILON * math.hypot(*p))


# ---- where a ray meets a sphere, without any error --------------------------------------------------

def as_whole(*numbers):
    """The numbers, times the same power of two; and its exponent."""
    ratios = [float(x).as_integer_ratio() for x in numbers]
    shift = max(below.bit_length() for _, below in ratios) - 1
    return [above << (shift + 1 - below.bit_length()) for above, below in ratios], shift


class Exact:
    """The quadratic as whole numbers; d is (b / 2)^2 - a c."""

    def __init__(self, origin, way, center, radius):
        lengths, self.shift = as_whole(*origin, *center, radius)
        v, speed = as_whole(*way)
        p = plus(lengths[:3], lengths[3:6], -1)
        self.a, self.half_b, self.c = dot(v, v), dot(p, v), dot(p, p) - lengths[6] ** 2
        self.d = self.half_b ** 2 - self.a * self.c
        self.scale = speed - self.shift  # of t, a power of two
        self.meets = self.d >= 0
        # The larger root is positive: the roots' sum is, or their product is negative.
        self.hits = self.meets and (self.half_b < 0 or self.c < 0)

    def chord(self):
        """r^2 - l^2."""
        return self.d / (self.a << 2 * self.shift)

    def roots(self):
        """(-b / 2 -+ sqrt d) / a, as fractions of whole numbers."""
        root, below = math.isqrt(self.d << 2 * DIGITS), self.a << DIGITS
        above = [(-self.half_b << DIGITS) + sign * root for sign in (-1, 1)]
        return [(x << max(self.scale, 0), below << max(-self.scale, 0)) for x in above]


def error_of(yours, root):
    above, below = yours.as_integer_ratio()
    return abs(above * root[1] - root[0] * below) / (below * root[1])


# ---- the comparison -----------------------------------------------------------------------------------

class Found:
    def __init__(self):
        self.rays = self.doubtful = self.disagreed = self.failed = 0
        self.widest = 0.0  # |l - r| / (eps |o - c|), of those that disagreed
        self.error = 0.0  # of a root, in eps (|o - c| + r) r / h, outside the doubtful band
        self.digits = 0.0  # the same error relative to the root itself

    def compare(self, case, count, roots, hit):
        origin, way, center, radius = case
        exact, away = Exact(*case), math.hypot(*plus(origin, center, -1))
        chord = exact.chord()
        off = abs(chord) / (math.sqrt(max(0, radius * radius - chord)) + radius) / (EPSILON * away)
        doubtful = off <= DOUBTFUL
        agree = count == (2 if exact.meets else 0) and (hit < math.inf) == exact.hits
        good = agree or doubtful
        if exact.meets and agree and not doubtful:
            of_error = EPSILON * (away + radius) * radius / math.sqrt(chord) / math.hypot(*way)
            right = exact.roots()
            errors = [error_of(yours, root) for yours, root in zip(roots, right)]
            relative = [error / abs(above / below) for error, (above, below) in zip(errors, right)]
            self.digits = max(self.digits, *relative)
            if exact.hits:
                errors.append(error_of(hit, right[0 if right[0][0] > 0 else 1]))
            self.error = max(self.error, max(errors) / of_error)
            good = max(errors) <= MOST_ERROR * of_error
        self.rays += 1
        self.doubtful += doubtful
        if not agree:
            self.disagreed += 1
            self.widest = max(self.widest, off)
        if not good:
            self.failed += 1
            if self.failed <= 5:
                print("not ok: origin {}, direction {}, center {}, radius {!r}".format(*case))

    def print(self, name):
        print(f"{name:<15} {self.rays:8} {self.doubtful:9} {self.disagreed:10} {self.widest:8.2f} {self.error:12.2f} "
              f"{self.digits:12.1e}")


def main(program):
    families = (ordinary, tangent, nearly_tangent, far, tiny, inside, any_length, behind)
    print(f"Doubtful where |l - r| <= {DOUBTFUL} eps |o - c|; roots within {MOST_ERROR} eps (|o - c| + r) r / h.\n")
    print("rays              number  doubtful  disagreed   widest   root error     relative")
    failed = 0
    for family in families:
        cases = [family() for _ in range(RAYS // len(families))]
        asked = "\n".join(" ".join(float(x).hex() for x in (*case[0], *case[1], *case[2], case[3])) for case in cases)
        said = subprocess.run([program], input=asked, stdout=subprocess.PIPE, text=True, check=True).stdout
        found = Found()
        for case, answer in zip(cases, said.splitlines()):
            count, *numbers = answer.split()
            first, second, hit = (float.fromhex(x) for x in numbers)
            found.compare(case, int(count), (first, second), hit)
        found.print(family.__name__.replace("_", " "))
        failed += found.failed > 0
    print(f"exact: {len(families) - failed} passed, {failed} failed")
    return failed > 0


sys.exit(main(sys.argv[1]))
