"""How participants come and go: personal links, Prolific, SONA, MTurk.

Whoever comes with an identity gets one session: its secret is derived from the identity, so that
the same link leads back to the same place.
"""

from __future__ import annotations

import hmac
from base64 import urlsafe_b64encode
from collections.abc import Mapping
from dataclasses import dataclass
from hashlib import sha256
from typing import Literal
from urllib.parse import quote, urlencode

from itsdangerous import BadSignature, URLSafeSerializer

from app.errors import InvalidError
from app.schemas.study import Outcome, Running

Source = Literal["open", "personal", "prolific", "sona", "mturk"]
LONGEST = 200  # characters of a parameter of a recruiting service
PROLIFIC = ("PROLIFIC_PID", "STUDY_ID", "SESSION_ID")
MTURK = ("workerId", "assignmentId", "hitId")
PARAMETERS = ("invite", "id", *PROLIFIC, *MTURK)
MTURK_PREVIEW = "ASSIGNMENT_ID_NOT_AVAILABLE"


@dataclass(frozen=True)
class Arrival:
    """Who comes, from where, with what.

    Attributes:
        identity: of the person within the source; None on an open link.
        parameters: what the service sent, needed to give credit.
        previewing: an MTurk worker who only looks at the task.
    """

    source: Source = "open"
    identity: str | None = None
    parameters: dict[str, str] | None = None
    previewing: bool = False


@dataclass(frozen=True)
class Return:
    """Where a participant goes afterwards: a service's address, a code to hand in, or both."""

    source: Source
    code: str | None
    url: str | None


def arrival(given: Mapping[str, str], running: Running, slug: str, secret: str) -> Arrival:
    """Who comes with these parameters of the address.

    Raises:
        InvalidError: an invitation that is not from this study.
    """
    cleaned = {name: given.get(name, "").replace("\0", "")[:LONGEST] for name in PARAMETERS}
    known = {name: text for name, text in cleaned.items() if text}
    if "invite" in known:
        label = _invited(given["invite"], slug, secret)
        return Arrival("personal", label, {"invitation": label})
    if running.prolific and "PROLIFIC_PID" in known:
        return Arrival("prolific", known["PROLIFIC_PID"], _only(known, PROLIFIC))
    if running.sona and "id" in known:
        return Arrival("sona", known["id"], {"id": known["id"]})
    if running.mturk and "assignmentId" in known:
        looking = known["assignmentId"] == MTURK_PREVIEW
        worker = known.get("workerId")
        return Arrival("mturk", worker, _only(known, MTURK), previewing=looking or worker is None)
    return Arrival()


def invitation(secret: str, slug: str, label: str) -> str:
    """The signed word of a personal link: `/studies/{slug}?invite={word}`."""
    return _signer(secret).dumps([slug, label])


def personal_token(secret: str, slug: str, coming: Arrival) -> str | None:
    """The secret of an identified participant's session, always the same; None on an open link."""
    if coming.identity is None:
        return None
    message = "\n".join((slug, coming.source, coming.identity)).encode("utf-8", "replace")
    digest = hmac.digest(secret.encode() + b"participant", message, "sha256")
    return urlsafe_b64encode(digest[:24]).decode()


def given_back(
    running: Running, source: Source, outcome: Outcome, external: Mapping[str, str], own_code: str
) -> Return:
    """Where a participant goes after an outcome.

    Args:
        running: the study's settings.
        source: from where the participant came.
        outcome: how it ended.
        external: the parameters that the service sent.
        own_code: the session's own code, for whom no service gives another.
    """
    if source == "prolific" and running.prolific:
        code = running.prolific.code(outcome)
        query = urlencode({"cc": code}) if code else ""
        home = "https://app.prolific.com/submissions/complete"
        return Return(source, code, f"{home}?{query}" if code else None)
    if source == "sona" and running.sona:
        address = running.sona.credit_url.replace("{id}", quote(external.get("id", ""), safe=""))
        return Return(source, None, address if outcome == "complete" else None)
    return Return(source, own_code if outcome == "complete" else None, None)


def _invited(word: str, slug: str, secret: str) -> str:
    try:
        study, label = _signer(secret).loads(word)
    except (BadSignature, ValueError, TypeError):
        study = label = None
    if study != slug or not isinstance(label, str):
        raise InvalidError(
            "This personal link is not complete, or belongs to another study.",
            code="invitation_invalid",
            mend="Open the link exactly as you got it.",
        )
    return label


def _signer(secret: str) -> URLSafeSerializer:
    return URLSafeSerializer(secret, salt="invitation", signer_kwargs={"digest_method": sha256})


def _only(known: Mapping[str, str], names: tuple[str, ...]) -> dict[str, str]:
    return {name: known[name] for name in names if name in known}
