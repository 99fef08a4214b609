"""A specification as a picture for print, without a browser."""

from __future__ import annotations

from typing import Any

import vl_convert


def svg(spec: dict[str, Any]) -> str:
    """The chart as SVG."""
    return str(vl_convert.vegalite_to_svg(spec))
