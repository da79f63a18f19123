"""What a type checker says of calls: checked by mypy, never run."""

from typing import assert_type

import numpy as np
import polars as pl
import standfast
from numpy.typing import NDArray
from standfast import Answer, ArrowArray, ArrowTable, Assessment, Diagram, Figure, Mode, Onset

assert_type(standfast.classify(1, 0.4, 0.5, 0.6), Mode)
assert_type(standfast.classify(1, 0.4, 0.5, 0.6, names=True), str)
assert_type(standfast.classify(1, 0.4, np.ones(3), [0.6]), NDArray[np.uint8])
assert_type(standfast.classify(1, 0.4, np.ones(3), 0.6, names=True), NDArray[np.str_])
assert_type(standfast.classify(pl.DataFrame(), map={"mu": "friction", "k_prime": 0.4}), ArrowArray)
assert_type(standfast.onset(1, 0.4, 0.5, 0.6), Onset)
assert_type(standfast.onset(pl.DataFrame()), ArrowTable)
assert_type(standfast.assess({"body": {}}), Assessment)
assert_type(standfast.assess("case.toml", up_to=3, all=True).figures, list[Figure])
assert_type(standfast.assess("case.toml").situations, list[Answer])
assert_type(standfast.assess("case.toml").governing, Answer)
assert_type(standfast.assess("case.toml").to_json(), str)
assert_type(Diagram(1, 0.4).regions[0].mode, Mode)
