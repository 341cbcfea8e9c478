"""Line drawings of one view as pictures of a page: cropped, and placed as a rendered picture of that view."""
import re

from png_file import read_png

LAYER = re.compile(r'<g id="([^"]*)"[^>]*><path stroke-width="([^"]*)"[^>]* d="([^"]*)"/></g>')
FURNITURE = ("frame", "scale", "dimensions")
DEVIATION = 0.05  # pixels that thinned lines leave the drawn ones


def lines_of(path):
    """The lines of an SVG path of `M x y l dx dy ...`, as lists of points."""
    lines = []
    for part in filter(None, path.split("M")):
        x, y, *steps = map(float, re.findall(r"-?[0-9.]+", part))
        line = [(x, y)]
        for dx, dy in zip(steps[::2], steps[1::2]):
            line.append((line[-1][0] + dx, line[-1][1] + dy))
        lines.append(line)
    return lines


def bounds(points):
    xs, ys = zip(*points)
    return min(xs), min(ys), max(xs), max(ys)


def body_bounds(picture):
    """Width and height of a PNG file, and the box of its pixels that are not as the first one."""
    width, height, channels, samples = read_png(picture)
    first = samples[:channels]
    body = [(i % width, i // width) for i in range(width * height)
            if samples[i * channels:(i + 1) * channels] != first]
    left, upper, right, lower = bounds(body)
    return width, height, (left, upper, right + 1, lower + 1)


def thinned(line):
    """A line without points that lie within DEVIATION of the chords between the others."""
    (ax, ay), (bx, by) = line[0], line[-1]
    length = max(((bx - ax) ** 2 + (by - ay) ** 2) ** 0.5, 1e-9)
    closed = length <= DEVIATION  # it has no chord to measure from
    off = [((x - ax) ** 2 + (y - ay) ** 2) ** 0.5 if closed
           else abs((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / length for x, y in line]
    worst = max(range(len(line)), key=off.__getitem__)
    if off[worst] <= DEVIATION or worst in (0, len(line) - 1):
        return [line[0], line[-1]]
    return thinned(line[:worst + 1])[:-1] + thinned(line[worst:])


def line_picture(sheet, picture):
    """The SVG text of a sheet's lines, in the pixels of a picture that shows the same body."""
    layers = [(width, lines_of(path)) for name, width, path in LAYER.findall(sheet) if name not in FURNITURE]
    left, upper, right, _ = bounds([point for _, lines in layers for line in lines for point in line])
    width, height, body = body_bounds(picture)
    scale = (body[2] - body[0]) / (right - left)
    groups = []
    for pen, lines in layers:
        placed = [thinned([(body[0] + (x - left) * scale, body[1] + (y - upper) * scale) for x, y in line])
                  for line in lines]
        path = "".join("M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in line) for line in placed)
        groups.append(f'<path stroke-width="{float(pen) * 3:.2g}" d="{path}"/>\n')
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
            f'height="{height}">\n<rect width="100%" height="100%" fill="#fff"/>\n<g fill="none" stroke="#000" '
            f'stroke-linecap="round" stroke-linejoin="round">\n{"".join(groups)}</g>\n</svg>\n')
