"""Modes and sets of modes: a code is never taken for bits, nor bits for a code."""

import pickle
from pathlib import Path

import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pytest
import standfast
from standfast import Mode, ModeArray, Modes


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


CODES = standfast.classify(1, 0.4, [0.5, 0.7, 0.1], [0.6, 0.6, 0.6])


def test_codes_compare_with_a_mode_a_code_and_a_word():
    assert type(CODES) is ModeArray and CODES.dtype == np.uint8
    for other in ("SL", Mode.SLIDE_LEFT, 1, np.uint8(1), [1, 1, 1], ["SL", "SL", "SL"], [Mode.SLIDE_LEFT, "SL", 1], np.array("SL")):
        for left, right in ((CODES, other), (other, CODES)):
            if not isinstance(left, (str, list)):
                assert np.asarray(left == right).tolist() == [False, True, False], other
                assert np.asarray(left != right).tolist() == [True, False, True], other
    assert "SL" in CODES and Mode.SLIDE_LEFT in CODES and 1 in CODES and "RO" not in CODES
    for wanted in (["SL", "RO"], {"SL"}, [Mode.SLIDE_LEFT], [1]):
        assert np.isin(CODES, wanted).tolist() == [False, True, False]
    assert CODES[1] is Mode.SLIDE_LEFT and [mode.symbol for mode in CODES] == ["RE", "SL", "RE"]
    assert CODES[1:] is not None and (CODES[1:] == "SL").tolist() == [True, False] and (CODES[CODES == "SL"] == "SL").all()


@pytest.mark.parametrize("wrong", ["slide", ["RE", "slide", "SL"], "0"])
def test_a_word_that_names_no_mode_is_an_error(wrong):
    with pytest.raises(ValueError, match="is not a mode; expected RE, SL, RO, SRO-, "):
        _ = wrong == CODES
    with pytest.raises(ValueError, match="is not a mode"):
        np.isin(CODES, wrong)
    if isinstance(wrong, str):
        for said in (lambda: wrong in CODES, lambda: Mode.REST == wrong, lambda: Mode.REST in (wrong,), lambda: Mode.REST != wrong):
            with pytest.raises(ValueError, match="is not a mode"):
                said()


def test_codes_and_names_go_both_ways():
    assert CODES.names.tolist() == ["RE", "SL", "RE"] and type(CODES.code) is np.ndarray
    assert ModeArray(CODES.names).code.tolist() == ModeArray([Mode.REST, "SL", 0]).code.tolist() == CODES.code.tolist() == CODES.tolist()
    assert Mode.SLIDE_LEFT.code == 1 and type(Mode.SLIDE_LEFT.code) is int and f"{Mode.SLIDE_LEFT:d}" == "1"
    again = pickle.loads(pickle.dumps(CODES))
    assert type(again) is ModeArray and (again == CODES).all()
    for wrong in ([11], [1.5], ["XX"], [-1]):
        with pytest.raises(ValueError, match="modes|mode"):
            ModeArray(wrong)


def test_what_is_computed_with_codes_is_plain():
    assert type(CODES + 1) is np.ndarray and type(CODES == 1) is np.ndarray and np.bincount(CODES, minlength=3).tolist() == [2, 1, 0]
    assert repr(CODES) == "ModeArray([0, 1, 0], dtype=uint8)" and CODES.max() == 1
    masked = standfast.classify(1, 0.4, np.ma.masked_greater([0.5, 0.7, 5], 1), 0.6)
    assert (masked == "SL").tolist() == (masked == Mode.SLIDE_LEFT).tolist() == [False, True, None]


def test_a_mode_compares_with_columns_of_codes_and_of_words():
    words = ["RE", "SL", None]
    for column in (
        pd.Series(words), pd.Series(words, dtype="category"), pd.Series(words, dtype="string"), pd.Series(words, dtype=object),
        pd.Series([0, 1, 9]), pd.Series([0, 1, None], dtype="UInt8"), standfast.classify(1, 0.4, pd.Series([0.5, 0.7, None]), 0.6),
        pd.Categorical(words), pd.Index([0, 1, 9]), pd.Series(words, dtype="category").cat.add_categories("BF"),
    ):  # fmt: skip
        for found in (column == Mode.SLIDE_LEFT, Mode.SLIDE_LEFT == column):
            assert [one is not pd.NA and bool(one) for one in found] == [False, True, False], column
    assert (pd.DataFrame({"a": ["SL"], "b": ["RE"]}) == Mode.SLIDE_LEFT).values.tolist() == [[True, False]]
    assert (np.array(["RE", "SL"]) == Mode.SLIDE_LEFT).tolist() == (np.array(["RE", "SL"], dtype=object) == Mode.SLIDE_LEFT).tolist() == [False, True]
    assert (np.array([0, 1]) == Mode.SLIDE_LEFT).tolist() == [False, True] and (np.array([0, 2]) > Mode.SLIDE_LEFT).tolist() == [False, True]


