"""``manner recover``: what is put into simulated raters is found again, and nothing else."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from app.cli import app
from app.services import recovery, recovery_report
from app.services.recovery import NOISES, PAPER_NOISE, PARTICIPANTS, SETS, Setting, point

DOCS = Path(__file__).parents[3] / "docs"
SEEDS = 12


@pytest.mark.parametrize("motion_set", SETS)
def test_at_low_noise_the_recovery_is_exact(motion_set):
    found = point(Setting(motion_set, NOISES[0]), SEEDS, 5)
    assert found.exact == SEEDS
    assert (found.kept.mean, found.dropped.mean, found.rand.low) == (1, 1, 1)


@pytest.mark.parametrize("motion_set", SETS)
def test_at_the_papers_noise_the_clusters_are_the_tables(motion_set):
    found = point(Setting(motion_set), SEEDS, 5)
    assert found.rand.mean > 0.95
    assert found.kept.mean > 0.7
    assert found.dropped.mean > 0.9


@pytest.mark.parametrize("motion_set", SETS)
def test_shuffled_answers_have_no_structure(motion_set):
    found = point(Setting(motion_set, control="answers"), SEEDS, 5)
    assert found.kept.mean < 0.02
    assert found.solved == 0
    assert abs(found.rand_of_all.mean) < 0.1


@pytest.mark.parametrize("motion_set", SETS)
def test_shuffled_clips_keep_pairs_that_have_nothing_in_common(motion_set):
    found = point(Setting(motion_set, control="clips"), SEEDS, 5)
    assert found.kept.mean > 0.7
    assert abs(found.rand.mean) < 0.1
    assert abs(found.rand_of_all.mean) < 0.1


@pytest.mark.parametrize("motion_set", SETS)
def test_more_raters_keep_and_drop_more_rightly_and_noise_does_the_opposite(motion_set):
    few, many = (point(Setting(motion_set, participants=n), SEEDS, 5) for n in (3, 30))
    assert few.dropped.mean < many.dropped.mean
    assert few.rand_of_all.mean <= many.rand_of_all.mean
    calm, noisy = (point(Setting(motion_set, noise), SEEDS, 5) for noise in (0.4, 1.0))
    assert calm.kept.mean > noisy.kept.mean


@pytest.mark.parametrize("participants", [14, 50])
def test_beyond_the_papers_noise_the_threshold_drops_what_clusters_would_still_show(participants):
    found = point(Setting("set_a", 1.2, participants), SEEDS, 5)
    assert found.kept.mean < 0.1
    assert found.rand_of_all.mean > 0.95


def test_the_grid_has_every_noise_with_every_number_of_raters():
    wanted = set(recovery.settings())
    assert len(wanted) == len(recovery.settings())
    assert all(Setting(s, n, p) in wanted for s in SETS for n in NOISES for p in PARTICIPANTS)


def test_the_same_seed_gives_the_same_on_any_number_of_processors():
    wanted = [Setting("set_a"), Setting("set_b", 0.4, control="clips")]
    told = []
    one = recovery.points(wanted, 2, 7, told.append, processes=1)
    assert one == recovery.points(reversed(wanted), 2, 7, processes=2)
    assert one != recovery.points(wanted, 2, 8, processes=1)
    assert told == [1, 2]


@pytest.fixture
def few(monkeypatch):
    monkeypatch.setattr(recovery, "NOISES", (0.1, PAPER_NOISE))
    monkeypatch.setattr(recovery, "PARTICIPANTS", (5, 14))
    monkeypatch.setattr(recovery_report, "NOISES", (0.1, PAPER_NOISE))
    monkeypatch.setattr(recovery_report, "PARTICIPANTS", (5, 14))


def test_the_command_writes_a_page_with_its_picture(few, tmp_path):
    words = ["recover", "--seeds", "2", "--seed", "3", "--into", str(tmp_path / "new")]
    done = CliRunner().invoke(app, words, catch_exceptions=False)
    assert done.exit_code == 0
    page = (tmp_path / "new" / "recovery.md").read_text("utf-8")
    assert "`manner recover --seeds 2 --seed 3 --into docs`" in page
    assert "(recovery.svg)" in page
    assert "of 2 |" in page
    picture = (tmp_path / "new" / "recovery.svg").read_text("utf-8")
    assert picture.startswith("<svg")
    for words in ("Set A, table 2", "Set B, table 3", "Rand index where clips are shuffled"):
        assert words in picture


@pytest.mark.parametrize(
    "setting",
    [
        Setting("set_a", NOISES[0]),
        Setting("set_a"),
        Setting("set_b", participants=5),
        Setting("set_b", control="clips"),
    ],
)
def test_the_documentation_tells_what_the_command_finds(setting):
    line = recovery_report.table({setting: point(setting, 100, 1)}, [setting]).splitlines()[-1]
    assert line in (DOCS / "recovery.md").read_text("utf-8").splitlines()
