"""The front end's types are those of the server's API."""

import subprocess

from app.settings import PROJECT


def test_the_committed_types_are_the_generated_ones():
    done = subprocess.run(
        ["node", "scripts/api-types.mjs", "--check"],
        cwd=PROJECT / "static",
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
