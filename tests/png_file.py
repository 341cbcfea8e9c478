"""Reads PNG files of 8 bits a channel without other libraries."""
import struct
import zlib

CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}  # by colour type


def chunks(data):
    at = 8
    while at < len(data):
        size, = struct.unpack(">I", data[at:at + 4])
        yield data[at + 4:at + 8], data[at + 8:at + 8 + size]
        at += size + 12


def paeth(left, above, corner):
    near = left + above - corner
    return min((abs(near - left), 0, left), (abs(near - above), 1, above), (abs(near - corner), 2, corner))[2]


PREDICTORS = (lambda a, b, c: 0, lambda a, b, c: a, lambda a, b, c: b, lambda a, b, c: (a + b) // 2, paeth)


def unfiltered(row, above, step, kind):
    """A row of samples from a row of differences."""
    predict = PREDICTORS[kind]
    for i, sample in enumerate(row):
        left, corner = (row[i - step], above[i - step]) if i >= step else (0, 0)
        row[i] = (sample + predict(left, above[i], corner)) & 255
    return row


def read_png(path):
    """Width, height, channels and samples (bytes, row by row) of a PNG file that is not interlaced."""
    data = path.read_bytes()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError(f"{path}: no PNG file")
    parts = list(chunks(data))
    width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", parts[0][1])
    if depth != 8 or interlaced or colour not in CHANNELS:
        raise ValueError(f"{path}: not of 8 bits a channel, or interlaced")
    step = CHANNELS[colour]
    packed = zlib.decompress(b"".join(body for kind, body in parts if kind == b"IDAT"))
    samples, above, size = bytearray(), bytearray(width * step), width * step + 1
    for y in range(height):
        row = bytearray(packed[y * size + 1:(y + 1) * size])
        above = unfiltered(row, above, step, packed[y * size])
        samples += above
    return width, height, step, bytes(samples)
