"""Decimal numbers from text, thousands at once.

A scalar parser in Python costs 50 ns a number, NumPy's text reader about 60. Here eight characters
are one 64-bit word, and every step works on the words of a whole block of text: a number is a
whole number of at most 15 digits divided by a power of ten that floating point holds exactly, so
one division rounds it correctly (W. D. Clinger, How to Read Floating Point Numbers Accurately,
1990). Equal to ``float`` bit for bit. What does not fit that form goes through ``float`` itself.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Words = NDArray[np.uint64]
Index = NDArray[np.intp]
Bytes = NDArray[np.uint8]

_BLOCK = 1 << 17  # bytes handled at once: the block's words stay in the processor's cache
_PAD = 16  # bytes before the text, so that sixteen characters before any number's end exist

_EACH = 0x0101010101010101  # the same byte in all eight places, when multiplied
_ZEROS = np.uint64(0x30 * _EACH)
_DOT_BIT = np.uint64(0x10 * _EACH)  # after subtracting "0", only a dot among valid bytes has it
_HIGH = np.uint64(0x80 * _EACH)
_OVER_NINE = np.uint64(0x76 * _EACH)  # a byte above 9 plus this reaches the high bit
_KEEP_LAST = np.array(
    [0] + [(0xFFFFFFFFFFFFFFFF << (64 - 8 * n)) & 0xFFFFFFFFFFFFFFFF for n in range(1, 9)],
    np.uint64,
)
_POWERS = 10.0 ** np.arange(23)  # all exact
_NEGATIVE = np.uint8(16)
_SIGNED_POWERS = np.concatenate([_POWERS[:16], -_POWERS[:16]])
_LARGEST_EXACT = np.uint64(1 << 53)


def _words(*values: int) -> tuple[np.uint64, ...]:
    return tuple(np.uint64(value) for value in values)


_DOT, _4, _8, _16, _32, _255 = _words(0x30 ^ ord("."), 4, 8, 16, 32, 255)
_PAIRS, _PAIR_MASK = _words(2561, 0x00FF00FF00FF00FF)  # 10 · 2⁸ + 1
_FOURS, _FOUR_MASK = _words(6553601, 0x0000FFFF0000FFFF)  # 100 · 2¹⁶ + 1
_EIGHTS = np.uint64(42949672960001)  # 10⁴ · 2³² + 1
_HIGH_PLACES = np.array([10**8, 10**7], np.uint64)  # of digits before eight without, with a dot


class BadNumberError(ValueError):
    """A token that is no finite decimal number; ``index`` counts tokens, ``start`` bytes."""

    def __init__(self, token: bytes, index: int, start: int) -> None:
        super().__init__(token.decode("latin-1"))
        self.token = token
        self.index = index
        self.start = start


@dataclass(frozen=True)
class Numbers:
    """The numbers of a text and where its lines end.

    Attributes:
        values: (N,) the numbers; NaN or infinite where the text says so.
        line_ends: how many numbers stand before each line break.
    """

    values: Floats
    line_ends: Index


def parse_numbers(data: bytes, start: int = 0) -> Numbers:
    """Every number of ``data[start:]``, separated by any white space.

    Raises:
        BadNumberError: at the first token that is neither a decimal number nor ``nan`` or ``inf``.
    """
    if start < _PAD:
        data, start = b" " * (_PAD + 1) + data[start:], _PAD + 1
    if data[-1:] not in b" \t\r\n":
        data += b"\n"
    words = np.ndarray((len(data) - 7,), "<u8", data, strides=(1,))
    values, line_ends, count = [np.empty(0)], [np.empty(0, np.intp)], 0
    while start < len(data):
        end = _block_end(data, start)
        block = _Block(data, words, start, end)
        try:
            values.append(block.values())
        except BadNumberError as error:
            raise BadNumberError(error.token, count + error.index, error.start) from None
        line_ends.append(block.line_ends() + count)
        count += len(values[-1])
        start = end
    return Numbers(np.concatenate(values), np.concatenate(line_ends))


def _block_end(data: bytes, start: int) -> int:
    """The end of a block from ``start`` on that cuts no token in two."""
    for size in (_BLOCK, 4 * _BLOCK):
        if start + size >= len(data):
            return len(data)
        last = max(data.rfind(space, start, start + size) for space in (b" ", b"\n", b"\t", b"\r"))
        if last >= start:
            return last + 1
    raise BadNumberError(data[start : start + 20], 0, start)


class _Block:
    """Tokens of ``data[start:end]``, which begins after white space and ends with it."""

    def __init__(self, data: bytes, words: Words, start: int, end: int) -> None:
        self.data = data
        self.words = words
        self.base = start - 1  # the white space (or header) before the block separates, too
        self.bytes = np.frombuffer(data, np.uint8, end - self.base, self.base)
        self.starts = self.ends = np.empty(0, np.intp)

    def line_ends(self) -> Index:
        """How many tokens of this block stand before each of its line breaks."""
        breaks = np.flatnonzero(self.bytes[1:] == ord("\n")) + 1
        return np.searchsorted(self.starts, breaks)

    def values(self) -> Floats:
        """The block's numbers."""
        space = self.bytes <= ord(" ")
        if self.bytes.min() < ord("\t"):  # a control character is no white space
            space &= self.bytes >= ord("\t")
        exponent = (self.bytes | 0x20) == ord("e")
        exponent[0] = False
        if exponent.any():
            return self._values_with_exponents(space, exponent)
        self._split(space)
        parts = _read_parts(self.words, self.bytes, self.starts, self.ends, self.base)
        return self._mend(parts.values(), parts.irregular)

    def _split(self, separator: NDArray[np.bool_]) -> None:
        separator[0] = True
        edges = np.flatnonzero(separator[1:] != separator[:-1])
        edges += 1
        self.starts, self.ends = edges[::2].copy(), edges[1::2].copy()

    def _values_with_exponents(
        self, space: NDArray[np.bool_], exponent: NDArray[np.bool_]
    ) -> Floats:
        """Read mantissas and exponents as numbers of their own, then join them."""
        self._split(space | exponent)
        powers = np.flatnonzero(exponent[self.starts - 1])
        if not self._join_mantissas(powers, int(np.count_nonzero(exponent))):
            self._split(space)  # an "e" that belongs to no number: find the culprit one by one
            return self._read_singly()
        parts = _read_parts(self.words, self.bytes, self.starts, self.ends, self.base)
        values, irregular = parts.values(), parts.irregular
        mantissas = powers - 1
        down = parts.decimals[mantissas].astype(np.intp)
        down -= np.clip(values[powers], -99, 99).astype(np.intp)
        values[mantissas] = parts.scaled(mantissas, down)
        irregular[mantissas] |= irregular[powers] | (parts.dots[powers] > 0) | (abs(down) > 22)
        self.ends[mantissas] = self.ends[powers]
        keep = np.ones(len(values), bool)
        keep[powers] = False
        if irregular.any():
            self.ends, irregular = self.ends[keep], irregular[keep]
        else:
            irregular = irregular[:0]
        self.starts = self.starts[keep]
        return self._mend(values[keep], irregular)

    def _join_mantissas(self, powers: Index, exponents: int) -> bool:
        """Whether each "e" stands between a mantissa and its power."""
        if len(powers) != exponents or powers[0] == 0 or (np.diff(powers) < 2).any():
            return False
        return bool((self.ends[powers - 1] == self.starts[powers] - 1).all())

    def _mend(self, values: Floats, irregular: NDArray[np.bool_]) -> Floats:
        """The values, those that do not fit the quick way read one by one."""
        for token in np.flatnonzero(irregular):
            values[token] = self._read_one(int(token))
        return values

    def _read_singly(self) -> Floats:
        return np.array([self._read_one(token) for token in range(len(self.starts))])

    def _read_one(self, token: int) -> float:
        start, end = self.base + int(self.starts[token]), self.base + int(self.ends[token])
        text = self.data[start:end]
        try:
            if b"_" not in text:
                return float(text)
        except ValueError:
            if b"#" in text:  # what Microsoft's C library prints: 1.#QNAN, -1.#IND, 1.#INF
                return float("nan")
        raise BadNumberError(text, token, start)


