"""What can go wrong, told so that a person knows the place and the mend.

Services raise these; ``app.error_handling`` turns them into JSON or a page.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any


class MannerError(Exception):
    """Something the person at the other end should know about.

    Attributes:
        code: the fault's name for programs, in snake case.
        message: what is wrong, one or two sentences.
        where: the place: a line, a field, the missing trials.
        mend: what to do about it.
        extra: more members of the JSON error, such as ``offer`` or ``stored``.
    """

    default_code = "error"

    def __init__(
        self,
        message: str,
        *,
        code: str | None = None,
        where: Mapping[str, Any] | None = None,
        mend: str | None = None,
        extra: Mapping[str, Any] | None = None,
    ) -> None:
        super().__init__(message)
        self.code = code or self.default_code
        self.message = message
        self.where = where
        self.mend = mend
        self.extra = dict(extra or {})


class InvalidError(MannerError):
    """The request makes no sense as it stands."""

    default_code = "invalid"


class SignInNeededError(MannerError):
    """Only a signed-in researcher may do this."""

    default_code = "sign_in_needed"


class ForbiddenError(MannerError):
    """The request may not be done from where it came."""

    default_code = "forbidden"


class NotFoundError(MannerError):
    """There is nothing at this address."""

    default_code = "not_found"


class ConflictError(MannerError):
    """The request contradicts what is stored."""

    default_code = "conflict"


class TooLargeError(MannerError):
    """More bytes than the server takes."""

    default_code = "too_large"


class TooManyError(MannerError):
    """More attempts than the server takes in a while."""

    default_code = "too_many_attempts"


class BusyError(MannerError):
    """The server cannot do this now, but may a little later."""

    default_code = "busy"
