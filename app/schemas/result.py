"""What all results have in common."""

from pydantic import BaseModel, ConfigDict


class Result(BaseModel):
    """A part of the results."""

    model_config = ConfigDict(frozen=True)