@dataclass(frozen=True)
class _Parts:
    """Tokens taken apart: sign, digits as a whole number, how many of them are decimals."""

    negative: NDArray[np.bool_]
    digits: Words
    decimals: Bytes
    dots: Bytes
    irregular: NDArray[np.bool_]

    def values(self) -> Floats:
        """Digits over a power of ten that has the sign."""
        divisor = _SIGNED_POWERS[self.decimals + _NEGATIVE * self.negative]
        return self.digits.astype(np.float64) / divisor

    def scaled(self, tokens: Index, down: Index) -> Floats:
        """Some tokens' digits / 10^down, right where |down| ≤ 22."""
        magnitude = self.digits[tokens].astype(np.float64)
        magnitude *= _POWERS[np.clip(-down, 0, 22)]
        magnitude /= _POWERS[np.clip(down, 0, 22)]
        return np.where(self.negative[tokens], -magnitude, magnitude)


def _read_parts(words: Words, text: Bytes, starts: Index, ends: Index, base: int) -> _Parts:
    first = text[starts]
    negative = first == ord("-")
    length = ends - starts
    length -= negative | (first == ord("+"))
    low, decimals, dots, bad = _squeeze(words[ends + (base - 8)], length)
    digits = _eight_digits(low)
    bad |= length <= dots
    long = np.flatnonzero(length > 8)
    if len(long):
        high, more, high_dots, high_bad = _squeeze(
            words[ends[long] + (base - 16)], length[long] - 8
        )
        digits[long] += _eight_digits(high) * _HIGH_PLACES[dots[long]]
        # A second dot makes a token bad, and would count more decimals than there are.
        decimals[long] = np.minimum(decimals[long] + high_dots * (8 + more), 15)
        bad[long] |= high_bad | (dots[long] + high_dots > 1) | (length[long] > 16)
        bad[long] |= digits[long] > _LARGEST_EXACT
        dots[long] |= high_dots
    return _Parts(negative, digits, decimals, dots, bad)


