from typing import Literal

from ._answer import Answer, ByMode
from ._modes import Mode, Modes

from .answers import Summary
__all__ = ['BodyMotion', 'JointMotion', 'StackDocument']

class JointMotion(Answer):
    """Acceleration of the body above a joint relative to the one below, and the reaction on the body above."""
    @property
    def t(self) -> float:
        """Acceleration along the joint, to the right."""
    @property
    def v(self) -> float:
        """Acceleration upwards of the point (0, h), which need not be on the body."""
    @property
    def omega(self) -> float:
        """Angular acceleration, counter-clockwise."""
    @property
    def f(self) -> float:
        """Friction force, to the right."""
    @property
    def N(self) -> float:
        """Normal reaction, upwards."""
    @property
    def xi(self) -> float:
        """Where it acts, to the right of the origin; 0 where there is none."""

class BodyMotion(Answer):
    """Accelerations of the centre of a body."""
    @property
    def x_ddot(self) -> float:
        """Acceleration to the right."""
    @property
    def y_ddot(self) -> float:
        """Acceleration upwards."""
    @property
    def theta_ddot(self) -> float:
        """Angular acceleration, counter-clockwise."""

class StackDocument(Answer):
    """What ``stack`` answers."""
    @property
    def schema(self) -> Literal[1]:
        """The version of the document."""
    @property
    def departure(self) -> Literal["never", "at-once", "at"]:
        """Whether it leaves rest as the variable loads rise: never, at once under the permanent loads or any load beside them, or
        at a load factor."""
    @property
    def load_factor(self) -> float:
        """The load factor at which it leaves rest: 0 at once, infinite if never."""
    @property
    def departure_joints(self) -> list[int]:
        """The joints that reach their limit there; at once under the permanent loads alone, those that cannot rest."""
    @property
    def departure_modes(self) -> list[Mode] | None:
        """The mode of each joint with any more load; None where it never leaves rest, and of more bodies than are enumerated."""
    @property
    def departure_also_modes(self) -> list[list[Mode]]:
        """Other combinations that are as consistent then."""
    @property
    def modes(self) -> list[Mode] | None:
        """The mode of each joint if the full load is applied at once; None of more bodies than are enumerated."""
    @property
    def also_modes(self) -> list[list[Mode]]:
        """Other combinations that are as consistent."""
    @property
    def unique(self) -> bool | None:
        """Whether no other combination is consistent."""
    @property
    def no_modes(self) -> str | None:
        """Reason why the modes are not known."""
    @property
    def joints(self) -> list[JointMotion] | None:
        """Accelerations and reactions of the joints in these modes."""
    @property
    def bodies(self) -> list[BodyMotion] | None:
        """Accelerations of the centres of the bodies in these modes; on a shaken base relative to it."""
