"""What people saw in a study's clips, by pairs of adjectives: kept pairs, clusters, stability."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field

from app.schemas.results import PartName, SessionKind
from app.schemas.study import Words
from app.schemas.study.words import ContentHash, Name, Title

LEAST_PEAK, MOST_SPREAD, CLUSTERS = 1.0, 0.85, 4  # Oshita et al., eq. 3 and section 3.6


class AnalysisChoices(BaseModel):
    """What a researcher chose in the analysis of a part.

    Attributes:
        least_peak, most_spread: a pair is dropped if its μ* is below or its σ̄ above. The defaults
            are for answers from −2 to 2 and grow with the reach of others.
        clusters: into how many Ward's tree is cut.
        names: of the clusters, by the id of the pair that stands first in each.
        moved: pair to a pair that the tree put into the cluster that it was moved into by hand.
    """

    model_config = ConfigDict(
        extra="forbid",
        json_schema_extra={
            "example": {
                "least_peak": 1.0,
                "most_spread": 0.85,
                "clusters": 4,
                "names": {"small_large": "size"},
                "moved": {"tight_free": "calm_excited"},
            }
        },
    )

    least_peak: Annotated[float, Field(ge=0, le=10)] = LEAST_PEAK
    most_spread: Annotated[float, Field(ge=0, le=10)] = MOST_SPREAD
    clusters: Annotated[int, Field(ge=1, le=50)] = CLUSTERS
    names: dict[Name, Title] = {}
    moved: dict[Name, Name] = {}


class Pair(BaseModel):
    """A pair of adjectives.

    Attributes:
        peak: μ*, the greatest mean of any clip, without its sign.
        spread: σ̄, the mean over clips of the raters' sample standard deviation; None where no clip
            has two raters.
        dropped: why it is left out, in a sentence; None for a kept one.
        cluster: index of its cluster; None for a dropped one.
    """

    id: Name
    left: Words
    right: Words
    peak: float | None
    spread: float | None
    dropped: str | None
    cluster: int | None
    moved: bool


class Cluster(BaseModel):
    """Pairs that go together.

    Attributes:
        key: the pair that stands first in it, by which it is known.
        members: pair ids in the order of the tree's leaves, those moved into it last.
        values: A′, the mean of its pairs for each clip, 0 … 1; None where a pair has no answer.
    """

    key: Name
    title: Title
    named: bool
    members: list[Name]
    values: list[float | None]


class Merge(BaseModel):
    """Two branches of the tree become one. Leaves are numbered from 0, then merges.

    Attributes:
        height: √(2ΔE), as SciPy and R (`ward.D2`) give it; increase: ΔE of eq. 4.
    """

    left: int
    right: int
    height: float
    increase: float
    size: int


class Rated(BaseModel):
    """A clip of the study."""

    clip: ContentHash
    name: str
    label: str
    raters: int


class Impressions(BaseModel):
    """The whole analysis of a part.

    Attributes:
        leaves: the kept pairs in the order of the tree; merges refer to them by place in `kept`.
        kept: ids of the kept pairs, in the order of the part.
        matrix: A, clips × kept pairs (in `leaves` order), 0 … 1; None where nobody rated.
        means, spreads: clips × all pairs in the part's order; None where nobody rated.
        reach: the outermost step; answers lie in −reach … reach.
        sentence: what came out, in words.
        notes: what of the choices or the answers could not be taken in, a sentence each.
        problem: why there are no clusters yet; None if there are.
    """

    slug: str
    title: str
    kind: SessionKind
    part: PartName
    parts: list[PartName]
    reach: int
    participants: int
    simulated: int
    choices: AnalysisChoices
    saved_at: datetime | None
    clips: list[Rated]
    pairs: list[Pair]
    kept: list[Name]
    leaves: list[Name]
    merges: list[Merge]
    matrix: list[list[float | None]]
    means: list[list[float | None]]
    spreads: list[list[float | None]]
    clusters: list[Cluster]
    sentence: str
    notes: list[str]
    problem: str | None
    may_edit: bool


class PairStability(BaseModel):
    """How often a pair stays when participants are drawn anew."""

    id: Name
    kept: float


class ClusterStability(BaseModel):
    """How well a cluster is found again: the mean of its best Jaccard overlap (Hennig 2007)."""

    key: Name
    title: Title
    overlap: float


class Agreement(BaseModel):
    """Adjusted Rand index: the mean of the samples, and where the middle 95 % of them lie."""

    mean: float
    low: float
    high: float


class ByParticipants(BaseModel):
    """How like the solution of all one from so many participants is.

    Attributes:
        whole, shared: as in `Stability`.
        kept_alike: mean share of pairs that are kept, or left out, as by all participants.
    """

    participants: int
    whole: Agreement
    shared: Agreement | None
    kept_alike: float


class Enough(BaseModel):
    """How many participants would do.

    Attributes:
        index: what the mean adjusted Rand index has to reach.
        whole: the least number tried from which on it does for the whole solution, shared: for how
            kept pairs are grouped; None if even `most`, the greatest number tried, does not.
    """

    index: float
    most: int
    whole: int | None
    shared: int | None
    sentence: str


class Stability(BaseModel):
    """Bootstrap over participants.

    Attributes:
        clusters: as the tree is cut, moves by hand aside.
        whole: agreement with the solution of all participants, over all pairs that were asked;
            those left out are a group of their own.
        shared: the same over the pairs that both keep; None where no sample keeps enough.
        by_participants: the same for other numbers of participants.
    """

    samples: int
    seed: int
    participants: int
    pairs: list[PairStability]
    clusters: list[ClusterStability]
    whole: Agreement
    shared: Agreement | None
    by_participants: list[ByParticipants]
    enough: Enough
    sentence: str


class MovedPair(BaseModel):
    """A pair that two solutions put into different clusters, or that only one of them keeps."""

    id: Name
    left: Words
    right: Words
    here: Title | None
    there: Title | None


class ComparedPair(BaseModel):
    """A pair in a cluster that is compared.

    Attributes:
        differs: whether it is in another cluster elsewhere, or kept by one study only.
        turned: whether its study asks for it the other way round; the words are already exchanged.
    """

    id: Name
    left: Words
    right: Words
    differs: bool
    turned: bool


class ComparedCluster(BaseModel):
    """A cluster beside those of another study.

    Attributes:
        like: index of the other study's cluster that it is matched with; None for none.
    """

    key: Name
    title: Title
    like: int | None
    members: list[ComparedPair]


class Comparison(BaseModel):
    """Two studies' solutions side by side.

    Attributes:
        shared: how many pairs both keep; rand: the adjusted Rand index over them.
        turned: how many pairs the other study asks for the other way round; its answers to them
            are turned before they are grouped.
    """

    here: str
    there: str
    shared: int
    rand: float | None
    turned: int
    here_clusters: list[ComparedCluster]
    there_clusters: list[ComparedCluster]
    moved: list[MovedPair]
    sentence: str


class Comparable(BaseModel):
    """A part of a study that asks for some of the same pairs and has answers."""

    slug: str
    title: str
    part: Name


class ComparableList(BaseModel):
    """What a part's analysis can be set beside."""

    studies: list[Comparable]


class Freeze(BaseModel):
    """Make an authoring space of the analysis as it is saved."""

    model_config = ConfigDict(
        extra="forbid", json_schema_extra={"example": {"name": "Walks of set A"}}
    )

    name: Title
