"""Methods of reliability: `standfast probability` against OpenTURNS and pystra, on the same limit states.

    pip install openturns==1.27.post1 pystra==1.6.0 numpy==2.4.6
    python reliability.py PATH/TO/standfast

Three questions: the index β of smooth limit states and of one with a kink; the probability of a small region of the report's plane; the time
of plain Monte Carlo. Times are of one run on one thread. The program's are from its start to its end.
"""

import csv
import io
import math
import pathlib
import subprocess
import sys
import time

import numpy as np
import openturns as ot
import pystra as ra
from probability import ask

ROOT = pathlib.Path(__file__).parents[2]
GAMMA, K_PRIME = 0.8, 0.9167


def plane(random, k="", mu=""):
    return f"[point]\ngamma = {GAMMA}\nk_prime = {K_PRIME}\n{k}\n{mu}\n[random]\n{random}\n"


def forces(program):
    """P and U of Goda's caisson over the deep-water height, by `standfast batch`: 4000 heights, lines between them."""
    heights = np.linspace(0.6, 20.0, 4000)
    table = "wave.deep_water_height\n" + "\n".join(f"{h:.17g}" for h in heights)
    command = [program, "batch", "-", "-o", "-", "--case", str(ROOT / "examples/goda-2000.toml"), "--input-format", "csv", "--output-format", "csv"]
    text = subprocess.run(command, check=True, capture_output=True, text=True, input=table).stdout
    rows = list(csv.DictReader(io.StringIO(text)))
    thrust, uplift = (np.array([float(row[name]) for row in rows]) for name in ("P", "U"))
    return lambda h: (np.interp(h, heights, thrust), np.interp(h, heights, uplift))


class Counted:
    """A limit state that counts how often it is asked."""

    def __init__(self, g):
        self.g, self.calls = g, 0

    def __call__(self, *x):
        self.calls += np.size(x[0])
        return self.g(*x)


def openturns_form(g, laws, solver):
    counted = Counted(g)
    function = ot.PythonFunction(len(laws), 1, lambda x: [float(counted(*x))])
    vector = ot.RandomVector(ot.JointDistribution(laws))
    event = ot.ThresholdEvent(ot.CompositeRandomVector(function, vector), ot.Less(), 0.0)
    solver.setMaximumAbsoluteError(1e-10)
    solver.setMaximumRelativeError(1e-10)
    solver.setMaximumResidualError(1e-10)
    solver.setMaximumConstraintError(1e-10)
    solver.setMaximumCallsNumber(20000)
    try:
        form = ot.FORM(solver, event, ot.JointDistribution(laws).getMean())
        form.run()
        return f"{form.getResult().getGeneralisedReliabilityIndex():.7f} ({counted.calls} calls)"
    except Exception as error:
        return f"fails: {str(error).splitlines()[0][:60]}"


def pystra_form(g, laws):
    counted = Counted(g)
    model = ra.StochasticModel()
    names = [f"x{i}" for i in range(len(laws))]
    for name, law in zip(names, laws):
        model.addVariable(law(name))
    namespace = {"counted": counted}
    exec(f"def limit({', '.join(names)}):\n    return counted({', '.join(names)})", namespace)
    options = ra.AnalysisOptions()
    options.setPrintOutput(False)
    options.setE1(1e-9)
    options.setE2(1e-9)
    try:
        form = ra.Form(analysis_options=options, stochastic_model=model, limit_state=ra.LimitState(namespace["limit"]))
        form.run()
        return f"{float(np.ravel(form.getBeta())[0]):.7f} ({counted.calls} calls)"
    except Exception as error:
        return f"fails: {str(error).splitlines()[0][:60]}"


def lognormal(mean, cov):
    return ot.ParametrizedDistribution(ot.LogNormalMuSigma(mean, cov * mean, 0.0))


def gumbel(mean, sd):
    return ot.ParametrizedDistribution(ot.GumbelMuSigma(mean, sd))


def indices(program):
    print("β                                   standfast    OpenTURNS Cobyla | AbdoRackwitz | SQP | pystra")
    p_u = forces(program)

    def caisson(mu, b_p, b_u, height):
        thrust, uplift = p_u(height)
        return (mu * (2318640.0 - b_u * uplift) - b_p * thrust) / 1e6

    cases = [
        (
            "form-01 μ − k, normals",
            plane("mu = { normal = { mean = 0.6, sd = 0.06 } }\nk = { normal = { mean = 0.2512178318477824, sd = 0.03 } }"),
            lambda mu, k: mu - k,
            [ot.Normal(0.6, 0.06), ot.Normal(0.2512178318477824, 0.03)],
            [lambda n: ra.Normal(n, 0.6, 0.06), lambda n: ra.Normal(n, 0.2512178318477824, 0.03)],
        ),
        (
            "form-03 1 − kγ(1+k′), Gumbel",
            "[point]\ngamma = 1.0\nk_prime = 0.4\nmu = 50\n[random]\nk = { gumbel = { mean = 0.4, sd = 0.12 } }\n",
            lambda k: 1.0 - k * 1.4,
            [gumbel(0.4, 0.12)],
            [lambda n: ra.Gumbel(n, 0.4, 0.12)],
        ),
        (
            "form-05 caisson, kink in H₀′",
            (ROOT / "examples/goda-2000-random.toml").read_text(),
            caisson,
            [lognormal(0.636, 0.15), lognormal(0.91, 0.19), lognormal(0.77, 0.25), ot.TruncatedDistribution(gumbel(4.5, 0.9), 1.0, ot.TruncatedDistribution.LOWER)],
            [
                lambda n: ra.Lognormal(n, 0.636, 0.15 * 0.636),
                lambda n: ra.Lognormal(n, 0.91, 0.19 * 0.91),
                lambda n: ra.Lognormal(n, 0.77, 0.25 * 0.77),
                lambda n: ra.Gumbel(n, 4.5, 0.9),
            ],
        ),
    ]
    for name, text, g, laws, of_pystra in cases:
        own = ask(program, text)[0]["beta"]
        solvers = [ot.Cobyla(), ot.AbdoRackwitz(), ot.SQP()]
        theirs = [openturns_form(g, laws, solver) for solver in solvers] + [pystra_form(g, of_pystra)]
        print(f"{name:32s}    {own:.7f}    {' | '.join(theirs)}", flush=True)


