"""Modes in arrays and columns: what is selected and joined stays of modes, and no comparison with a wrong word is a row of ``False``."""

from __future__ import annotations

import pickle
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pandas as pd
import pytest
import standfast
from standfast import Mode, ModeArray, ModeNames, StandfastError

CODES = standfast.classify(1, 0.4, [0.5, 0.7, 0.1], [0.6, 0.6, 0.6])
WORDS = standfast.classify(1, 0.4, [0.5, 0.7, 0.1], [0.6, 0.6, 0.6], names=True)
MASKED = standfast.classify(1, 0.4, np.ma.masked_greater([0.5, 0.7, 5], 1), 0.6)
COLUMN = standfast.classify(1, 0.4, pd.Series([0.5, 0.7, 0.1]), 0.6)
PLANE = {"point": {"gamma": 0.8, "k_prime": 0.9, "k": 0.5}, "random": {"mu": {"uniform": {"from": 0.4, "to": 0.6}}}}
CASE = {"body": {"width": 9, "height": 3, "mass": 5e4, "friction": 0.5}, "load": [{"force": 1e5, "elevation": 0.5}]}
SWEPT = standfast.assess_table(CASE, {"friction": [0.6, 0.1, 0.7]}, columns=["mode"])["mode"]

#: What of a mode's codes [0, 1, 0] has many, each made of them in another way.
OF_CODES: dict[str, Callable[[], Any]] = {
    "as they come": lambda: CODES,
    "joined": lambda: np.concatenate([CODES[:1], CODES[1:]]),
    "joined with codes": lambda: np.concatenate([[0], CODES[1:]]),
    "joined with words": lambda: np.concatenate([CODES[:2], ["RE"]]),
    "joined with modes": lambda: np.append(CODES[:2], Mode.REST),
    "stacked": lambda: np.stack([CODES, CODES])[0],
    "in rows": lambda: np.vstack([CODES, CODES])[1],
    "in a row": lambda: np.hstack((CODES[:1], CODES[1:])),
    "in columns": lambda: np.column_stack([CODES, CODES])[:, 0],
    "in blocks": lambda: np.block([[CODES], [CODES]])[0],
    "chosen": lambda: np.where([False, True, False], Mode.SLIDE_LEFT, CODES),
    "chosen of words": lambda: np.where([False, True, False], "SL", CODES),
    "selected": lambda: np.select([np.array([False, True, False])], [CODES], Mode.REST),
    "chosen by place": lambda: np.choose([0, 1, 0], [CODES, CODES]),
    "inserted": lambda: np.insert(CODES[::2], 1, "SL"),
    "repeated": lambda: np.tile(CODES, 2)[:3],
    "turned round": lambda: np.flip(CODES),
    "taken": lambda: CODES.take([0, 1, 2]),
    "reshaped": lambda: CODES.reshape(3, 1).ravel(),
    "copied": lambda: CODES.copy(),
    "pickled": lambda: pickle.loads(pickle.dumps(CODES)),
    "of another type": lambda: CODES.astype(np.int64),
    "beside what is missing": lambda: np.concatenate([CODES, [np.nan]])[:3],
}


def found(made: Any) -> list[bool]:
    return np.asarray(made).tolist()


@pytest.mark.parametrize("name", OF_CODES)
def test_what_is_made_of_codes_compares_as_they_do(name: str) -> None:
    made = OF_CODES[name]()
    assert isinstance(made, ModeArray) and (made.dtype == np.uint8 or name in ("of another type", "beside what is missing"))
    for mode in ("SL", Mode.SLIDE_LEFT, 1, np.uint8(1)):
        assert found(made == mode) == [False, True, False] and found(made != mode) == [True, False, True]
        assert found(mode == made) == [False, True, False] and mode in made
    with pytest.raises(StandfastError, match="'slides' is not a mode; expected RE, SL, RO, "):
        _ = made == "slides"


