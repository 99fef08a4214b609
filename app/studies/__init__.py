"""Studies that come with the server, as data."""

from app.studies import adjectives, emotion, matching, naturalness
from app.studies.template import Template

TEMPLATES: dict[str, Template] = {
    template.id: template
    for template in (
        *emotion.TEMPLATES,
        *adjectives.TEMPLATES,
        *naturalness.TEMPLATES,
        *matching.TEMPLATES,
    )
}

__all__ = ["TEMPLATES", "Template"]
