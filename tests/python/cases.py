# SPDX-License-Identifier: AGPL-3.0-or-later
"""Runs the case test_NAME of a script: python3 SCRIPT NAME. tests/cli/python.test makes the files."""
import sys
import warnings

import numpy as np

WALL = 20.0  # mm behind the sheet


def colour_of_wall(x, y):
    """The linear red and green of the wall of the test's scenes at a place in mm."""
    return np.stack([(x + 100) / 200, (y + 100) / 200], axis=-1)


def same(got, expected):
    assert got.dtype == expected.dtype, (got.dtype, expected.dtype)
    assert got.shape == expected.shape, (got.shape, expected.shape)
    assert np.array_equal(got, expected), f"{(got != expected).mean():.2%} differ"


def near(got, expected, tolerance):
    assert np.shape(expected) in ((), np.shape(got)), (np.shape(got), np.shape(expected))
    error = np.abs(np.asarray(got, dtype=float) - expected).max()
    assert error <= tolerance, f"{error} is more than {tolerance}"


def raises(kind, sentence, call, *arguments, **words):
    """The call raises `kind` with the sentence in its message."""
    try:
        call(*arguments, **words)
    except kind as error:
        assert sentence in str(error), str(error)
        return error
    raise AssertionError(f"{kind.__name__} was not raised: {sentence}")


def warns(sentence, call, *arguments, **words):
    """The result of the call, which warns with the sentence."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        result = call(*arguments, **words)
    assert any(sentence in str(w.message) for w in caught), [str(w.message) for w in caught]
    assert all(w.filename == __file__ for w in caught), [w.filename for w in caught]  # its caller
    return result


def run(names):
    warnings.simplefilter("error")
    names["test_" + sys.argv[1]]()
