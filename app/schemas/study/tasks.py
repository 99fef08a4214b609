"""What is asked about moving figures: one model a kind of trial.

What an answer to each kind holds (`answers` of a response; figures are counted from 0 as they stand
on the page, so that no address or answer gives a clip's name away):

- `semantic_differential`: scale id to step, 0 in the middle, negative to the left;
- `unipolar`: item id to step, 0 … n−1; `likert`: item id to step, 1 … n;
- `analogue`: scale id to position, 0 (left) … 100 (right);
- `choose`, `ab`: `choice`, the chosen figure, or −1 for none or no difference;
- `abx`: `choice`, 0 or 1, the figure that X is taken for;
- `parallel`: each figure to its position, 0 … 100; `ranking`: each figure to its rank, 1 first;
- `free_text`: `text`;
- `match`: slider id to where it stood at last, 0 … 1 (of bare weights: `e0`, `e1`, … as the space
  has its examples), and `seconds`, how long it took. The server adds `interface`, `seen` (0 for a
  guess), `distance` (metres), `solved` (1 if the distance was below the threshold in time) and the
  `engine` that measured it.
"""

from __future__ import annotations

from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from app.schemas.study.stimuli import Interface, SpaceRef, Stimulus
from app.schemas.study.words import Name, Part, Words


class Scale(Part):
    """A bipolar axis. `left_more` and `right_more` are its poles' comparatives: sadder, happier."""

    id: Name
    left: Words
    right: Words
    left_more: Words | None = None
    right_more: Words | None = None


class Item(Part):
    """One line to be rated: a quality, or a statement to agree with."""

    id: Name
    label: Words


class Comment(Part):
    """The box for free text below a trial."""

    label: Words
    placeholder: Words | None = None


class Asking(Part):
    """What every kind of trial has: a question, a hint below it, perhaps a comment box."""

    question: Words
    hint: Words | None = None
    comment: Comment | None = None


class SemanticDifferential(Asking):
    """One figure between opposite words, perhaps beside a reference figure.

    Attributes:
        steps: words over the steps from the left pole to the right one; their number is odd.
        preselected: the middle holds until a scale is touched; else every scale must be answered.
        reference: a clip of the library shown in red beside the judged one in green.
        shuffle_scales: the scales stand in another order for each participant, the same throughout.
    """

    kind: Literal["semantic_differential"] = "semantic_differential"
    scales: Annotated[tuple[Scale, ...], Field(min_length=1, max_length=200)]
    steps: Annotated[tuple[Words, ...], Field(min_length=3, max_length=11)]
    preselected: bool = True
    reference: Annotated[str, Field(min_length=1, max_length=200)] | None = None
    shuffle_scales: bool = False

    @model_validator(mode="after")
    def _has_a_middle(self) -> Self:
        if len(self.steps) % 2 == 0:
            raise ValueError("steps: give an odd number, so that there is a middle")
        return self

    @property
    def reach(self) -> int:
        """The value of the outermost step; answers lie in -reach ... reach."""
        return len(self.steps) // 2


class Unipolar(Asking):
    """One figure, several qualities from not at all to very: steps 0 … n−1."""

    kind: Literal["unipolar"] = "unipolar"
    items: Annotated[tuple[Item, ...], Field(min_length=1, max_length=200)]
    steps: Annotated[tuple[Words, ...], Field(min_length=2, max_length=11)]


class Likert(Asking):
    """One figure, several statements to agree with: steps 1 … n."""

    kind: Literal["likert"] = "likert"
    items: Annotated[tuple[Item, ...], Field(min_length=1, max_length=200)]
    steps: Annotated[tuple[Words, ...], Field(min_length=2, max_length=11)]


class Analogue(Asking):
    """One figure, sliders without steps; no answer until touched."""

    kind: Literal["analogue"] = "analogue"
    scales: Annotated[tuple[Scale, ...], Field(min_length=1, max_length=50)]


class Choose(Asking):
    """Several figures in step; one is chosen."""

    kind: Literal["choose"] = "choose"
    allow_none: bool = False


class AB(Asking):
    """Two figures; one is chosen, or no difference where that is allowed."""

    kind: Literal["ab"] = "ab"
    allow_same: bool = False


class ABX(Asking):
    """Two figures and a third that equals one of them; which one?"""

    kind: Literal["abx"] = "abx"


class Parallel(Asking):
    """Several figures on one page, a slider below each."""

    kind: Literal["parallel"] = "parallel"
    low: Words
    high: Words


class Ranking(Asking):
    """Several figures put into order."""

    kind: Literal["ranking"] = "ranking"
    first: Words
    last: Words


class FreeText(Asking):
    """One figure described in one's own words."""

    kind: Literal["free_text"] = "free_text"
    required: bool = True


class Match(Asking):
    """A target in green is made again by a figure in blue that sliders move.

    Of each target the sliders are first set unseen, once with every interface; then it is matched
    with each, seen, against the clock (Oshita et al., section 6.1). The stimuli are the targets.

    Attributes:
        space: the authoring space: its name (of which the newest version is taken), or its id.
        interfaces: with what the motion is made; their order is balanced over participants.
        guess_first: whether there are guesses unseen.
        seconds: after so long a target is given up.
        threshold: metres; below this distance the two motions match.
        practice_targets: matched first, with each interface, and not analysed.
        examples: whether all example motions of the space can be looked at beside the task.
    """

    kind: Literal["match"] = "match"
    space: SpaceRef
    interfaces: Annotated[tuple[Interface, ...], Field(min_length=1, max_length=3)] = (
        "weights",
        "adjectives",
        "features",
    )
    guess_first: bool = True
    seconds: Annotated[int, Field(ge=5, le=3600)] = 300
    threshold: Annotated[float, Field(gt=0, le=1)] = 0.06
    practice_targets: Annotated[tuple[Stimulus, ...], Field(max_length=20)] = ()
    examples: bool = True

    @model_validator(mode="after")
    def _has_each_interface_once(self) -> Self:
        if len(set(self.interfaces)) < len(self.interfaces):
            raise ValueError("interfaces: one is there twice")
        return self


Task = Annotated[
    SemanticDifferential
    | Unipolar
    | Likert
    | Analogue
    | Choose
    | AB
    | ABX
    | Parallel
    | Ranking
    | FreeText
    | Match,
    Field(discriminator="kind"),
]
# Those that show one judged figure a trial; the others show several.
OF_ONE = ("semantic_differential", "unipolar", "likert", "analogue", "free_text", "match")
OF_TWO = ("ab", "abx")
