"""Lamps as a value."""
import pathlib

from ._keiko import rig_of_file, rig_of_text  # type: ignore[import]


class Rig:
    """Lamps, as the text of a rig file: `str(rig)`. Verbs take it where they take a rig file."""

    def __init__(self, text: str):
        self._text = rig_of_text(text)

    @classmethod
    def read(cls, file) -> "Rig":
        """The lamps of a rig file. Luminaires are still read from the files that it names."""
        return cls(rig_of_file(file))

    @property
    def text(self) -> str:
        """The text of the rig file, always the same for the same lamps."""
        return self._text

    def write(self, file) -> None:
        """Writes the rig file."""
        pathlib.Path(file).write_text(self._text, encoding="utf-8")

    def __str__(self) -> str:
        return self._text

    def __eq__(self, other) -> bool:
        return isinstance(other, Rig) and self._text == other._text

    def __hash__(self) -> int:
        return hash(self._text)

    def __reduce__(self):
        return type(self), (self._text,)

    def __repr__(self) -> str:
        return f"<Rig of {self._text.count('[[')} sources>"
