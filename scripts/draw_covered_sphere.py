#!/usr/bin/env python3
"""Draws docs/images/covered_sphere.svg: the sphere around a particle, the caps that its neighbors cover,
and what stays uncovered, as docs/labels.md defines them, in a cross-section.

Usage: draw_covered_sphere.py
"""
from math import acos, atan2, cos, hypot, pi, sin
from pathlib import Path

R1 = 1.0
R2 = 0.8
SCALE = 130
CENTER = (330, 200)
# Neighbors as they lie around a particle at a surface, in units of h.
NEIGHBORS = [(-0.62, -0.08), (0.55, -0.02), (-0.33, -0.52), (0.24, -0.60), (0.80, -0.45), (-0.82, -0.46)]
BLUE, ORANGE, INK, FAINT = "#0072b2", "#d55e00", "#1b1b1b", "#8a8a8a"


def place(x, y):
    return f"{CENTER[0] + SCALE * x:.1f},{CENTER[1] - SCALE * y:.1f}"


def on_circle(angle, radius=R1):
    return place(radius * cos(angle), radius * sin(angle))


def cap(x, y):
    """The angles between which a neighbor covers the circle: cos theta = (d^2 + r1^2 - r2^2) / (2 d r1)."""
    distance = hypot(x, y)
    half = acos((distance**2 + R1**2 - R2**2) / (2 * distance * R1))
    middle = atan2(y, x)
    return middle - half, middle + half


def arc(start, end, color, width):
    large = int(end - start > pi)
    return (f'<path d="M{on_circle(start)} A{SCALE * R1:.1f},{SCALE * R1:.1f} 0 {large} 0 {on_circle(end)}" '
            f'fill="none" stroke="{color}" stroke-width="{width}"/>')


def uncovered(caps):
    """The one stretch that no cap holds: the caps are joined from the lowest upward on both sides."""
    below = [(start, end) for start, end in sorted((s % (2 * pi), s % (2 * pi) + e - s) for s, e in caps)]
    reach, first = below[0][1], below[0][0]
    for start, end in below[1:]:
        assert start <= reach, "the drawing is of one uncovered part"
        reach = max(reach, end)
    return reach, first + 2 * pi


def text(x, y, words, color=INK, anchor="start"):
    return f'<text x="{x}" y="{y}" fill="{color}" text-anchor="{anchor}">{words}</text>'


def main():
    caps = [cap(*neighbor) for neighbor in NEIGHBORS]
    start, end = uncovered(caps)
    share = (end - start) / (2 * pi)
    lines = ['<svg xmlns="http://www.w3.org/2000/svg" width="660" height="440" viewBox="0 0 660 440" '
             'font-family="sans-serif" font-size="15">',
             "<title>Sphere, caps and the uncovered part</title>",
             '<rect width="660" height="440" fill="#ffffff"/>']
    for x, y in NEIGHBORS:
        cx, cy = place(x, y).split(",")
        lines.append(f'<circle cx="{cx}" cy="{cy}" r="{SCALE * R2:.1f}" fill="{BLUE}" fill-opacity="0.07" '
                     f'stroke="{BLUE}" stroke-opacity="0.45"/>')
    lines += [arc(*one, BLUE, 7) for one in caps] + [arc(start, end, ORANGE, 7)]
    cut = on_circle(caps[1][1])
    lines.append(f'<path d="M{on_circle(caps[1][0])} L{cut}" stroke="{FAINT}" stroke-dasharray="4 4"/>')
    for x, y in NEIGHBORS:
        cx, cy = place(x, y).split(",")
        lines.append(f'<circle cx="{cx}" cy="{cy}" r="6" fill="{BLUE}"/>')
    middle = (start + end) / 2
    tilt = middle + 0.35
    lines += [f'<path d="M{place(0, 0)} L{on_circle(tilt)}" stroke="{INK}"/>',
              f'<path d="M{place(*NEIGHBORS[1])} L{cut}" stroke="{INK}"/>',
              f'<circle cx="{CENTER[0]}" cy="{CENTER[1]}" r="7" fill="{ORANGE}"/>',
              text(CENTER[0] - 12, CENTER[1] + 24, "i"),
              text(CENTER[0] - 88, CENTER[1] - 66, "r<tspan font-size='11' dy='4'>1</tspan><tspan dy='-4'> = h</tspan>"),
              text(CENTER[0] + 72, CENTER[1] - 42, "r<tspan font-size='11' dy='4'>2</tspan><tspan dy='-4'> = 0.8 h</tspan>", INK, "end"),
              text(CENTER[0], 44, f"uncovered: lambda = {100 * share:.0f} % of this circle", ORANGE, "middle"),
              text(330, 402, "caps that the neighbors' spheres cover", BLUE, "middle"),
              text(330, 426, "cap of a neighbor at distance d: "
                   "cos theta = (d² + r1² - r2²) / (2 d r1)", INK, "middle")]
    target = Path(__file__).parents[1] / "docs/images/covered_sphere.svg"
    target.write_text("\n".join(lines) + "\n</svg>\n")


main()
