"""Is every quality seen? Each pole's best clip against the other clips (Förger, figure 31)."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from app.schemas.results import Clip, PoleRow
from app.services import sentences
from app.services.measures import Measure
from app.services.result_axes import NEEDED
from app.services.versions import Pooled
from app.statistics.intervals import Samples
from app.statistics.poles import Against, BestClip, best_clip, chance_of_best
from app.statistics.tests import holm


def poles(
    asked: Pooled, clips: Sequence[Clip], ratings: Samples, against: Against, study_hash: str
) -> list[PoleRow]:
    """Two rows a scale, the left pole's first; ratings (participants, clips, scales)."""
    enough = len(ratings) >= NEEDED
    bodies = [clip.body for clip in clips]
    wanted = [
        (scale, pole, more, sign * ratings[:, :, index])
        for index, scale in enumerate(asked.measures)
        for pole, more, sign in (
            (scale.left, scale.left_more, -1),
            (scale.right, scale.right_more, 1),
        )
    ]
    found = [best_clip(toward, bodies, against) if enough else None for *_, toward in wanted]
    adjusted = holm([best.welch.p if best and best.welch else None for best in found])
    permuted = [
        _chance(toward.tobytes(), toward.shape, tuple(bodies), against, study_hash)
        if best
        else None
        for (*_, toward), best in zip(wanted, found, strict=True)
    ]
    rows = zip(wanted, found, adjusted, permuted, holm(permuted), strict=True)
    return [
        _pole_row(scale, pole, more, clips[best.clip], best, p_holm, against).model_copy(
            update={"p_permuted": chance, "p_permuted_holm": chance_holm}
        )
        if best
        else _empty_row(scale, pole)
        for (scale, pole, more, _), best, p_holm, chance, chance_holm in rows
    ]


@lru_cache(maxsize=256)
def _chance(
    toward: bytes, shape: tuple[int, int], bodies: tuple[str, ...], against: Against, study: str
) -> float | None:
    """The permutation test, drawn from the study's hash: the same answers give the same p.

    Remembered, for a page that is open asks for the same numbers again and again.
    """
    generator = np.random.default_rng(int(study[:16], 16))
    ratings = np.frombuffer(toward).reshape(shape)
    return chance_of_best(ratings, bodies, generator, against)


def _pole_row(
    scale: Measure, pole: str, more: str, clip: Clip,
    best: BestClip, p_holm: float | None, against: Against,
) -> PoleRow:  # fmt: skip
    test, effect, pair = best.welch, best.effect, best.paired
    sentence = None
    if test and effect and p_holm is not None:
        sentence = sentences.best_clip(
            label=clip.label, more=more, against=against, t=test.t, df=test.df, p_holm=p_holm,
            d=effect.d, low=effect.low, high=effect.high,
        )  # fmt: skip
    return _empty_row(scale, pole).model_copy(
        update={
            "clip": clip,
            "mean": best.mean,
            "others": best.rest_mean,
            "difference": best.mean - best.rest_mean,
            "p_holm": p_holm,
            "sentence": sentence,
            **({"t": test.t, "df": test.df, "p": test.p} if test else {}),
            **({"d": effect.d, "d_low": effect.low, "d_high": effect.high} if effect else {}),
            **({"paired_t": pair.t, "paired_df": pair.df, "paired_p": pair.p} if pair else {}),
        }
    )


def _empty_row(scale: Measure, pole: str) -> PoleRow:
    unknown = dict.fromkeys(PoleRow.model_fields)
    return PoleRow.model_validate({**unknown, "scale": scale.id, "pole": pole})
