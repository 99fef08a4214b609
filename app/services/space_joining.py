"""Clips that nobody judged join a space by what their motion predicts. No database.

Done in a process of ``app.workers``, as ``space_making``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from app.errors import InvalidError
from app.schemas.spaces import (
    Parameter,
    PredictedParameter,
    Prediction,
    Primary,
    Sliders,
    SpaceDefinition,
)
from app.services.space_clips import Moments, Source, read, told
from app.services.space_making import define
from app.services.space_sliders import as_values
from app.statistics.prediction import Prediction as Learnt
from app.statistics.prediction import fit
from motion.features import FEATURES, features
from motion.storage import clip_from_bytes

Array = NDArray[np.float64]

FEWEST = 3  # rated examples, from which anything can be learnt at all
TOO_FEW = "Not predicted: too few clips of this space were rated."


def renew(
    before: SpaceDefinition, sources: Sequence[Source], keytimes: Mapping[str, Moments]
) -> SpaceDefinition:
    """The next version of a space.

    Args:
        before: the version before.
        sources: its examples in their order, then those that join.
        keytimes: clip id to its events; those of other clips are found.

    Raises:
        InvalidError: the clips cannot be blended, or no pair of adjectives can be predicted.
    """
    joining = sources[len(before.examples) :]
    read(sources)  # tells of another skeleton before anything is predicted for it
    adjectives, notes = before.adjectives, [before.origin.note]
    if joining and adjectives:
        adjectives, note = _extended(before, adjectives, joining)
        notes.append(note)
    predicted = [example.clip for example in before.examples if example.predicted]
    predicted += [source.id for source in joining if before.adjectives]
    return define(
        before.title,
        sources,
        keytimes,
        adjectives,
        before.origin.model_copy(
            update={"before": before.content_hash, "note": " ".join(filter(None, notes))}
        ),
        predicted,
    )


def predict(space: SpaceDefinition, first: Source, candidate: Source) -> Prediction:
    """The impressions that a clip would have, and whether it can join.

    Args:
        space: its definition.
        first: its first example, which tells what can be blended with the others.
        candidate: the clip.
    """
    with told():
        seen = features(clip_from_bytes(candidate.content))[None]
    learnt = _learnt(space, space.adjectives) if space.adjectives else None
    rows = _rows(space.adjectives, learnt, seen) if space.adjectives else []
    kept = sum(not row.refused for row in rows)
    fault = _fault(space, first, candidate)
    if fault is None and rows and not kept:
        fault = "None of this space's pairs can be predicted from motion, so the clip cannot join."
    return Prediction(
        clip=candidate.id,
        parameters=rows,
        level=learnt.level if learnt else None,
        can_join=fault is None,
        sentence=fault or _sentence(rows, kept),
    )


def _extended(
    before: SpaceDefinition, adjectives: Sliders, joining: Sequence[Source]
) -> tuple[Sliders, str]:
    """The sliders with the predicted values of joining clips, and what there is to say of them.

    Raises:
        InvalidError: no pair can be predicted.
    """
    learnt = _learnt(before, adjectives)
    refused = np.ones(len(adjectives.parameters), bool) if learnt is None else learnt.refused
    if learnt is None or refused.all():
        raise InvalidError(
            "None of this space's pairs of adjectives can be predicted from motion.",
            code="nothing_predictable",
            where={"field": "join"},
            mend="Have the clips judged in a study, and make a space of its answers.",
        )
    with told():
        seen = np.stack([features(clip_from_bytes(source.content)) for source in joining])
    values, _, _ = learnt.predict(seen)
    parameters = tuple(
        one.model_copy(update={"values": (*one.values, *as_values(values[:, place]))})
        for place, one in enumerate(adjectives.parameters)
        if not refused[place]
    )
    note = f"Predicted from motion: {_listed([source.name for source in joining])}."
    if refused.any():
        gone = [
            f"{adjectives.parameters[n].left}–{adjectives.parameters[n].right}"
            for n in np.flatnonzero(refused)
        ]
        note += f" Left out, because they cannot be predicted: {_listed(gone)}."
    return Sliders(primary=_means(adjectives, parameters), parameters=parameters), note


def _means(before: Sliders, parameters: Sequence[Parameter]) -> tuple[Primary, ...]:
    """The primary sliders of those of their members that are left; one without any is gone."""
    left = {one.id: one.values for one in parameters}
    found = []
    for one in before.primary:
        members = tuple(name for name in one.members if name in left)
        if members:
            values = as_values(np.mean([left[name] for name in members], axis=0))
            found.append(one.model_copy(update={"members": members, "values": values}))
    return tuple(found)


def _learnt(space: SpaceDefinition, adjectives: Sliders) -> Learnt | None:
    """What the rated examples tell; None where they are too few."""
    rated = [not example.predicted for example in space.examples]
    if sum(rated) < FEWEST:
        return None
    seen, said = _measured(space.features), _columns(adjectives.parameters)
    return fit(seen[rated], said[rated], least=np.array([one.least for one in FEATURES]))


def _measured(sliders: Sliders) -> Array:
    """The examples' features (N, 51) in their units."""
    low, high = (
        np.array([getattr(one, end) for one in sliders.parameters], float)
        for end in ("lowest", "highest")
    )
    return np.asarray(low + _columns(sliders.parameters) * (high - low))


def _columns(parameters: Sequence[Parameter]) -> Array:
    return np.array([one.values for one in parameters]).T


def _rows(adjectives: Sliders, learnt: Learnt | None, seen: Array) -> list[PredictedParameter]:
    """Every pair with what is predicted for a clip with these features (1, 51)."""
    if learnt is None:
        return [_row(one, {"refused": True, "sentence": TOO_FEW}) for one in adjectives.parameters]
    values, low, high = (column[0] for column in learnt.predict(seen))
    found = []
    for place, one in enumerate(adjectives.parameters):
        refused = bool(learnt.refused[place])
        known = {
            "refused": refused,
            "error": float(learnt.error[place]),
            "error_of_mean": float(learnt.mean_error[place]),
            "sentence": learnt.notes[place],
        }
        if not refused:
            ends = {"value": values, "low": low, "high": high}
            known |= {name: float(column[place]) for name, column in ends.items()}
        found.append(_row(one, known))
    return found


def _row(pair: Parameter, known: Mapping[str, object]) -> PredictedParameter:
    empty = {"value": None, "low": None, "high": None, "error": None, "error_of_mean": None}
    words = {"id": pair.id, "left": pair.left, "right": pair.right}
    return PredictedParameter.model_validate({**empty, **words, **known})


def _fault(space: SpaceDefinition, first: Source, candidate: Source) -> str | None:
    """Why a clip cannot be an example of a space."""
    if any(example.clip == candidate.id for example in space.examples):
        return "This clip is an example of the space already."
    try:
        read([first, candidate])
    except InvalidError as error:
        return f"{error.message} {error.mend}"
    return None


def _sentence(rows: Sequence[PredictedParameter], kept: int) -> str:
    if not rows:
        return "Nobody judged this space's clips; the clip can join by its motion features."
    others = " The next version has no sliders of the others." if kept < len(rows) else ""
    return f"{kept} of {len(rows)} pairs can be predicted from the clip’s motion.{others}"


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names)
