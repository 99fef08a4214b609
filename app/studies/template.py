"""What a template is: a study that works as it stands, to be made one's own."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from app.errors import InvalidError

Document = dict[str, Any]


@dataclass(frozen=True)
class Template:
    """A study to begin with.

    Attributes:
        id: by which `manner study new` and the API know it.
        title: in the list of templates.
        summary: what a participant does, and how often.
        minutes: how long it takes.
        notes: what its author should look after before anybody is asked.
        make: the study file as data; clips of the sample library are called by their names.
        options: what `make` can be told, by name: what it means.
    """

    id: str
    title: str
    summary: str
    minutes: int
    notes: str
    make: Callable[..., Document]
    options: Mapping[str, str] = field(default_factory=dict)

    def build(self, **options: str) -> Document:
        """The study file as data, the same at every call.

        Args:
            options: those of the template, as text.

        Raises:
            InvalidError: the template has no such option, or cannot read its value.
        """
        for name in options.keys() - self.options.keys():
            known = ", ".join(self.options) or "none"
            message = f"The template {self.id} has no option “{name}”."
            raise InvalidError(message, mend=f"There is: {known}.")
        return self.make(**options)
