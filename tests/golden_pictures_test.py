"""What tests/golden_pictures.py finds, in pictures that are written for it."""
import struct
import tempfile
import unittest
import zlib
from pathlib import Path

import golden_pictures
from png_file import PREDICTORS, read_png

WIDTH, HEIGHT = 50, 20


def encoded(rows, kind):
    """Rows of RGB samples, each as differences by the filter `kind`."""
    above, body = bytes(3 * WIDTH), b""
    for row in rows:
        left = [row[i - 3] if i >= 3 else 0 for i in range(len(row))]
        corner = [above[i - 3] if i >= 3 else 0 for i in range(len(row))]
        predicted = map(PREDICTORS[kind], left, above, corner)
        body += bytes([kind]) + bytes((a - b) & 255 for a, b in zip(row, predicted))
        above = row
    return body


def png(rows, kind=0):
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    head = struct.pack(">IIBBBBB", WIDTH, len(rows), 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(encoded(rows, kind)))
            + chunk(b"IEND", b""))


class GoldenPictures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.golden, self.picture = Path(folder.name) / "a.png", Path(folder.name) / "b.png"
        self.rows = [bytes((7 * x * x + 31 * y) % 251 for x in range(3 * WIDTH)) for y in range(HEIGHT)]
        self.golden.write_bytes(png(self.rows))

    def changed(self, pixels, levels):
        """Fault of a picture of which the green of some pixels is changed."""
        samples = bytearray(b"".join(self.rows))
        for pixel in range(pixels):
            at = 3 * (97 * pixel % (WIDTH * HEIGHT)) + 1
            samples[at] += levels if samples[at] < 128 else -levels
        size = 3 * WIDTH
        self.picture.write_bytes(png([bytes(samples[y * size:(y + 1) * size]) for y in range(HEIGHT)]))
        return golden_pictures.fault(self.golden, self.picture)

    def test_rows_of_every_filter_are_read(self):
        for kind in range(5):
            self.picture.write_bytes(png(self.rows, kind))
            self.assertEqual(read_png(self.picture), (WIDTH, HEIGHT, 3, b"".join(self.rows)), kind)

    def test_a_picture_within_the_tolerance_holds(self):
        self.assertIsNone(self.changed(0, 0))
        self.assertIsNone(self.changed(WIDTH * HEIGHT, golden_pictures.TOLERANCE))
        self.assertIsNone(self.changed(2, 100))

    def test_pixels_beyond_it_are_counted(self):
        self.assertIn("3 of 1000 pixels", self.changed(3, golden_pictures.TOLERANCE + 1))
        self.assertIn("by up to 100", self.changed(500, 100))

    def test_another_size_is_found(self):
        self.picture.write_bytes(png(self.rows[1:]))
        self.assertIn("instead of", golden_pictures.fault(self.golden, self.picture))

    def test_other_files_are_refused(self):
        self.picture.write_bytes(b"no picture")
        self.assertRaises(ValueError, read_png, self.picture)


if __name__ == "__main__":
    unittest.main()
