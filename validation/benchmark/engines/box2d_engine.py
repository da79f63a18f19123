"""Box2D by its Python package: pip install Box2D.

Box2D wants lengths of 0.1 to 10 m and keeps a skin of 0.005 m. `scale` makes the block and gravity larger; time stays as it is.
"""

import math

import Box2D
import common


class Box2DEngine:
    def __init__(self, dt=1 / 60, velocity=8, position=3, scale=1.0, skin=True):
        self.dt, self.velocity, self.position, self.scale, self.skin = dt, velocity, position, scale, skin

    def place(self, gamma, mu, gravity, inertia, x, y, theta, vx, vy, omega):
        s = self.scale
        self.world = Box2D.b2World(gravity=(0, -gravity * s), doSleep=False)
        self.world.continuousPhysics = True
        # Friction of a pair is the root of the product.
        floor = self.world.CreateStaticBody(position=(0, 0))
        floor.CreateEdgeFixture(vertices=[(-100 * s, 0), (100 * s, 0)], friction=mu)
        # The skins of the block and of the floor lie between the two.
        self.lift = 2 * Box2D.b2_polygonRadius - Box2D.b2_linearSlop if self.skin else 0.0
        self.body = self.world.CreateDynamicBody(position=(x * s, y * s + self.lift), angle=theta, allowSleep=False, linearDamping=0, angularDamping=0)
        self.body.CreatePolygonFixture(box=(s, gamma * s), density=1 / (4 * gamma * s * s), friction=mu)
        self.body.massData = Box2D.b2MassData(mass=1.0, center=(0, 0), I=inertia * s * s)
        self.body.linearVelocity, self.body.angularVelocity = (vx * s, vy * s), omega

    def push(self, fx, fy, torque):
        s = self.scale
        self.body.ApplyForceToCenter((fx * s, fy * s), True)
        self.body.ApplyTorque(torque * s * s, True)

    def step(self):
        self.world.Step(self.dt, self.velocity, self.position)
        self.world.ClearForces()

    def state(self):
        b, s = self.body, self.scale
        return b.position.x / s, (b.position.y - self.lift) / s, b.angle, b.linearVelocity.x / s, b.linearVelocity.y / s, b.angularVelocity


def some(pick):
    start = pick([2, 5, 10, 30])
    return (dict(dt=pick([1 / 60, 1 / 240, 1e-3, 3e-4, 1e-4]), velocity=pick([8, 30, 100]), position=pick([3, 10]), scale=pick([1.0, 3.0, 10.0])),
            dict(settle=pick([60, 200]), start=start, steps=pick([2, 3]) * start))


DEFAULT_WINDOW = dict(settle=200, start=0, steps=1)
SETTINGS = {
    "default": ({}, DEFAULT_WINDOW),
    "best": (dict(dt=1e-3, velocity=100, position=10, scale=10.0), dict(settle=200, start=5, steps=15)),
}
SEVERAL = [{}, dict(dt=1 / 240, velocity=30), dict(dt=1e-3, velocity=30), dict(dt=1e-3, velocity=30, scale=10.0), dict(dt=3e-4, velocity=30, scale=10.0),
           dict(dt=1e-3, velocity=100, position=10, scale=10.0), dict(dt=1e-3, velocity=30, scale=30.0), dict(dt=3e-4, velocity=30, scale=30.0),
           dict(dt=3e-4, velocity=30, scale=100.0), dict(dt=1e-4, velocity=30, scale=30.0)]
MOTIONS = {"default": {}, "best": SEVERAL[-1]}

if __name__ == "__main__":
    common.main("box2d", Box2DEngine, SETTINGS, MOTIONS, some, SEVERAL, [SETTINGS["default"], SETTINGS["best"]])
