"""Arguments of the verbs: what they must be, in one line each."""
from __future__ import annotations

import functools
import inspect
import operator
import os

import numpy as np

from ._keiko import Error  # type: ignore[import]


def error(argument: str, reason: str) -> Exception:
    """Bad input in an argument."""
    made = Error(f"{argument}: {reason}")
    made.file, made.where, made.reason = "", argument, reason
    return made


def _whole(value):
    if isinstance(value, (bool, np.bool_)):
        raise TypeError
    return operator.index(value)


def _number(value):
    if isinstance(value, (str, bytes, bool, np.bool_)) or np.ndim(value):
        raise TypeError
    return float(value)


def _flag(value):
    if not isinstance(value, (bool, np.bool_)):
        raise TypeError
    return bool(value)


def _text(value):
    if not isinstance(value, (str, os.PathLike)):
        raise TypeError
    return os.fspath(value)


# By the annotation of an argument: how it is taken, and what it must be.
_KINDS = {"int": (_whole, "a whole number"), "float": (_number, "a number"), "bool": (_flag, "True or False"),
          "str": (_text, "a text")}


def _taken(name: str, annotation: str, value):
    kind = annotation.removesuffix(" | None")
    if kind not in _KINDS or (value is None and kind != annotation):
        return value
    take, meaning = _KINDS[kind]
    try:
        return take(value)
    except (TypeError, ValueError, OverflowError):
        given = repr(value)
        raise TypeError(f"{name}: {meaning} is needed, not {given[:60]}") from None


def number(name: str, value) -> float:
    """A number. What is none raises TypeError with the name of the argument."""
    return _taken(name, "float", value)


def each_number(name: str, value) -> list:
    """The numbers of an iterable, or one number alone. What is none raises TypeError with the name of the argument."""
    try:
        several = iter(value)
    except TypeError:
        several = iter([value])
    return [number(name, one) for one in several]


def checked(verb):
    """The verb, which takes its annotated arguments as whole numbers, numbers, flags and texts.

    What is none raises TypeError with the name of the argument.
    """
    signature = inspect.signature(verb)
    kinds = {name: given.annotation if isinstance(given.annotation, str) else given.annotation.__name__
             for name, given in signature.parameters.items() if given.annotation is not inspect.Parameter.empty}

    @functools.wraps(verb)
    def wrapped(*args, **kwargs):
        bound = signature.bind(*args, **kwargs)
        for name, value in bound.arguments.items():
            if name in kinds:
                bound.arguments[name] = _taken(name, kinds[name], value)
        if not 0 <= bound.arguments.get("threads", 0) <= 1024:
            raise error("threads", "is not 0 to 1024")
        return verb(*bound.args, **bound.kwargs)
    return wrapped


def rows(argument: str, values, columns: int, meaning: str):
    """Numbers as an array (n, columns). Raises Error for another shape and for what is no number."""
    wanted = f"an array of n rows of {columns} is needed: {meaning}"
    try:
        given = np.asarray(values)
        if given.dtype.kind not in "fiuO" or given.ndim != 2 or given.shape[1] != columns:
            raise error(argument, wanted)
        if given.dtype.kind == "O" and any(isinstance(item, (str, bytes, complex)) for item in given.flat):
            raise error(argument, wanted)
        return np.ascontiguousarray(given, float)
    except Error:
        raise
    except (TypeError, ValueError, OverflowError):
        raise error(argument, wanted) from None
