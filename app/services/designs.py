"""Designs over participants: balanced Latin squares and subsets with equal exposure.

A design is a function of a row number; participant after participant takes the next row. All draws
are raw 64-bit numbers of PCG64: NumPy promises these to stay the same for a seed, on every platform
and in every version, which it does not for its shuffles.
"""

from __future__ import annotations

from hashlib import sha256
from math import gcd

import numpy as np
from numpy.random import PCG64, Generator


class Draws:
    """Shuffles from a seed, the same on every platform."""

    def __init__(self, seed: int) -> None:
        self._raw = Generator(PCG64(seed)).bit_generator

    def shuffle(self, number: int) -> list[int]:
        """The numbers 0 … number − 1 in an order in which each is as likely in each place."""
        if number == 0:
            return []
        return [int(index) for index in np.argsort(self._raw.random_raw(number), kind="stable")]

    def below(self, number: int) -> int:
        """One of 0 … number − 1; the bias of the remainder is below number / 2⁶⁴."""
        return int(self._raw.random_raw()) % number


def draws_of(*names: object) -> Draws:
    """Draws that belong to a thing with these names, a part of a study say, and to no other."""
    digest = sha256("/".join(map(str, names)).encode()).digest()
    return Draws(int.from_bytes(digest[:8], "big"))


def williams_rows(number: int) -> int:
    """After so many rows a Williams design is whole: n, or 2n where n is odd."""
    return number if number % 2 == 0 else 2 * number


def williams(number: int, row: int) -> list[int]:
    """A row of a Williams design: a Latin square balanced to first order.

    Each condition stands in each place equally often, and follows each other one equally often.
    Source: E. J. Williams, Experimental designs balanced for the estimation of residual effects of
    treatments, Australian Journal of Scientific Research A2 (1949), 149-168.
    """
    row %= williams_rows(number)
    first = [(place + 1) // 2 if place % 2 else (number - place // 2) % number
             for place in range(number)]  # fmt: skip
    order = [(condition + row) % number for condition in first]
    return order[::-1] if row >= number else order


def subset(number: int, size: int, row: int, *names: object) -> list[int]:
    """Which `size` of 0 … number − 1 a row shows; after each whole round all were shown alike.

    A round has number / gcd(number, size) rows, cut one after the other from a shuffle that is
    wrapped around; each round has another shuffle.
    """
    rows = number // gcd(number, size)
    order = draws_of(*names, "subset", row // rows).shuffle(number)
    start = (row % rows) * size
    return [order[(start + place) % number] for place in range(size)]