def _squeeze(word: Words, length: Index) -> tuple[Words, Bytes, Bytes, NDArray[np.bool_]]:
    """Words whose last ``length`` characters count: digits with the dot squeezed out.

    Works in place wherever it can: fresh memory costs more than the arithmetic.

    Returns:
        Eight digit values a word; how many digits follow the dot; 1 where there is a dot; where
        a character is neither digit nor dot.
    """
    word ^= _ZEROS
    word &= _KEEP_LAST[np.minimum(length, 8)]
    unit = word & _DOT_BIT
    unit &= np.negative(unit)
    unit >>= _4  # 1 at the first dot's byte
    word ^= unit * _DOT  # a dot becomes 0
    dots = np.bitwise_count(unit)
    bad = unit * _255
    bad &= word
    unit -= dots  # all bits before the dot, none without one
    before = word & unit
    before *= _255
    word += before  # moves what stands before the dot onto it
    before = word + _OVER_NINE
    before |= word
    before &= _HIGH
    bad |= before
    return word, 7 * dots - (np.bitwise_count(unit) >> 3), dots, bad != 0


def _eight_digits(word: Words) -> Words:
    """The number whose decimal digits are a word's bytes, the first lowest; in place."""
    word *= _PAIRS
    word >>= _8
    word &= _PAIR_MASK
    word *= _FOURS
    word >>= _16
    word &= _FOUR_MASK
    word *= _EIGHTS
    word >>= _32
    return word
