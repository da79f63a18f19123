"""A block under a sudden force in MuJoCo: the accelerations of its bottom corners soon after."""

import time

import mujoco
import numpy as np

G = 9.81

# B = 1 m, m = 1 kg (MuJoCo's contacts are the same for every mass), depth 2 m.
MODEL = """
<mujoco>
  <option gravity="0 0 -{g}" timestep="{timestep}" cone="{cone}" impratio="{impratio}" solver="Newton"
          iterations="200" tolerance="1e-14" integrator="{integrator}" noslip_iterations="{noslip}"
          noslip_tolerance="1e-14">
    <flag eulerdamp="disable" warmstart="enable"/>
  </option>
  <worldbody>
    <geom name="base" type="plane" size="50 50 1"/>
    <body name="block" pos="0 0 {gamma}">
      <joint type="slide" axis="1 0 0"/>
      <joint type="slide" axis="0 0 1"/>
      <joint type="hinge" axis="0 1 0"/>
      <inertial pos="0 0 0" mass="1" diaginertia="{inertia} {inertia} {inertia}"/>
      <geom name="box" type="box" size="1 1 {gamma}"/>
    </body>
  </worldbody>
  <contact>
    <pair geom1="base" geom2="box" condim="3" friction="{mu} {mu} 0 0 0" solref="{timeconst} {damping}"
          solreffriction="{friction_timeconst} 1" solimp="{d0} {dwidth} {width} 0.5 2"/>
  </contact>
</mujoco>
"""

DEFAULT = dict(timestep=1e-5, cone="elliptic", impratio=100, integrator="Euler", noslip=0, ratio=2.0,
               damping=1.0, d0=0.99, dwidth=0.9999, width=1e-6, friction_timeconst=1.0, settle=400, start=100, steps=300)


def corners(model, data, gamma):
    """Velocities of O and O': to the right and upwards each."""
    vx, vz, w = data.qvel
    c, s = np.cos(data.qpos[2]), np.sin(data.qpos[2])
    found = []
    for side in (-1.0, 1.0):
        # The hinge turns about +y: x towards -z.
        rx, rz = c * side - s * gamma, -s * side - c * gamma
        found += [vx + w * rz, vz - w * rx]
    return np.array(found)


def simulate(point, settings):
    """Accelerations in g: slip and lift of O, slip and lift of O'; and the seconds of the processor it took."""
    s = {**DEFAULT, **settings}
    gamma, k_prime, k, mu = point
    text = MODEL.format(g=G, gamma=gamma, mu=mu, inertia=(1 + gamma**2) / 3, timeconst=s["ratio"] * s["timestep"], **s)
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    begin = time.process_time()
    for _ in range(s["settle"]):
        mujoco.mj_step(model, data)
    force = k * G
    data.qfrc_applied[:] = [-force, 0, -force * k_prime * gamma]
    before = None
    for step in range(s["steps"]):
        if step == s["start"]:
            before = corners(model, data, gamma)
        mujoco.mj_step(model, data)
    after = corners(model, data, gamma)
    seconds = time.process_time() - begin
    span = (s["steps"] - s["start"]) * s["timestep"]
    return (after - before) / span / G, seconds
