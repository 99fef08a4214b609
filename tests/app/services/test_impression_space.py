"""What an analysis becomes as a space: its sliders' names."""

from __future__ import annotations

import numpy as np
import pytest

from app.schemas.impressions import AnalysisChoices
from app.schemas.study import Scale, Words
from app.services.impression_names import Called
from app.services.impression_solution import solve
from app.services.impression_space import sliders
from app.services.matching import BESIDE_SLIDERS, as_sent
from app.statistics.quantification import quantify
from tests.support import rated_pairs


def ids(*titles: str) -> list[str]:
    """The primary sliders' ids of clusters with these titles."""
    groups = [2] * len(titles)
    ratings = rated_pairs.latent(8, 10, groups)
    scales = [
        Scale(id=f"pair_{n}", left=f"less {n}", right=f"more {n}") for n in range(sum(groups))
    ]
    choices = AnalysisChoices(clusters=len(titles))
    solution = solve(quantify(ratings), [one.id for one in scales], choices, 2)
    assert solution is not None
    called = [Called(Words(title), named=True) for title in titles]
    made = sliders(solution, scales, called)
    assert np.shape([one.values for one in made.primary]) == (len(titles), 10)
    return [one.id for one in made.primary]


def test_a_slider_is_called_after_its_cluster() -> None:
    assert ids("Quickness", "Size of steps") == ["quickness", "size_of_steps"]


def test_clusters_of_no_letters_or_of_a_pairs_or_each_others_name_get_names_of_their_own() -> None:
    assert ids("素早さ", "pair_0", "Élan", "elan!") == ["cluster_1", "pair_0_2", "elan", "elan_4"]


@pytest.mark.parametrize("name", BESIDE_SLIDERS)
def test_no_slider_takes_the_place_of_what_is_measured(name: str) -> None:
    (one,) = set(ids(name.capitalize(), "Other")) - {"other"}
    stored = {one: 0.25} | {"interface": "adjectives", "seen": 1, "distance": 0.1, "solved": 0}
    assert as_sent({**stored, "seconds": 3.0}) == {one: 0.25, "seconds": 3.0}
