# SPDX-License-Identifier: Apache-2.0
"""How the cost of a ray grows with the number of objects: reads bench_accelerators, draws SVG."""

import math

COLUMNS = ("structure", "objects", "rays_per_second", "steps", "boxes", "items", "build_seconds",
           "bytes_per_object")
COLORS = {"bvh": "#1f77b4", "bsp": "#2ca02c", "bsp-median": "#8fbf45", "octree": "#d62728",
          "grid": "#9467bd", "grid2": "#c9a0dc", "boxes": "#8c564b", "slabs": "#e377c2",
          "spheres": "#7f7f7f", "none": "#ff7f0e", "extents": "#17becf"}
WIDTH, HEIGHT, PANEL = 990, 480, 400
STYLE = """<style>
text { font: 13px system-ui, sans-serif; fill: #1c2329 } .line { fill: none; stroke-width: 2 }
.grid { stroke: #dcdad2 } .paper { fill: #fdfcf9 } .title { font-weight: 600 }
@media (prefers-color-scheme: dark) {
  text { fill: #e4e8eb } .grid { stroke: #333b42 } .paper { fill: #14181c } }
</style>"""


def read(output, kind="even"):
    """The rows of one kind of scene in what bench_accelerators prints, as dictionaries."""
    rows = []
    for line in output.splitlines():
        fields = line.split()
        if not fields or fields[0] != kind or not fields[1].isdigit():
            continue
        _, objects, name, rate, steps, boxes, items, build, size = fields[:9]
        rows.append(dict(zip(COLUMNS, (name, int(objects), float(rate), float(steps), float(boxes),
                                       float(items), float(build), float(size)))))
    return rows


def looks(row):
    """Nodes, cells and boxes that a ray looks at."""
    return row["steps"] + row["boxes"]


class Panel:
    """Axes with objects to the right on a logarithmic scale; `low` to `high` upwards, logarithmic
    too if `log`."""

    def __init__(self, left, title, objects, low, high, log):
        self.left, self.top, self.size = left, 50, PANEL
        self.first, self.last = math.log10(min(objects)), math.log10(max(objects))
        self.low, self.high, self.log = low, high, log
        self.parts = [f'<text class="title" x="{left}" y="30">{title}</text>']

    def x(self, objects):
        span = max(self.last - self.first, 1e-9)
        return self.left + (math.log10(objects) - self.first) / span * (self.size - 70)

    def y(self, value):
        scale = math.log10 if self.log else float
        share = (scale(value) - scale(self.low)) / (scale(self.high) - scale(self.low))
        return self.top + (1 - share) * (self.size - 30)

    def add_axes(self, objects, ticks):
        right = self.x(max(objects))
        for value in ticks:
            y = self.y(value)
            self.parts.append(f'<path class="grid" d="M{self.left} {y:.1f}H{right:.1f}"/>')
            self.parts.append(f'<text x="{self.left - 6}" y="{y + 4:.1f}" text-anchor="end">'
                              f'{short(value)}</text>')
        for count in sorted(set(objects)):
            self.parts.append(f'<text x="{self.x(count):.1f}" y="{self.top + self.size - 8}" '
                              f'text-anchor="middle">{short(count)}</text>')

    def add_curve(self, name, points):
        color = COLORS.get(name, "#888888")
        inside = [(self.x(n), self.y(v)) for n, v in points if self.low <= v <= self.high]
        if not inside:
            return None
        path = "L".join(f"{x:.1f} {y:.1f}" for x, y in inside)
        self.parts.append(f'<path class="line" stroke="{color}" d="M{path}"/>')
        self.parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{color}"/>'
                       for x, y in inside]
        return (inside[-1], name, color)

    def add_names(self, ends):
        """The names beside the ends of the curves, moved apart where they would touch."""
        below = -math.inf
        for (x, y), name, color in sorted(ends, key=lambda end: end[0][1]):
            below = max(y + 4, below + 14)
            self.parts.append(f'<text x="{x + 8:.1f}" y="{below:.1f}" style="fill:{color}">'
                              f'{name}</text>')


def short(value):
    """10000 as 10^4 and 2000000 as 2 M."""
    for unit, name in ((1e6, " M"), (1e3, " k")):
        if value >= unit:
            return f"{value / unit:g}{name}"
    return f"{value:g}"


def svg(rows):
    """The picture: rays per second, and nodes and boxes per ray, over the number of objects."""
    names = list(dict.fromkeys(row["structure"] for row in rows))
    objects = [row["objects"] for row in rows]
    rates = [row["rays_per_second"] for row in rows]
    low, high = (10.0 ** rounded(math.log10(edge(rates)))
                 for rounded, edge in ((math.floor, min), (math.ceil, max)))
    work = [looks(row) for row in rows if row["structure"] != "none"] or [1.0]
    most = 20 * math.ceil(max(work) / 20)
    speed = Panel(70, "rays per second, one thread", objects, low, high, True)
    effort = Panel(560, "nodes, cells and boxes per ray", objects, 0, most, False)
    speed.add_axes(objects, [10.0 ** power for power in range(
        round(math.log10(low)), round(math.log10(high)) + 1)])
    effort.add_axes(objects, range(0, most + 1, 20))
    for panel, value in ((speed, lambda row: row["rays_per_second"]), (effort, looks)):
        ends = [panel.add_curve(name, [(row["objects"], value(row)) for row in rows
                                       if row["structure"] == name]) for name in names]
        panel.add_names([end for end in ends if end])
    middle = '<text x="{}" y="{}" text-anchor="middle">spheres</text>'
    return "\n".join([
        '<!-- SPDX-License-Identifier: Apache-2.0 -->',
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}">', STYLE,
        f'<rect class="paper" width="{WIDTH}" height="{HEIGHT}"/>', *speed.parts, *effort.parts,
        middle.format(235, HEIGHT - 14), middle.format(725, HEIGHT - 14), "</svg>", ""])
