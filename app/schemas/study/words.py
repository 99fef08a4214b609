"""What a study file is made of at the bottom: names, numbers, and texts in several languages."""

from __future__ import annotations

from typing import Annotated, Literal, get_args

from pydantic import BaseModel, ConfigDict, Field, RootModel, StringConstraints

Language = Literal["en", "fi", "ja"]
LANGUAGES: tuple[Language, ...] = get_args(Language)
LANGUAGE_NAMES: dict[Language, str] = {"en": "English", "fi": "Suomi", "ja": "日本語"}

Text = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=20_000)]
Short = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=64)]
Title = Annotated[str, StringConstraints(strip_whitespace=True, min_length=1, max_length=200)]
Slug = Annotated[str, StringConstraints(pattern=r"^[a-z0-9]+(-[a-z0-9]+)*$", max_length=100)]
Name = Annotated[str, StringConstraints(pattern=r"^[a-z][a-z0-9_]*$", max_length=60)]
ContentHash = Annotated[str, StringConstraints(pattern=r"^[0-9a-f]{64}$")]


class Part(BaseModel):
    """A part of the study file: never changed once made, and no unknown member is passed over."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class Words(RootModel[Text | Annotated[dict[Language, Text], Field(min_length=1)]]):
    """A text: one for all languages, or one for each (`{en: …, fi: …, ja: …}`)."""

    model_config = ConfigDict(frozen=True)

    def __str__(self) -> str:
        """The text in the language that stands first."""
        return self.root if isinstance(self.root, str) else next(iter(self.root.values()))

    def __bool__(self) -> bool:
        return True

    def into(self, language: Language) -> Words:
        """The text in this language alone; where it is missing, in the one that stands first."""
        if isinstance(self.root, str):
            return self
        return Words(self.root.get(language, str(self)))

    def missing(self, languages: tuple[Language, ...]) -> list[Language]:
        """The languages that have no text of their own."""
        if isinstance(self.root, str):
            return []
        return [language for language in languages if language not in self.root]
