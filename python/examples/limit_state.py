"""How probable is it that a storm moves Goda's caisson? FORM and Monte Carlo by OpenTURNS, on the margin against sliding.

Friction, the wave height of the storm and a factor on Goda's force and uplift, which are known to be uncertain, are random
(illustrative numbers). What a case has between rest and sliding is one of its results, `margin_sliding`: a number on both sides
of zero, as methods of reliability need it. `assess_table` gives it for all points of a sample at once.
"""

from pathlib import Path

import numpy as np
import openturns as ot
import standfast

CASE = Path(__file__).parents[2] / "examples" / "goda-2000.toml"
NAMES = ["friction", "wave height", "model factor"]
LAW = ot.JointDistribution([
    ot.LogNormalMuSigma(0.6, 0.06).getDistribution(),
    ot.GumbelMuSigma(3.2, 0.4).getDistribution(),  # m, in deep water
    ot.Normal(0.95, 0.2),
])


def margin(sample):
    friction, height, factor = np.asarray(sample).T
    varied = {"friction": friction, "wave.deep_water_height": height}
    found = standfast.assess_table(CASE, varied, columns=["margin_sliding", "P", "U"])
    more = (factor - 1) * (found["P"] + friction * found["U"])
    return (found["margin_sliding"] - more)[:, np.newaxis] / 1e6  # MN/m


def main():
    limit = ot.PythonFunction(3, 1, func_sample=margin)
    limit.setInputDescription(NAMES)
    slides = ot.ThresholdEvent(ot.CompositeRandomVector(limit, ot.RandomVector(LAW)), ot.Less(), 0.0)

    solver = ot.Cobyla()  # without gradients: the margin has a kink where breaking limits the waves
    solver.setMaximumConstraintError(1e-4)
    solver.setStartingPoint(LAW.getMean())
    form = ot.FORM(solver, slides)
    form.run()
    found = form.getResult()
    print(f"FORM: β = {found.getHasoferReliabilityIndex():.3f}, probability {found.getEventProbability():.2e}")
    point, weights = found.getPhysicalSpaceDesignPoint(), found.getImportanceFactors()
    for name, value, weight in zip(NAMES, point, weights):
        print(f"  {name:12} {value:.3f} at the design point, {weight:.0%} of the uncertainty")

    ot.RandomGenerator.SetSeed(2026)
    simulation = ot.ProbabilitySimulationAlgorithm(slides, ot.MonteCarloExperiment())
    simulation.setBlockSize(20_000)
    simulation.setMaximumOuterSampling(10)
    simulation.setMaximumCoefficientOfVariation(0.05)
    simulation.run()
    result = simulation.getResult()
    draws = result.getOuterSampling() * result.getBlockSize()
    error = 1.96 * result.getStandardDeviation()
    print(f"Monte Carlo: probability {result.getProbabilityEstimate():.2e} ± {error:.1e} of {draws} draws, into SL")
    return found, result


if __name__ == "__main__":
    main()
