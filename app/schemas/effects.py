"""The effects file: what simulated participants feel, by which a study can be rehearsed."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field

Size = Annotated[float, Field(ge=-100, le=100, allow_inf_nan=False)]
Spread = Annotated[float, Field(ge=0, le=100, allow_inf_nan=False)]


class Effects(BaseModel):
    """Latent effects, all in steps; a step of a slider is ten of its hundred points.

    Attributes:
        noise: standard deviation of an answer about what its rater means.
        rater_sd: standard deviation of the raters' biases, one a scale.
        effects: a value's name, as its column in the long table is called or as it is in the study
            (a scale, an item, `rating`, `rank`, `choice`), to what moves it: a clip's name, a style
            or a body, and by how much. What fits a clip adds up. Scales start in their middle.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)

    noise: Spread = 0.8
    rater_sd: Spread = 0.25
    effects: dict[str, dict[str, Size]] = {}
