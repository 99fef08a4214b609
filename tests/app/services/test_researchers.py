"""Passwords are checked within bounded memory."""

from __future__ import annotations

import threading
import time
from concurrent.futures import ThreadPoolExecutor

import pytest
from argon2 import PasswordHasher
from argon2.exceptions import VerifyMismatchError

from app.errors import InvalidError
from app.persistence.engine import Database
from app.services import researchers


class Counting(PasswordHasher):
    """Counts how many verifications are under way at once."""

    def __init__(self) -> None:
        super().__init__(time_cost=1, memory_cost=8, parallelism=1)
        self.lock, self.under_way, self.most = threading.Lock(), 0, 0

    def verify(self, *_: object) -> bool:
        with self.lock:
            self.under_way += 1
            self.most = max(self.most, self.under_way)
        time.sleep(0.01)
        with self.lock:
            self.under_way -= 1
        raise VerifyMismatchError


def test_of_many_sign_ins_at_once_only_a_few_hash(
    database: Database, monkeypatch: pytest.MonkeyPatch
) -> None:
    hasher = Counting()
    monkeypatch.setattr(researchers, "_hasher", hasher)

    def attempt(_: int) -> None:
        with database.reading() as db, pytest.raises(InvalidError):
            researchers.sign_in(db, "nobody@example.org", "guess")

    with ThreadPoolExecutor(12) as pool:
        list(pool.map(attempt, range(24)))
    assert 1 < hasher.most <= 4
