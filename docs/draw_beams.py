#!/usr/bin/env python3
"""Draws the angles of a spotlight and its patterns' factor k into docs/images, from their formulas.

usage: docs/draw_beams.py [--check]
--check writes nothing and fails where a picture is not what the formulas of docs/theory/spotlights.md give.
"""
import math
import sys
from pathlib import Path

IMAGES = Path(__file__).resolve().parent / "images"
BLUE, RED, GREEN, GREY, DARK = "#2563eb", "#b91c1c", "#15803d", "#94a3b8", "#334155"


def triangle_wave(x, period):
    return abs(2 * (x % period) - period) / period


def k(x, period, q, centred=False):
    """The factor of a pattern: 1 at multiples of the period, or half way between them."""
    wave = triangle_wave(x, period)
    return max(q + (1 - q) * (1 - wave if centred else wave), 0)


def polyline(points, color, width=1.5, fill="none", more=""):
    text = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return f'<polyline points="{text}" fill="{fill}" stroke="{color}" stroke-width="{width}" {more}/>'


def label(x, y, text, color=DARK, anchor="middle"):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{color}">{text}</text>'


def svg(width, height, title, parts):
    tip = ('<defs><marker id="tip" markerWidth="8" markerHeight="8" refX="6" refY="3" orient="auto">'
           f'<path d="M0 0L6 3L0 6" fill="none" stroke="{DARK}"/></marker></defs>')
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" '
            f'font-size="13">\n<title>{title}</title>\n<rect width="{width}" height="{height}" fill="#fff"/>\n{tip}\n'
            + "\n".join(parts) + "\n</svg>\n")


def oblique(x, y, z):
    """Picture of a point: x to the right and forwards, y to the right and backwards, z up."""
    return 250 + 0.86 * x + 0.55 * y, 60 + 0.3 * x - 0.32 * y - z


def ring(radius, z, first=0.0, last=2 * math.pi):
    """An arc about the beam's axis. phi rises from e0 = x towards e1 = a x e0 = -y, as the beam points down."""
    steps = 60
    angles = [first + (last - first) * i / steps for i in range(steps + 1)]
    return [oblique(radius * math.cos(a), -radius * math.sin(a), z) for a in angles]


def angles_picture():
    """The frame of a lamp: theta from the axis, phi about it from the reference direction."""
    depth, radius, phi = 250, 140, math.radians(32)
    lamp, foot = oblique(0, 0, 0), oblique(0, 0, -depth)
    place = ring(radius, -depth, phi, phi)[0]
    towards = [ring(190, -depth, angle, angle)[0] for angle in (0, math.pi / 2)]
    arrow = 'marker-end="url(#tip)"'
    near = 0.35
    theta = [(lamp[0] + near * (foot[0] + (place[0] - foot[0]) * t - lamp[0]),
              lamp[1] + near * (foot[1] + (place[1] - foot[1]) * t - lamp[1]) + 6 * math.sin(math.pi * t))
             for t in (i / 20 for i in range(21))]
    parts = [polyline(ring(radius, -depth), GREY, 1, "#eff6ff")]
    parts += [polyline([lamp, ring(radius, -depth, a, a)[0]], GREY, 1) for a in (math.radians(-50), math.radians(160))]
    parts += [polyline([foot, end], DARK, 1.5, more=arrow) for end in towards]
    parts += [polyline([lamp, oblique(0, 0, -depth - 40)], DARK, 1.5, more=arrow),
              polyline([lamp, place], BLUE, 2), polyline([foot, place], BLUE, 1, more='stroke-dasharray="4 3"'),
              polyline(theta, GREEN, 2), polyline(ring(70, -depth, 0, phi), RED, 2),
              f'<circle cx="{lamp[0]:.1f}" cy="{lamp[1]:.1f}" r="5" fill="#f59e0b"/>',
              f'<circle cx="{place[0]:.1f}" cy="{place[1]:.1f}" r="4" fill="{BLUE}"/>',
              label(lamp[0], lamp[1] - 12, "lamp Q"), label(place[0] + 10, place[1] + 18, "P", BLUE),
              label(foot[0] - 10, foot[1] + 42, "axis a", anchor="end"),
              label(towards[0][0] + 8, towards[0][1] + 18, "e₀, the reference: φ = 0"),
              label(towards[1][0] - 12, towards[1][1] + 20, "e₁ = a × e₀: φ = 90°"),
              label((2 * lamp[0] + foot[0] + place[0]) / 4, (lamp[1] + foot[1]) / 2, "θ", GREEN),
              label(*ring(100, -depth, 0.55 * phi, phi)[0], "φ", RED)]
    return svg(500, 440, "The angles theta and phi of a spotlight", parts)


