"""Impact laws: how a rock leaves the ground that it strikes, for one impact or for arrays of them.

Velocities [m/s] and spins [rad/s] have the shape (3,) or (n, 3), other arguments are numbers or arrays of n. ``normal`` is
the unit normal, out of the ground; a rock that leaves the ground is refused. A rock is a sphere of ``mass`` [kg] and
``radius`` [m]. Ranges are those of the project file. Equations and sources are in docs/laws.md.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from . import _talus
from .overrides import limits
from .problems import BadInput
from .shapes import check, numbers, together, vectors

__all__ = ["Rebound", "crsp", "plain", "rigid_sphere"]


class Rebound(NamedTuple):
    """A rock's motion after an impact."""

    velocity: np.ndarray
    """[m/s], shape (3,) or (n, 3)"""
    spin: np.ndarray
    """[rad/s], shape (3,) or (n, 3)"""


def crsp(velocity: Any, spin: Any = (0, 0, 0), normal: Any = (0, 0, 1), *, mass: Any, radius: Any,
         normal_restitution: Any, tangential_restitution: Any) -> Rebound:
    """The law of the Colorado Rockfall Simulation Program for a lumped mass with rotation (Pfeiffer and Bowen 1989)."""
    return _rebound("crsp", velocity, spin, normal, mass, radius, normal_restitution, tangential_restitution, 0, 0)


def plain(velocity: Any, normal: Any = (0, 0, 1), *, normal_restitution: Any, tangential_restitution: Any) -> np.ndarray:
    """A lumped mass without rotation: vn' = -Rn vn, vt' = Rt vt. Returns velocities."""
    return _rebound("plain", velocity, (0, 0, 0), normal, 1, 1, normal_restitution, tangential_restitution, 0, 0).velocity


def rigid_sphere(velocity: Any, spin: Any = (0, 0, 0), normal: Any = (0, 0, 1), *, mass: Any, radius: Any,
                 normal_restitution: Any, tangential_restitution: Any, dynamic_friction: Any,
                 rolling_friction: Any = 0) -> Rebound:
    """A rigid sphere: restitution at the contact point, limited by Coulomb friction, with resistance to rolling."""
    return _rebound("rigid_sphere", velocity, spin, normal, mass, radius, normal_restitution, tangential_restitution,
                    dynamic_friction, rolling_friction)


def _rebound(law: str, velocity: Any, spin: Any, normal: Any, mass: Any, radius: Any, rn: Any, rt: Any, mu: Any,
             rolling: Any) -> Rebound:
    shape, flat = together(
        velocity_3=vectors("velocity", velocity), spin_3=vectors("spin", spin), normal_3=vectors("normal", normal),
        mass=numbers("mass", mass), radius=numbers("radius", radius), normal_restitution=numbers("normal_restitution", rn),
        tangential_restitution=numbers("tangential_restitution", rt), dynamic_friction=numbers("dynamic_friction", mu),
        rolling_friction=numbers("rolling_friction", rolling))
    for name in ("velocity_3", "spin_3", "normal_3"):
        check(name.removesuffix("_3"), flat[name], -1e9, 1e9)
    check("mass", flat["mass"], *limits("seeder", "mass_kg"))
    least, most = limits("seeder", "diameter_m")
    check("radius", flat["radius"], least / 2, most / 2)
    for name in ("normal_restitution", "tangential_restitution", "dynamic_friction", "rolling_friction"):
        check(name, flat[name], *limits("material", name))
    lengths = np.linalg.norm(flat["normal_3"], axis=-1)
    if (abs(lengths - 1) > 1e-6).any():
        raise BadInput(f"normal has a length of {lengths[abs(lengths - 1) > 1e-6][0]:g} (expected a unit vector)")
    # Along a slope the product is zero but for rounding.
    outwards = (flat["velocity_3"] * flat["normal_3"]).sum(axis=-1)
    if (outwards > 1e-9 * np.linalg.norm(flat["velocity_3"], axis=-1)).any():
        raise BadInput(f"velocity leaves the ground, by {outwards.max():g} m/s along normal (expected one into the ground). "
                       "The normal points out of the ground")
    velocities, spins = _talus.rebound(law, *flat.values())
    return Rebound(velocities.reshape(shape + (3,)), spins.reshape(shape + (3,)))