def test_a_mode_beside_a_set_of_modes_is_an_error():
    for wrong in (
        lambda: Mode.SLIDE_LEFT == Modes.REST, lambda: Modes.SLIDE_LEFT == Mode.SLIDE_LEFT, lambda: Mode.REST != Modes.REST,
        lambda: CODES == Modes.REST, lambda: Mode(Modes.REST), lambda: standfast.onset(1, -0.5, [4, 1], 3).others == Mode.ROCK_O,
        lambda: standfast.classify(1, 0.4, pd.Series([0.5, 0.7]), 0.6) == Modes.REST,
    ):  # fmt: skip
        with pytest.raises(TypeError, match="set"):
            wrong()
    assert Mode.SLIDE_LEFT in Modes.SLIDE_LEFT and Modes(Mode.SLIDE_LEFT) == Modes.SLIDE_LEFT == 2


def test_tables_carry_words_as_categories():
    plane = {"point": {"gamma": 0.8, "k_prime": 0.9, "k": 0.5}, "random": {"mu": {"uniform": {"from": 0.4, "to": 0.6}}}}
    block = {"block": {"b1": 1, "b2": 1, "d": 3, "mu_s": 0.4, "gravity": 1}}
    for column in (standfast.draws(plane, 50).mode, standfast.simulate(block, base=[0.6, 0.6], dt=1).series(0.5).state):
        assert column.type == "dictionary of strings" and set(column.to_pylist()) <= {mode.symbol for mode in Mode}
        assert isinstance(column.to_pandas().dtype, pd.CategoricalDtype) and pa.types.is_dictionary(pa.array(column).type)
        assert pl.Series(column).dtype in (pl.Categorical, pl.Enum)
        word = column[0]
        found = (column == word).tolist()
        assert any(found) and found == (column == Mode(word)).tolist() == (column.to_pandas() == Mode(word)).tolist()
        with pytest.raises(ValueError, match="'rest' is not a mode"):
            _ = column == "rest"
        assert ModeArray(column).names.tolist() == column.to_pylist()


def test_words_in_a_column_of_pandas_are_looked_for_by_mode_code_and_word() -> None:
    """Wherever the column comes from and whatever is done with it, a mode is found under each of its names."""
    case = {"body": {"width": 9, "height": 3, "mass": 5e4, "friction": 0.5}, "load": [{"force": 1e5, "elevation": 0.5}]}
    table = standfast.assess_table(case, pd.DataFrame({"friction": [0.1, 0.6, 0.15, 0.7]}), columns=["mode", "SF_sliding"])
    slides = [True, False, True, False]
    columns = {
        "a table": table["mode"],
        "points": standfast.classify(pd.Series([1.0] * 4), 0.0, pd.Series([0.2, 0.0, 0.2, 0.0]), 0.1, names=True),
        "sorted twice": table.sort_values("SF_sliding").sort_index()["mode"],
        "joined": pd.concat([table[:2], table[2:]])["mode"],
        "merged": table.reset_index().merge(table.reset_index(), on="index")["mode_x"],
        "pickled": pickle.loads(pickle.dumps(table))["mode"],
        "as index and back": table.set_index("mode").reset_index()["mode"],
    }
    for name, column in columns.items():
        assert isinstance(column.dtype, pd.CategoricalDtype), name
        for mode in (Mode.SLIDE_LEFT, "SL", 1, np.uint8(1)):
            assert column.isin([mode]).tolist() == slides, (name, mode)
            assert column.isin({mode, Mode.ROCK_O}).tolist() == slides, (name, mode)
            assert (column == mode).tolist() == slides and (column != mode).tolist() == [not one for one in slides], (name, mode)
            assert mode in column.array and column.map({mode: "slides"}).tolist()[0] == "slides", (name, mode)
        assert column.isin(np.array(["SL"])).tolist() == column.isin(pd.Series(["SL"])).tolist() == slides, name
        for wrong in (lambda column=column: column.isin(["slides"]), lambda column=column: column == "slides"):
            with pytest.raises(ValueError, match="'slides' is no mode; expected RE, SL"):
                wrong()
        with pytest.raises(TypeError, match="is a set of modes; expected a mode"):
            column.isin([Modes.SLIDE_LEFT])
    missing = table["mode"].shift()
    assert missing.isna().tolist() == [True, False, False, False] and missing.isin([Mode.SLIDE_LEFT]).tolist() == [False, True, False, True]
    drawn = standfast.draws(Path(__file__).parents[2] / "examples/goda-2000-random.toml", 500).mode
    assert drawn.to_pandas().isin([Mode.SLIDE_LEFT]).tolist() == (drawn == Mode.SLIDE_LEFT).tolist() and "SL" in drawn.to_pandas().array
    assert table.groupby("mode", observed=True).size().to_dict() == {"RE": 2, "SL": 2}
