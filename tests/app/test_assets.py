"""From an entry's name to its built files."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest
from starlette.testclient import TestClient

from app.assets import Assets

MANIFEST = {
    "src/entries/site.ts": {"file": "assets/site-1.js", "css": ["assets/site-1.css"]},
    "src/entries/clip.ts": {
        "file": "assets/clip-1.js",
        "css": ["assets/clip-1.css"],
        "imports": ["_viewer.js", "_shared.js"],
        "dynamicImports": ["_three.js"],
    },
    "_viewer.js": {"file": "assets/viewer-1.js", "imports": ["_shared.js"]},
    "_shared.js": {"file": "assets/shared-1.js", "css": ["assets/shared-1.css"]},
    "_three.js": {"file": "assets/three-1.js"},
    "src/styles/japanese.css": {"file": "assets/japanese-1.css"},
}


@pytest.fixture
def assets(tmp_path: Path) -> Assets:
    (tmp_path / ".vite").mkdir()
    (tmp_path / ".vite" / "manifest.json").write_text(json.dumps(MANIFEST))
    return Assets(tmp_path)


def test_an_entry_gives_its_script_and_style(assets: Assets) -> None:
    assert assets.tags("src/entries/site.ts").splitlines() == [
        '<link rel="stylesheet" href="/static/assets/site-1.css">',
        '<script type="module" src="/static/assets/site-1.js"></script>',
    ]


def test_a_stylesheet_may_stand_alone(assets: Assets) -> None:
    tag = '<link rel="stylesheet" href="/static/assets/japanese-1.css">'
    assert assets.tags("src/styles/japanese.css") == tag


def test_what_an_entry_imports_is_loaded_at_once_and_each_only_one_time(assets: Assets) -> None:
    html = assets.tags("src/entries/clip.ts")
    for file in ("clip-1.css", "shared-1.css", "viewer-1.js", "shared-1.js", "clip-1.js"):
        assert html.count(file) == 1
    assert "three-1" not in html  # loaded when it is wanted


def test_a_new_build_is_noticed(assets: Assets, tmp_path: Path) -> None:
    assets.tags("src/entries/site.ts")
    path = tmp_path / ".vite" / "manifest.json"
    path.write_text(json.dumps(MANIFEST).replace("site-1", "site-2"))
    os.utime(path, ns=(1, 1))
    assert "site-2.js" in assets.tags("src/entries/site.ts")


def test_a_missing_entry_or_build_is_named(assets: Assets, tmp_path: Path) -> None:
    with pytest.raises(LookupError, match=r"src/entries/nothing\.ts"):
        assets.tags("src/entries/nothing.ts")
    with pytest.raises(LookupError, match="not built"):
        Assets(tmp_path / "elsewhere").tags("src/entries/site.ts")


def test_files_with_a_hash_in_their_name_are_kept_for_a_year(client: TestClient) -> None:
    response = client.get("/static/assets/site-0a1b2c3d.js")
    assert response.headers["cache-control"] == "public, max-age=31536000, immutable"
    assert response.headers["content-encoding"] == "gzip"
    assert client.get("/static/.vite/manifest.json").headers["cache-control"] == "no-cache"
    assert (
        client.get("/static/assets/nothing.js").headers["cache-control"]
        != (response.headers["cache-control"])
    )
