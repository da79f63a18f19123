"""Bullet by PyBullet: pip install pybullet. Damping of bodies is off and restitution 0, for the problems have none; the rest as it comes."""

import math

import common
import pybullet

CLIENT = pybullet.connect(pybullet.DIRECT)


class Bullet:
    def __init__(self, dt=1 / 240, iterations=50, substeps=0, erp=None, contact_erp=None, friction_erp=None, maximal=0, margin=None, cone=1,
                 residual=None, depth=1.0, split=None, slop=None):
        self.dt, self.maximal, self.margin, self.depth = dt, maximal, margin, depth
        given = dict(fixedTimeStep=dt, numSolverIterations=iterations, numSubSteps=substeps, enableConeFriction=cone, erp=erp, contactERP=contact_erp,
                     frictionERP=friction_erp, solverResidualThreshold=residual, useSplitImpulse=split, contactSlop=slop)
        self.given = {name: value for name, value in given.items() if value is not None}

    def place(self, gamma, mu, gravity, inertia, x, y, theta, vx, vy, omega):
        pybullet.resetSimulation()
        pybullet.setPhysicsEngineParameter(**self.given)
        pybullet.setGravity(0, 0, -gravity)
        floor = pybullet.createMultiBody(0, pybullet.createCollisionShape(pybullet.GEOM_PLANE))
        box = pybullet.createCollisionShape(pybullet.GEOM_BOX, halfExtents=[1, self.depth, gamma])
        # A turn about +y is clockwise here.
        turn = pybullet.getQuaternionFromEuler([0, -theta, 0])
        self.body = pybullet.createMultiBody(1.0, box, -1, [x, 0, y], turn, useMaximalCoordinates=self.maximal)
        # Friction of a pair is the product.
        pybullet.changeDynamics(floor, -1, lateralFriction=1, restitution=0)
        pybullet.changeDynamics(self.body, -1, lateralFriction=mu, rollingFriction=0, spinningFriction=0, restitution=0, linearDamping=0, angularDamping=0,
                                localInertiaDiagonal=[inertia] * 3, activationState=pybullet.ACTIVATION_STATE_DISABLE_SLEEPING)
        if self.margin is not None:
            pybullet.changeDynamics(self.body, -1, collisionMargin=self.margin)
        pybullet.resetBaseVelocity(self.body, [vx, 0, vy], [0, -omega, 0])

    def push(self, fx, fy, torque):
        (x, _, y), turn = pybullet.getBasePositionAndOrientation(self.body)
        pybullet.applyExternalForce(self.body, -1, [fx, 0, fy], [x, 0, y], pybullet.WORLD_FRAME)
        # A torque by a pair of forces: that of applyExternalTorque is turned with the body in some versions.
        pybullet.applyExternalForce(self.body, -1, [torque / 2, 0, 0], [x, 0, y - 1], pybullet.WORLD_FRAME)
        pybullet.applyExternalForce(self.body, -1, [-torque / 2, 0, 0], [x, 0, y + 1], pybullet.WORLD_FRAME)

    def step(self):
        pybullet.stepSimulation()

    def state(self):
        (x, _, y), (_, b, _, w) = pybullet.getBasePositionAndOrientation(self.body)
        (vx, _, vy), (_, turn, _) = pybullet.getBaseVelocity(self.body)
        return x, y, -2 * math.atan2(b, w), vx, vy, -turn


def some(pick):
    start = pick([2, 5, 10, 30])
    return (dict(dt=pick([1 / 240, 1e-3, 3e-4, 1e-4]), iterations=pick([50, 200, 1000]), contact_erp=pick([None, 0.0, 0.2, 0.8]), friction_erp=pick([None, 0.0, 0.2]),
                 maximal=pick([0, 1]), margin=pick([None, 0.0, 0.001]), residual=pick([None, 0.0, 1e-12]), cone=pick([0, 1]), slop=pick([None, 0.0])),
            dict(settle=pick([60, 240]), start=start, steps=pick([2, 3]) * start))


SETTINGS = {
    "default": ({}, dict(settle=240, start=5, steps=7)),
    "best": (dict(dt=1e-3, iterations=200, residual=0.0), dict(settle=240, start=5, steps=15)),
}
SEVERAL = [{}, dict(dt=1e-3), dict(dt=1e-3, maximal=1), dict(dt=1e-3, iterations=200, residual=0.0), dict(dt=1e-3, iterations=200, residual=0.0, maximal=1),
           dict(dt=3e-4, iterations=200, residual=0.0), dict(dt=1e-3, iterations=200, residual=0.0, margin=0.001, slop=0.0),
           dict(dt=1e-3, contact_erp=0.0), dict(dt=1e-3, contact_erp=0.8), dict(dt=1e-3, cone=0), dict(dt=3e-4, margin=0.0, contact_erp=0.8, friction_erp=0.0)]
MOTIONS = {"default": {}, "best": dict(dt=1e-3)}

if __name__ == "__main__":
    common.main("pybullet", Bullet, SETTINGS, MOTIONS, some, SEVERAL, [SETTINGS["default"], SETTINGS["best"]])
