"""How probable is each mode when force, elevation and friction are uncertain? A million samples, by numpy."""

import numpy as np
import standfast

random = np.random.default_rng(2025)
samples = 1_000_000
gamma = 0.8
k = random.gumbel(0.55, 0.08, samples).clip(0)
k_prime = random.normal(0.9, 0.05, samples)
mu = random.normal(0.6, 0.06, samples).clip(0)

codes = standfast.classify(gamma, k_prime, k, mu, threads=None)
for code, count in zip(*np.unique(codes, return_counts=True)):
    mode = standfast.Mode(code)
    print(f"{mode.symbol:5} {count / samples:7.2%}  the body {mode.words}")
