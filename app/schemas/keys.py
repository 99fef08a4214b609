"""API keys as their pages show them."""

from __future__ import annotations

from datetime import datetime
from typing import Literal

from pydantic import BaseModel, ConfigDict

Scope = Literal["read", "write"]


class KeyView(BaseModel):
    """What is known of a key. The key itself is not kept, only its last characters (`hint`)."""

    model_config = ConfigDict(from_attributes=True)

    id: int
    name: str
    hint: str
    scope: Scope
    created_at: datetime
    last_used_at: datetime | None
    revoked_at: datetime | None


class NewKey(BaseModel):
    """A key that was just made; `secret` is told this once."""

    secret: str
    key: KeyView
