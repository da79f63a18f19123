"""Modes and sets of modes: a code is never taken for bits, nor bits for a code."""

import numpy as np
import pytest
import standfast
from standfast import Mode, Modes


def test_a_mode_prints_as_its_symbol():
    assert [str(mode) for mode in (Mode.REST, Mode.SLIDE_ROCK_O_PRIME_LEFT)] == ["RE", "SRO'-"]
    assert f"{Mode.ROCK_O:>4}|{Modes.of(Mode.SLIDE_LEFT, Mode.ROCK_O)}" == "  RO|SL RO"


#: Those of a body; ground that fails is in no set of them.
OF_BODIES = [mode for mode in Mode if mode != "BF"]


@pytest.mark.parametrize("mode", OF_BODIES)
def test_a_mode_among_sets_is_the_set_of_it(mode):
    alone = Modes.of(mode)
    assert int(alone) == 2 ** int(mode)
    assert Modes(mode) == alone == Modes(str(alone))
    everything = Modes(2 ** len(OF_BODIES) - 1)
    assert everything & mode == mode & everything == alone
    assert (everything ^ mode) | mode == mode | (everything ^ mode) == everything
    assert mode not in everything ^ mode
    for other in OF_BODIES:
        assert (mode | other).modes == tuple(sorted({mode, other}))
        assert bool(mode & other) == (mode is other)


def test_bits_are_no_codes():
    found = standfast.onset(1, -0.5, [4.0, 0.1], 3)
    assert [Modes(bits).modes for bits in found.others] == [(Mode.ROCK_O,), ()]
    assert ((found.others & Modes.ROCK_O) != 0).tolist() == [True, False]
    for bits in (found.others, Modes.ROCK_O):
        with pytest.raises(TypeError, match=r"sets of modes.*Modes\(bits\)"):
            standfast.symbols(bits)
    assert standfast.symbols(np.array([1, 2], dtype=np.uint8)).tolist() == ["SL", "RO"]