def curve_of_k(q, color):
    xs = [i / 100 for i in range(201)]
    points = [(60 + 150 * x, 220 - 150 * k(x, 1, q)) for x in xs]
    return [polyline(points, color, 2)]


def factor_plot():
    parts = [polyline([(60, 40), (60, 220), (380, 220)], DARK, 1)]
    parts += [polyline([(60 + 150 * x, 70), (60 + 150 * x, 220)], GREY, 0.5) for x in (0.5, 1, 1.5, 2)]
    for q, color, x in (0.5, BLUE, 190), (0, GREEN, 265), (-1, RED, 325):
        parts += [*curve_of_k(q, color), label(x, 32, f"q = {q:g}", color)]
    parts += [label(60 + 150 * x, 238, text) for x, text in ((0, "0"), (0.5, "δ/2"), (1, "δ"), (1.5, "3δ/2"), (2, "2δ"))]
    return parts + [label(48, 75, "1"), label(48, 224, "0"), label(60, 32, "k(x; δ, q)"), label(392, 224, "x")]


def dots_value(theta, phi, centred):
    dphi, dtheta, q = math.radians(45), 10, -0.2
    cell = (math.floor(phi / dphi) + math.floor(theta / dtheta)) % 2
    return cell * k(phi, dphi, q, centred) * k(theta, dtheta, q, centred)


def dots_plot(x, y, centred, name):
    """Polka dots up to theta = 30 degrees, seen along the beam with phi = 0 to the right."""
    parts = [f'<circle cx="{x}" cy="{y}" r="90" fill="#0f172a"/>']
    rings, sectors = 15, 48
    for i in range(rings):
        for j in range(sectors):
            theta, phi = 30 * (i + 0.5) / rings, 2 * math.pi * (j + 0.5) / sectors
            value = dots_value(theta, phi, centred)
            if value < 0.02:
                continue
            corners = [(x + 90 * r / rings * math.cos(a), y + 90 * r / rings * math.sin(a))
                       for r, a in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
                       for a in (2 * math.pi * a / sectors,)]
            text = " ".join(f"{px:.1f},{py:.1f}" for px, py in corners)
            parts.append(f'<polygon points="{text}" fill="#fde68a" opacity="{value:.2f}"/>')
    for theta in 10, 20:
        parts.append(f'<circle cx="{x}" cy="{y}" r="{3 * theta}" fill="none" stroke="{GREY}" stroke-width="0.5"/>')
    for sector in range(8):
        a = sector * math.pi / 4
        parts.append(polyline([(x, y), (x + 90 * math.cos(a), y + 90 * math.sin(a))], GREY, 0.5))
    return parts + [label(x, y + 112, name)]


def factor_picture():
    parts = factor_plot() + dots_plot(510, 125, True, "dots, centred") + dots_plot(720, 125, False, "dots, literal")
    return svg(830, 260, "The factor k of patterns, and polka dots made of it", parts)


PICTURES = {"beam-angles.svg": angles_picture, "beam-factor.svg": factor_picture}


def main():
    if sys.argv[1:] == ["--check"]:
        false = [name for name, draw in PICTURES.items()
                 if (IMAGES / name).read_text(encoding="utf-8") != draw()]
        sys.exit("\n".join(f"{name} is not what the formulas give; run docs/draw_beams.py" for name in false) or 0)
    for name, draw in PICTURES.items():
        (IMAGES / name).write_text(draw(), encoding="utf-8")


if __name__ == "__main__":
    main()