OF_WORDS: dict[str, Callable[[], Any]] = {
    "as they come": lambda: WORDS,
    "of codes": lambda: CODES.names,
    "of codes by their type": lambda: CODES.astype(str),
    "of a sweep": lambda: SWEPT,
    "symbols": lambda: standfast.symbols(CODES),
    "joined": lambda: np.concatenate([WORDS[:1], ["SL"], WORDS[2:]]),
    "joined with codes": lambda: np.concatenate([WORDS[:2], CODES[2:]]),
    "stacked": lambda: np.stack([WORDS, WORDS])[0],
    "chosen": lambda: np.where([True, True, False], WORDS, "RE"),
    "chosen by mode": lambda: np.where([False, True, False], Mode.SLIDE_LEFT, WORDS),
    "pickled": lambda: pickle.loads(pickle.dumps(WORDS)),
}


@pytest.mark.parametrize("name", OF_WORDS)
def test_what_is_made_of_words_compares_as_they_do(name: str) -> None:
    made = OF_WORDS[name]()
    assert isinstance(made, ModeNames) and made.tolist() == ["RE", "SL", "RE"]
    for mode in ("SL", Mode.SLIDE_LEFT, 1, np.uint8(1), ["SL"] * 3, CODES[1]):
        assert found(made == mode) == [False, True, False] and found(made != mode) == [True, False, True]
    assert "SL" in made and Mode.SLIDE_LEFT in made and "RO" not in made
    assert made.code.tolist() == [0, 1, 0] and made.names is made
    for wrong in ("slides", ["RE", "slides", "RE"], np.array(["slides"]), b"SL"):
        with pytest.raises(StandfastError, match="is not a mode; expected RE, SL, RO, "):
            _ = made == wrong
        with pytest.raises(StandfastError, match="is not a mode"):
            _ = made != wrong


def test_questions_of_numpy_know_modes() -> None:
    assert np.isin(WORDS, [Mode.SLIDE_LEFT]).tolist() == np.isin(CODES, ["SL"]).tolist() == [False, True, False]
    assert np.array_equal(CODES, ["RE", "SL", "RE"]) and np.array_equal(WORDS, CODES) and not np.array_equal(CODES, ["RE", "SL", "SL"])
    assert np.setdiff1d(CODES, ["RE"]) == ["SL"] and np.union1d(CODES, ["RO"]).names.tolist() == ["RE", "SL", "RO"]
    assert np.max(CODES) is Mode.SLIDE_LEFT and CODES.min() is Mode.REST and np.maximum(CODES, "SL").names.tolist() == ["SL"] * 3
    assert [array.tolist() for array in np.where(CODES)] == [[1]] and type(np.where(CODES)[0]) is np.ndarray
    unique, counts = np.unique(CODES, return_counts=True)
    assert unique.names.tolist() == ["RE", "SL"] and counts.tolist() == [2, 1]
    for asked in (lambda: np.isin(WORDS, ["slides"]), lambda: np.array_equal(CODES, ["RE", "slides", "RE"]), lambda: np.setdiff1d(CODES, ["x"])):
        with pytest.raises(StandfastError, match="is not a mode"):
            asked()


def test_modes_are_put_into_arrays_under_each_of_their_names() -> None:
    codes, words = CODES.copy(), WORDS.copy()
    for mode in ("RO", Mode.ROCK_O, 2):
        codes[0], words[0] = mode, mode
        assert codes[0] is Mode.ROCK_O and words[0] == "RO"
    codes[1:] = ["SL", "FL"]
    assert codes.names.tolist() == ["RO", "SL", "FL"]
    for array in (codes, words):
        with pytest.raises(StandfastError, match="'slides' is not a mode"):
            array[0] = "slides"
    with pytest.raises(StandfastError, match="codes of modes are 0 to 10"):
        _ = np.array([255], dtype=np.uint8).view(ModeArray).names


def test_an_empty_word_is_of_no_mode() -> None:
    words = np.where([True, False], ModeArray([1, 1]).names, "")
    assert isinstance(words, ModeNames) and (words == "").tolist() == [False, True] and (words == "SL").tolist() == [True, False]
    assert words.to_pandas().isna().tolist() == [False, True]
    with pytest.raises(StandfastError, match="'' is not a mode"):
        _ = words.code


