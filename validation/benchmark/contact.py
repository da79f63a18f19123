"""All ten contact modes of a block that stands on two corners, from Newton's and Coulomb's laws alone.

Nothing here is taken from standfast: it is the witness that the data are held against. Numbers may be floats or `fractions.Fraction`.
Lengths are in half widths B, accelerations in g, forces in m g; x to the right, y upwards, angles counter-clockwise.
"""

from fractions import Fraction

#: mode: which corners stay on the base (left O, right O'), and the direction of slip; None sticks.
MODES = {
    "RE": ((True, True), None),
    "SL": ((True, True), -1),
    "SL+": ((True, True), 1),
    "RO": ((True, False), None),
    "RO'": ((False, True), None),
    "SRO-": ((True, False), -1),
    "SRO+": ((True, False), 1),
    "SRO'-": ((False, True), -1),
    "SRO'+": ((False, True), 1),
    "FL": ((False, False), 0),
}


def solve(rows):
    """Solution of linear equations, each a list of coefficients with the right side last; None if there is not just one."""
    rows = [list(row) for row in rows]
    size = len(rows)
    for i in range(size):
        best = max(range(i, size), key=lambda j: abs(rows[j][i]))
        if rows[best][i] == 0:
            return None
        rows[i], rows[best] = rows[best], rows[i]
        pivot = rows[i][i]
        rows[i] = [value / pivot for value in rows[i]]
        for j in range(size):
            if j != i and rows[j][i] != 0:
                factor = rows[j][i]
                rows[j] = [a - factor * b for a, b in zip(rows[j], rows[i])]
    return [row[-1] for row in rows]


def motion(mode, gamma, k_prime, k, mu):
    """The motion in which the contact is as `mode` says, whether or not its inequalities hold; None if there is none."""
    closed, slip = MODES[mode]
    one = gamma / gamma
    inertia = (one + gamma * gamma) / 3
    # Unknown: x_ddot, y_ddot, theta_ddot, N and N' of the corners (-1, -γ) and (1, -γ), T of both.
    rows = [
        [one, 0, 0, 0, 0, -one, -k],  # m ẍ = T − F
        [0, one, 0, -one, -one, 0, -one],  # m ÿ = N + N' − m g
        [0, 0, inertia, one, -one, -gamma, k * k_prime * gamma],  # I θ̈ = −N + N' + γ T + F h
        [0, one, -one, 0, 0, 0, 0] if closed[0] else [0, 0, 0, one, 0, 0, 0],  # O stays down, or has no reaction
        [0, one, one, 0, 0, 0, 0] if closed[1] else [0, 0, 0, 0, one, 0, 0],  # the same for O'
    ]
    if slip is None:
        rows.append([one, 0, gamma, 0, 0, 0, 0])  # the base does not move along the ground
    else:
        rows.append([0, 0, 0, slip * mu, slip * mu, one, 0])  # T = −s μ (N + N')
    found = solve(rows)
    if found is None:
        return None
    ax, ay, alpha, left, right, along = found
    slide = ax + gamma * alpha
    answer = dict(x_ddot=ax, y_ddot=ay, theta_ddot=alpha, slip_left=slide, lift_left=ay - alpha, slip_right=slide,
                  lift_right=ay + alpha, N_left=left, N_right=right, T=along)
    # Along and up of each corner: both have the same acceleration along the ground, for nothing turns yet.
    return answer


def holds(mode, found, mu):
    """Whether every condition of the mode holds: no pull, no corner goes down, friction within Coulomb's cone, slip against it."""
    closed, slip = MODES[mode]
    normal = found["N_left"] + found["N_right"]
    for side, name in zip(closed, ("left", "right")):
        if side and found["N_" + name] < 0:
            return False
        if not side and found["lift_" + name] <= 0:
            return False
    if slip is None:
        return abs(found["T"]) <= mu * normal
    return slip == 0 or slip * found["slip_left"] > 0


def consistent(gamma, k_prime, k, mu):
    """All modes whose motion satisfies all conditions, with that motion."""
    answer = {}
    for mode in MODES:
        found = motion(mode, gamma, k_prime, k, mu)
        if found is not None and holds(mode, found, mu):
            answer[mode] = found
    return answer


def exact(gamma, k_prime, k, mu):
    """The same in exact arithmetic, of decimals as they are written."""
    return consistent(*(Fraction(str(value)) for value in (gamma, k_prime, k, mu)))


def candidates(gamma, k_prime, k, mu):
    """All factors of k and of μ at which the sign of some condition of some mode changes: each is linear in either."""
    found = []
    for name in ("k", "mu"):
        value = k if name == "k" else mu

        def signs(at):
            numbers = (gamma, k_prime, at, mu) if name == "k" else (gamma, k_prime, k, at)
            for mode, (closed, slip) in MODES.items():
                a = motion(mode, *numbers)
                if a is None:
                    continue
                scale = 1.0
                if slip and closed != (True, True):
                    corner = -1 if closed[0] else 1
                    # The inertia of a corner in slip; multiplied by it the conditions have no pole.
                    scale = (1 + gamma**2) / 3 + corner * (corner - slip * numbers[3] * gamma)
                    yield mode, "inertia", scale
                for key in ("N_left", "N_right", "lift_left", "lift_right", "slip_left"):
                    yield mode, key, a[key] * scale
                if slip is None:
                    normal = a["N_left"] + a["N_right"]
                    yield mode, "cone-", a["T"] - numbers[3] * normal
                    yield mode, "cone+", a["T"] + numbers[3] * normal

        low, high = {s[:2]: s[2] for s in signs(value * 0.9)}, {s[:2]: s[2] for s in signs(value * 1.1)}
        for key in low.keys() & high.keys():
            a, b = low[key], high[key]
            if abs(b - a) > 1e-12:
                factor = 0.9 - 0.2 * a / (b - a)
                if factor > 1e-6:
                    found.append((name, factor))
    return sorted(set(found), key=lambda item: (abs(item[1] - 1), item[0], item[1]))


def boundary(gamma, k_prime, k, mu):
    """The nearest change of the set of consistent modes: by k or mu, its factor, and the modes beyond it."""
    here = set(consistent(gamma, k_prime, k, mu))
    for name, factor in candidates(gamma, k_prime, k, mu):
        beyond = factor + (1e-7 if factor > 1 else -1e-7)
        numbers = (gamma, k_prime, k * beyond, mu) if name == "k" else (gamma, k_prime, k, mu * beyond)
        there = consistent(*numbers)
        if set(there) != here:
            return name, factor, list(there)
    return None
