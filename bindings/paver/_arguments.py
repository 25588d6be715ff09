"""Arguments as the compiled module takes them; what it would take for something else is refused in a sentence."""
import operator
import os

from ._errors import OptionError


def encoded_path(path):
    """Bytes of a path. OptionError for one with a NUL character, at which the system would cut it off."""
    name = os.fsencode(path)
    if b"\0" in name:
        raise OptionError(f"The path {os.fsdecode(name)!r} has a NUL character; leave it out.", "bad_option", "leave it out")
    return name


def whole_number(name, value):
    try:
        return operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is {value!r}; write a whole number.") from None


def whole_numbers(name, values):
    """An int32 array of whole numbers from 0. ValueError for others, which would be cut or wrapped round."""
    import numpy as np
    array = np.asarray(values)
    if array.dtype.kind not in "iu" and array.size:
        raise ValueError(f"{name} has numbers of the type {array.dtype}; pass whole numbers.")
    limit = np.iinfo(np.int32).max
    wrong = array[(array < 0) | (array > limit)] if array.size else ()
    if len(wrong):
        raise ValueError(f"{name} has {wrong[0]}; it must be from 0 to {limit}.")
    return array.astype(np.int32, copy=False)


def texts(name, values):
    found = list(values)
    wrong = [value for value in found if not isinstance(value, str)]
    if wrong:
        raise TypeError(f"{name} has {wrong[0]!r}; pass texts.")
    return found


def in_one_piece(content):
    """Bytes, or what has its bytes one after the other, as memory is read; a copy of a view that skips some."""
    return content.tobytes() if isinstance(content, memoryview) and not content.c_contiguous else content
