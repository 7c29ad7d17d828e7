"""Transmittance of flat glass with every bounce inside it."""

from __future__ import annotations

from mpmath import asin, cos, exp, matrix, mpf, radians, sin, tan


def fresnel(index, incidence_deg):
    """Unpolarised reflectance of one face, from air into ``index``."""
    c = cos(radians(mpf(incidence_deg)))
    inner = cos(asin(sin(radians(mpf(incidence_deg))) / index))
    s_amplitude = (c - index * inner) / (c + index * inner)
    p_amplitude = (index * c - inner) / (index * c + inner)
    return (s_amplitude**2 + p_amplitude**2) / 2


def slab(index, incidence_deg, depth=0, panes=1):
    """Share that passes ``panes`` slabs: layer upon layer of scalar faces, each slab absorbing exp(-depth) a crossing.

    The equations of adding: a slab passes t = T^2 a / (1 - R^2 a^2) and reflects r = R + T^2 a^2 R / (1 - R^2 a^2), and
    two layers pass t1 t2 / (1 - r1 r2). For a clear slab it comes to (1 - R) / (1 + R).
    """
    face = fresnel(index, incidence_deg)
    a = exp(-mpf(depth))
    one_pass = (1 - face) ** 2 * a / (1 - (face * a) ** 2)
    one_back = face + (1 - face) ** 2 * a * a * face / (1 - (face * a) ** 2)
    passed, back = one_pass, one_back
    for _ in range(panes - 1):
        loop = 1 - back * one_back
        passed, back = passed * one_pass / loop, back + passed**2 * one_back / loop
    return passed


def slab_by_bounces(index, incidence_deg, bounces=60):
    """The clear slab again, by following the light face by face: an independent check."""
    face = fresnel(index, incidence_deg)
    inside, out = 1 - face, mpf(0)
    for bounce in range(bounces):
        out += inside * (1 - face) if bounce % 2 == 0 else 0
        inside *= face
    return out


def stack_by_matrices(index, incidence_deg, panes):
    """The stack again, by transfer matrices of its 2 * panes faces."""
    face = fresnel(index, incidence_deg)
    one = matrix([[1 - 2 * face, face], [-face, 1]]) / (1 - face)
    whole = one ** (2 * panes)
    return 1 / whole[1, 1]


def weighted_pane(transmission, reflection=0):
    """A pane with the paper's constant shares and no Fresnel: t^2 with the bounces between its faces."""
    return mpf(transmission) ** 2 / (1 - mpf(reflection) ** 2)


def turned_by_prism(transmission, reflection):
    """A 45-90-45 prism: in, all of r + t at total reflection, out; each leg sends r back for another round trip."""
    t, r = mpf(transmission), mpf(reflection)
    return t * (r + t) * t / (1 - ((r + t) * r) ** 2)


def sideways(index, incidence_deg, thickness):
    """How far a slab moves a ray sideways, at right angles to the ray."""
    outside = radians(mpf(incidence_deg))
    inside = asin(sin(outside) / index)
    return thickness * sin(outside - inside) / cos(inside)


def apparent_shift(index, incidence_deg, thickness):
    """How far the picture of a plane behind the slab moves along that plane."""
    outside = radians(mpf(incidence_deg))
    return thickness * (tan(outside) - tan(asin(sin(outside) / index)))
