"""Drake: pip install drake.

Drake has one point of contact for a box on a half space by its point model, so the block has either the hydroelastic model, as Drake
comes, or four small spheres at its bottom corners (`points`), as is usual for feet.
"""

import math

import common
import numpy as np
from pydrake.geometry import AddContactMaterial, AddRigidHydroelasticProperties, Box, HalfSpace, ProximityProperties, SceneGraphConfig, Sphere
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph, CoulombFriction, DiscreteContactApproximation
from pydrake.multibody.tree import FixedOffsetFrame, PlanarJoint, SpatialInertia, UnitInertia
from pydrake.systems.framework import DiagramBuilder


class Drake:
    def __init__(self, dt=1e-3, points=False, approximation=None, stiffness=None, dissipation=None, relaxation=None, stiction=None, allowance=None,
                 modulus=None, resolution=None, radius=1e-4, depth=1.0):
        self.dt, self.s = dt, dict(points=points, approximation=approximation, stiffness=stiffness, dissipation=dissipation, relaxation=relaxation,
                                   stiction=stiction, allowance=allowance, modulus=modulus, resolution=resolution, radius=radius, depth=depth)

    def place(self, gamma, mu, gravity, inertia, x, y, theta, vx, vy, omega):
        s = self.s
        builder = DiagramBuilder()
        plant, scene = AddMultibodyPlantSceneGraph(builder, self.dt)
        if not s["points"]:
            config = SceneGraphConfig()
            config.default_proximity_properties.compliance_type = "compliant"
            if s["modulus"]:
                config.default_proximity_properties.hydroelastic_modulus = s["modulus"]
            if s["resolution"]:
                config.default_proximity_properties.resolution_hint = s["resolution"]
            if s["dissipation"] is not None:
                config.default_proximity_properties.hunt_crossley_dissipation = s["dissipation"]
            if s["relaxation"] is not None:
                config.default_proximity_properties.relaxation_time = s["relaxation"]
            scene.set_config(config)
        if s["approximation"]:
            plant.set_discrete_contact_approximation(getattr(DiscreteContactApproximation, s["approximation"]))
        properties = ProximityProperties()
        AddContactMaterial(dissipation=s["dissipation"] if s["points"] else None, point_stiffness=s["stiffness"], friction=CoulombFriction(mu, mu), properties=properties)
        if s["relaxation"] is not None and s["points"]:
            properties.AddProperty("material", "relaxation_time", s["relaxation"])
        floor = ProximityProperties(properties)
        if not s["points"]:
            AddRigidHydroelasticProperties(floor)
        plant.RegisterCollisionGeometry(plant.world_body(), RigidTransform(), HalfSpace(), "floor", floor)
        body = plant.AddRigidBody("block", SpatialInertia(1.0, np.zeros(3), UnitInertia(inertia, inertia, inertia)))
        if s["points"]:
            r = s["radius"]
            for i, (a, b) in enumerate([(-1, -1), (-1, 1), (1, -1), (1, 1)]):
                plant.RegisterCollisionGeometry(body, RigidTransform([a, r - gamma, b * s["depth"]]), Sphere(r), f"corner{i}", properties)
        else:
            plant.RegisterCollisionGeometry(body, RigidTransform(), Box(2, 2 * gamma, 2 * s["depth"]), "box", properties)
        # The joint's plane: x to the right, y upwards.
        frame = plant.AddFrame(fixed(plant))
        plant.AddJoint(PlanarJoint("planar", frame, body.body_frame(), np.zeros(3)))
        plant.mutable_gravity_field().set_gravity_vector([0, 0, -gravity])
        plant.SetUseSampledOutputPorts(False)
        plant.Finalize()
        if s["stiction"]:
            plant.set_stiction_tolerance(s["stiction"])
        if s["allowance"]:
            plant.set_penetration_allowance(s["allowance"])
        self.diagram = builder.Build()
        self.context = self.diagram.CreateDefaultContext()
        self.plant, self.inner = plant, plant.GetMyMutableContextFromRoot(self.context)
        plant.SetPositions(self.inner, [x, y, theta])
        plant.SetVelocities(self.inner, [vx, vy, omega])
        self.push(0, 0, 0)
        self.updates = self.diagram.AllocateDiscreteVariables()

    def push(self, fx, fy, torque):
        self.plant.get_applied_generalized_force_input_port().FixValue(self.inner, np.array([fx, fy, torque]))

    def step(self):
        self.diagram.CalcForcedDiscreteVariableUpdate(self.context, self.updates)
        self.context.get_mutable_discrete_state().SetFrom(self.updates)

    def state(self):
        return tuple(map(float, self.plant.GetPositionsAndVelocities(self.inner)))


def fixed(plant):
    turn = RotationMatrix(np.array([[1.0, 0, 0], [0, 0, -1.0], [0, 1.0, 0]]))
    return FixedOffsetFrame("plane", plant.world_frame(), RigidTransform(turn, np.zeros(3)))


def some(pick):
    start = pick([3, 10, 30])
    settings = dict(dt=pick([1e-3, 3e-4, 1e-4, 1e-5]), points=True, approximation=pick(["kLagged", "kSimilar", "kSap", "kTamsi"]), stiffness=pick([1e5, 1e6, 1e8]),
                    dissipation=pick([0.0, 10.0, 100.0]), relaxation=pick([None, 0.0]), stiction=pick([1e-3, 1e-5, 1e-7]))
    return settings, dict(settle=pick([50, 200]), start=start, steps=2 * start)


SETTINGS = {
    "default": ({}, dict(settle=200, start=40, steps=42)),
    "best": (dict(dt=1e-4, points=True, approximation="kTamsi", stiffness=1e8, dissipation=10.0, relaxation=0.0, stiction=1e-7), dict(settle=200, start=30, steps=60)),
}
SEVERAL = [{}, dict(dt=1e-3, points=True), dict(dt=1e-3, points=True, stiffness=1e6, dissipation=100.0, stiction=1e-5),
           dict(dt=3e-4, points=True, stiffness=1e6, dissipation=100.0, stiction=1e-5), dict(dt=3e-4, points=True, approximation="kSap", stiffness=1e8, relaxation=0.0),
           dict(dt=3e-4, points=True, approximation="kTamsi", stiffness=1e6, dissipation=100.0, stiction=1e-5),
           dict(dt=1e-4, points=True, approximation="kTamsi", stiffness=1e6, dissipation=100.0, stiction=1e-5)]
MOTIONS = {"default": {}, "best": SEVERAL[-1]}

if __name__ == "__main__":
    common.main("drake", Drake, SETTINGS, MOTIONS, some, SEVERAL, [SETTINGS["default"], SETTINGS["best"]])
