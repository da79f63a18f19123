"""MuJoCo: pip install mujoco. The search begins with the settings of validation/peers/compare.py."""

import common
import mujoco

MODEL = """
<mujoco>
  <option gravity="0 0 -{g}" timestep="{dt}" cone="{cone}" impratio="{impratio}" solver="Newton" integrator="{integrator}"
          iterations="{iterations}" tolerance="{tolerance}" noslip_iterations="{noslip}"/>
  <worldbody>
    <geom name="base" type="plane" size="50 50 1"/>
    <body name="block" pos="0 0 0">
      <joint type="slide" axis="1 0 0"/>
      <joint type="slide" axis="0 0 1"/>
      <joint type="hinge" axis="0 1 0"/>
      <inertial pos="0 0 0" mass="1" diaginertia="{inertia} {inertia} {inertia}"/>
      <geom name="box" type="box" size="1 1 {gamma}"/>
    </body>
  </worldbody>
  <contact>
    <pair geom1="base" geom2="box" condim="3" friction="{mu} {mu} 0 0 0" solref="{timeconst} {damping}"
          {friction_solref} solimp="{d0} {dwidth} {width} 0.5 2"/>
  </contact>
</mujoco>
"""

#: What MuJoCo takes if nothing is said.
DEFAULT = dict(dt=2e-3, cone="pyramidal", impratio=1, integrator="Euler", iterations=100, tolerance=1e-8, noslip=0, timeconst=0.02,
               damping=1, friction_timeconst=None, d0=0.9, dwidth=0.95, width=1e-3)


class MuJoCo:
    def __init__(self, **settings):
        self.s = {**DEFAULT, **settings}
        self.dt = self.s["dt"]

    def place(self, gamma, mu, gravity, inertia, x, y, theta, vx, vy, omega):
        friction = self.s["friction_timeconst"]
        solref = f'solreffriction="{friction} 1"' if friction else ""
        self.model = mujoco.MjModel.from_xml_string(MODEL.format(g=gravity, gamma=gamma, mu=mu, inertia=inertia, friction_solref=solref, **self.s))
        self.data = mujoco.MjData(self.model)
        # The hinge turns about +y, clockwise as seen here.
        self.data.qpos[:] = x, y, -theta
        self.data.qvel[:] = vx, vy, -omega

    def push(self, fx, fy, torque):
        self.data.qfrc_applied[:] = fx, fy, -torque

    def step(self):
        mujoco.mj_step(self.model, self.data)

    def state(self):
        (x, y, a), (vx, vy, w) = self.data.qpos, self.data.qvel
        return float(x), float(y), -float(a), float(vx), float(vy), -float(w)


def some(pick):
    start, dt = pick([30, 100, 300]), pick([1e-5, 2e-5, 1e-4])
    settings = dict(dt=dt, timeconst=dt * pick([2, 3, 5, 10]), impratio=pick([1, 10, 100, 1000]), friction_timeconst=pick([0.02, 0.2, 1.0, 10.0]), d0=pick([0.9, 0.99]),
                    dwidth=pick([0.99, 0.999, 0.9999]), width=pick([1e-6, 1e-5, 1e-3]), damping=pick([0.7, 1, 2]), noslip=pick([0, 0, 20]), cone=pick(["elliptic", "elliptic", "pyramidal"]),
                    iterations=200, tolerance=1e-14)
    return settings, dict(settle=400, start=start, steps=3 * start)


PEERS = dict(dt=1e-5, cone="elliptic", impratio=100, timeconst=2e-5, friction_timeconst=0.2, d0=0.9, dwidth=0.999, iterations=200, tolerance=1e-14)
BEST = dict(dt=1e-5, cone="elliptic", impratio=100, timeconst=5e-5, friction_timeconst=10.0, d0=0.99, dwidth=0.999, iterations=200, tolerance=1e-14)
SETTINGS = {
    "default": ({}, dict(settle=400, start=10, steps=33)),
    "best": (BEST, dict(settle=400, start=300, steps=900)),
}
ELLIPTIC = dict(cone="elliptic", iterations=200, tolerance=1e-14)
SEVERAL = [
    {},
    dict(dt=5e-4, timeconst=1e-3, impratio=100, **ELLIPTIC),
    dict(dt=2e-4, timeconst=4e-4, impratio=100, dwidth=0.999, **ELLIPTIC),
    dict(dt=2e-4, timeconst=4e-4, impratio=100, dwidth=0.999, friction_timeconst=0.02, **ELLIPTIC),
    dict(dt=2e-4, timeconst=4e-4, impratio=100, dwidth=0.999, friction_timeconst=0.2, **ELLIPTIC),
    dict(dt=2e-4, timeconst=1e-3, impratio=1000, dwidth=0.999, integrator="implicitfast", noslip=100, **ELLIPTIC),
    dict(dt=1e-4, timeconst=2e-4, impratio=100, dwidth=0.999, friction_timeconst=0.02, **ELLIPTIC),
    dict(dt=1e-4, timeconst=5e-4, impratio=1000, dwidth=0.999, integrator="implicitfast", noslip=100, **ELLIPTIC),
    dict(dt=1e-4, timeconst=1e-3, impratio=1000, d0=0.99, dwidth=0.999, integrator="implicitfast", noslip=100, **ELLIPTIC),
]
MOTIONS = {"default": {}, "best": SEVERAL[-2]}

if __name__ == "__main__":
    common.main("mujoco", MuJoCo, SETTINGS, MOTIONS, some, SEVERAL, [SETTINGS["default"], (PEERS, SETTINGS["best"][1])])
