"""Display pictures as values."""
import pathlib


class Picture:
    """A display picture: the bytes of its PNG file. A notebook shows it."""

    def __init__(self, png: bytes):
        self.png = png

    def write(self, file) -> None:
        """Writes the PNG file."""
        pathlib.Path(file).write_bytes(self.png)

    def _repr_png_(self) -> bytes:
        return self.png