def test_masked_arrays_stay_of_modes() -> None:
    for made in (MASKED, np.ma.concatenate([MASKED[:1], MASKED[1:]]), MASKED.copy(), MASKED[::-1][::-1]):
        assert (made == "SL").tolist() == [False, True, None]
        with pytest.raises(StandfastError, match="'slides' is not a mode"):
            _ = made == "slides"


def test_arrow_columns_give_arrays_of_modes() -> None:
    words = standfast.draws(PLANE, 200).mode
    array = words.to_numpy()
    assert isinstance(array, ModeNames) and (array == Mode.REST).tolist() == (words == "RE").tolist() and (words == "RE").any()
    for wrong in (lambda: array == "rest", lambda: words == ["rest"] * 200):
        with pytest.raises(StandfastError, match="'rest' is not a mode"):
            wrong()
    duckdb = pytest.importorskip("duckdb")
    codes = standfast.classify(duckdb.sql("select 1 gamma, 1 k_prime, 2 k, unnest([5, 0.1, null]) mu"))
    for missing in ({}, {"missing": 255}):
        plain = codes.to_numpy(**missing)
        assert isinstance(plain, ModeArray) and (plain == "RO").tolist() == [True, False, False]


def test_an_item_and_a_category_of_a_column_of_pandas_know_modes() -> None:
    assert COLUMN.iloc[1] == "SL" and COLUMN.iloc[1] is Mode.SLIDE_LEFT and COLUMN[0] == "RE" and list(COLUMN) == ["RE", "SL", "RE"]
    with pytest.raises(StandfastError, match="'slides' is not a mode"):
        _ = COLUMN.iloc[1] == "slides"
    for words in (COLUMN.astype("category"), CODES.to_pandas().astype("category"), WORDS.to_pandas(), COLUMN.astype(pd.CategoricalDtype())):
        assert isinstance(words.dtype, pd.CategoricalDtype) and (words == "SL").tolist() == (words == Mode.SLIDE_LEFT).tolist() == [False, True, False]
        with pytest.raises(StandfastError, match="'slides' is not a mode"):
            _ = words == "slides"
    assert COLUMN.astype(str).tolist() == ["RE", "SL", "RE"]
    assert COLUMN.apply(lambda mode: mode.symbol).tolist() == ["RE", "SL", "RE"] and COLUMN.map({"SL": "slides"}).tolist()[1] == "slides"
    assert COLUMN.astype(object).tolist() == [0, 1, 0] and COLUMN.to_csv(index=False).split() == ["mode", "0", "1", "0"]
    numbers = COLUMN.astype("int64")
    assert numbers.tolist() == [0, 1, 0] and str(COLUMN.dtype) == "UInt8" and repr(COLUMN).splitlines()[1].split() == ["1", "1"]
    missing = COLUMN.shift()
    assert missing.iloc[0] is pd.NA and missing.iloc[2] == "SL" and missing.astype("category").isna().tolist() == [True, False, False]
    joined = pd.concat([COLUMN, COLUMN], ignore_index=True)
    assert (joined == "SL").sum() == 2 and joined.value_counts().tolist() == [4, 2] and COLUMN.max() is Mode.SLIDE_LEFT
    frame = pd.DataFrame({"mode": CODES.to_pandas()})
    assert frame[frame["mode"] == "SL"].index.tolist() == [1] and frame["mode"].iloc[1] == "SL"


def test_plain_words_of_python_are_what_is_left() -> None:
    """What the guide says cannot be kept, so that it says so for as long as it is true."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        assert not (np.asarray(CODES) == "SL").any() and WORDS[1] != "slides" and CODES.tolist()[1] != "SL"
        assert not (pd.Series(CODES) == "SL").any()
    assert (ModeArray(np.asarray(CODES)) == "SL").any() and Mode(CODES.tolist()[1]) == "SL" and ModeNames(WORDS[1:2]) == "SL"