def small_region(program):
    """SRO₋ of a point with normal friction and force: above 1/γ − kk′ and below μ* = (ak + b)/(ck + d), (3.18) to (3.24)."""
    text = plane("mu = { normal = { mean = 0.6, sd = 0.1 }, lower = 0 }\nk = { normal = { mean = 0.45, sd = 0.12 }, lower = 0 }")
    answer, seconds = ask(program, text)
    exact = next(m["probability"] for m in answer["modes"] if m["mode"] == "SRO-")
    print(f"SRO₋ of plane-01: standfast {exact:.9g} in {1e3 * seconds:.0f} ms from start to end, all modes")
    g2 = GAMMA**2
    a, b, c, d = 4 + g2 - 3 * g2 * K_PRIME, 3 * GAMMA, 3 * GAMMA * (1 + K_PRIME), 1 + 4 * g2
    formula = f"-min(mu - (1/{GAMMA} - k*{K_PRIME}), ({a}*k + {b})/({c}*k + {d}) - mu)"
    laws = [ot.TruncatedNormal(0.6, 0.1, 0.0, 10.0), ot.TruncatedNormal(0.45, 0.12, 0.0, 10.0)]
    for name in ("MonteCarlo", "SubsetSampling"):
        ot.RandomGenerator.SetSeed(1)
        vector = ot.RandomVector(ot.JointDistribution(laws))
        event = ot.ThresholdEvent(ot.CompositeRandomVector(ot.SymbolicFunction(["mu", "k"], [formula]), vector), ot.Less(), 0.0)
        if name == "MonteCarlo":
            algorithm = ot.ProbabilitySimulationAlgorithm(event, ot.MonteCarloExperiment())
            algorithm.setMaximumOuterSampling(1_000_000)
            algorithm.setMaximumCoefficientOfVariation(0.005)  # half an interval of 95 % is 1 %
        else:
            algorithm = ot.SubsetSampling(event)
            algorithm.setMaximumOuterSampling(100)
        algorithm.setBlockSize(1000)
        start = time.process_time()
        algorithm.run()
        seconds = time.process_time() - start
        found = algorithm.getResult().getProbabilityEstimate()
        print(f"    OpenTURNS {name}: {found:.6g}, {100 * (found / exact - 1):+.2f} %, {1e3 * seconds:.0f} ms of the processor")


def drawing():
    """Plain Monte Carlo of P(μ < k), two normals."""
    count = 1 << 22
    ot.RandomGenerator.SetSeed(1)
    vector = ot.RandomVector(ot.JointDistribution([ot.Normal(0.6, 0.1), ot.Normal(0.45, 0.12)]))
    event = ot.ThresholdEvent(ot.CompositeRandomVector(ot.SymbolicFunction(["mu", "k"], ["mu - k"]), vector), ot.Less(), 0.0)
    algorithm = ot.ProbabilitySimulationAlgorithm(event, ot.MonteCarloExperiment())
    algorithm.setMaximumOuterSampling(count // 4096)
    algorithm.setBlockSize(4096)
    algorithm.setMaximumCoefficientOfVariation(0.0)
    start = time.process_time()
    algorithm.run()
    theirs = time.process_time() - start
    found = algorithm.getResult().getProbabilityEstimate()
    exact = 0.5 * math.erfc((0.6 - 0.45) / math.hypot(0.1, 0.12) / math.sqrt(2))
    start = time.process_time()
    ot.JointDistribution([ot.Normal(0.6, 0.1), ot.Normal(0.45, 0.12)]).getSample(count)
    alone = time.process_time() - start
    print(f"plain Monte Carlo of μ − k, {count} samples: OpenTURNS {1e9 * theirs / count:.0f} ns a sample (drawing alone {1e9 * alone / count:.0f}), P {found:.6f}, exact {exact:.6f}")
    rng = np.random.default_rng(1)
    start = time.process_time()
    share = np.mean(rng.normal(0.6, 0.1, count) < rng.normal(0.45, 0.12, count))
    print(f"numpy: {1e9 * (time.process_time() - start) / count:.0f} ns a sample, P {share:.6f}")


def main(program):
    ot.TBB.Disable()  # one thread
    print(f"OpenTURNS {ot.__version__}, pystra {ra.__version__}, numpy {np.__version__}, Python {sys.version.split()[0]}")
    indices(program)
    small_region(program)
    drawing()


if __name__ == "__main__":
    main(sys.argv[1])
