"""The mode of response from the accelerations of the bottom corners."""

# In g: less than this is taken for none.
THRESHOLD = 0.01


def mode(slip_left, lift_left, slip_right, lift_right, threshold=THRESHOLD):
    """`slip` to the right and `lift` upwards of O (left) and O' (right), in g."""
    left, right = lift_left > threshold, lift_right > threshold
    if left and right:
        return "FL"
    slip = slip_right if left else slip_left
    slides = "-" if slip < -threshold else "+" if slip > threshold else ""
    if left or right:
        corner = "O'" if left else "O"
        return f"SRO{corner[1:]}{slides}" if slides else f"RO{corner[1:]}"
    return {"": "RE", "-": "SL", "+": "SL+"}[slides]
