"""The same limit state by standfast and by OpenTURNS: a point of the report's plane with random force and friction.

`standfast.probability` integrates friction in closed form. To OpenTURNS the margin against sliding is a function of samples as any
other; because it is a difference of two normal numbers, FORM happens to be exact here.
"""

import numpy as np
import openturns as ot
import standfast

POINT = {"gamma": 0.8, "k_prime": 0.4}
LAWS = {"k": (0.35, 0.05), "mu": (0.6, 0.05)}  # means and standard deviations


def margin(sample):
    k, mu = np.asarray(sample).T
    return standfast.limit_states(**POINT, k=k, mu=mu, columns=["slide"]).slide[:, np.newaxis]


def main():
    random = {name: {"normal": {"mean": mean, "sd": sd}} for name, (mean, sd) in LAWS.items()}
    ours = standfast.probability({"point": POINT, "random": random})
    print(f"standfast: SL {ours.modes['SL'].probability:.6e}, β {ours.beta:.4f}")

    law = ot.JointDistribution([ot.Normal(mean, sd) for mean, sd in LAWS.values()])
    limit = ot.PythonFunction(2, 1, func_sample=margin)
    slides = ot.ThresholdEvent(ot.CompositeRandomVector(limit, ot.RandomVector(law)), ot.Less(), 0.0)
    solver = ot.AbdoRackwitz()
    solver.setStartingPoint(law.getMean())
    form = ot.FORM(solver, slides)
    form.run()
    theirs = form.getResult()
    print(f"OpenTURNS: SL {theirs.getEventProbability():.6e}, β {theirs.getHasoferReliabilityIndex():.4f}")
    return ours, theirs


if __name__ == "__main__":
    main()
