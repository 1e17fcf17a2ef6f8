"""Plots for pdflatex: lines as PDF operators, text as LaTeX, in a picture environment of points."""

import math
import statistics

from values import digits

BLUE, ORANGE, GREEN = "0.11 0.41 0.78", "0.88 0.48 0.00", "0.00 0.55 0.45"
GRAY, GRID = "0.60 0.60 0.60", "0.82 0.82 0.82"


class Plot:
    def __init__(self, width, height):
        self.width, self.height = width, height
        self.parts = []

    def line(self, points, color="0 0 0", width=0.5, dash=""):
        path = " ".join(f"{x:.2f} {y:.2f} {'l' if i else 'm'}" for i, (x, y) in enumerate(points))
        self._literal(f"{color} RG {width} w 1 J 1 j [{dash}] 0 d {path} S")

    def dot(self, x, y, radius, color, filled=True):
        k = 0.5523 * radius
        path = (f"{x - radius:.2f} {y:.2f} m "
                f"{x - radius:.2f} {y + k:.2f} {x - k:.2f} {y + radius:.2f} {x:.2f} {y + radius:.2f} c "
                f"{x + k:.2f} {y + radius:.2f} {x + radius:.2f} {y + k:.2f} {x + radius:.2f} {y:.2f} c "
                f"{x + radius:.2f} {y - k:.2f} {x + k:.2f} {y - radius:.2f} {x:.2f} {y - radius:.2f} c "
                f"{x - k:.2f} {y - radius:.2f} {x - radius:.2f} {y - k:.2f} {x - radius:.2f} {y:.2f} c h")
        self._literal(f"{color} rg {path} f" if filled else f"{color} RG 0.5 w [] 0 d {path} S")

    def blank(self, x, y, width, height):
        self._literal(f"1 1 1 rg {x} {y} {width} {height} re f")

    def text(self, x, y, text, anchor="", size=r"\footnotesize"):
        self.parts.append(rf"\put({x:.2f},{y:.2f}){{\makebox(0,0)[{anchor}]{{{size} {text}}}}}")

    def write(self, path):
        path.write_text("\\begingroup\\setlength{\\unitlength}{1bp}%\n"
                        f"\\begin{{picture}}({self.width},{self.height})\n" + "\n".join(self.parts) +
                        "\n\\end{picture}\\endgroup\n")

    def _literal(self, operators):
        self.parts.append(rf"\put(0,0){{\pdfliteral{{q {operators} Q}}}}")


class LogAxis:
    """From values between 10^low and 10^high to points between begin and end."""

    def __init__(self, low, high, begin, end):
        self.low, self.high, self.begin, self.end = low, high, begin, end

    def __call__(self, value):
        share = (math.log10(value) - self.low) / (self.high - self.low)
        return self.begin + share * (self.end - self.begin)

    def decades(self):
        return range(math.ceil(self.low), math.floor(self.high) + 1)


def convergence(path, series):
    """series: (label, color, steps [m] of the iterations). How long the steps are, iteration by iteration."""
    plot = Plot(233, 150)
    floor = 1e-9
    y_axis = LogAxis(-9, -1, 22, 146)
    longest = max(len(steps) for _, _, steps in series)
    def x_of(iteration):
        return 32 + (iteration - 1) / (longest - 1) * 200
    for decade in y_axis.decades():
        y = y_axis(10.0 ** decade)
        plot.line([(32, y), (232, y)], GRID, 0.3)
        if decade % 2 == 1:
            plot.text(29, y, f"$10^{{{decade}}}$", "r", r"\scriptsize")
    for iteration in range(10, longest + 1, 10):
        plot.line([(x_of(iteration), 20), (x_of(iteration), 22)])
        plot.text(x_of(iteration), 14, str(iteration), "", r"\scriptsize")
    plot.line([(32, 22), (232, 22)])
    plot.text(132, 3, "iteration")
    plot.parts.append(r"\put(5,84){\makebox(0,0){\rotatebox{90}{\footnotesize step [m]}}}")
    for label, color, steps in series:
        points = [(x_of(i + 1), y_axis(max(s, floor))) for i, s in enumerate(steps)]
        plot.line(points, color, 1.0)
        for x, y in points:
            plot.dot(x, y, 1.1, color)
    plot.blank(132, 108, 98, 36)
    for row, (label, color, _) in enumerate(series):
        y = 138 - 11 * row
        plot.line([(136, y), (148, y)], color, 1.0)
        plot.dot(142, y, 1.3, color)
        plot.text(152, y, label, "l", r"\scriptsize")
    plot.write(path)


def strips(path, rows, low, high, unit):
    """rows: (label, color, values) or (heading, None, None). Each value is a dot, the median a bar."""
    step = 12
    plot = Plot(233, step * len(rows) + 30)
    x_axis = LogAxis(low, high, 112, 210)
    bottom = 24
    for decade in x_axis.decades():
        x = x_axis(10.0 ** decade)
        plot.line([(x, bottom), (x, plot.height - 2)], GRID, 0.3)
        plot.text(x, 17, f"{10.0 ** decade:g}", "", r"\scriptsize")
    plot.line([(112, bottom), (210, bottom)])
    plot.text(161, 5, unit)
    for i, (label, color, values) in enumerate(rows):
        y = plot.height - step * (i + 0.5) - 3
        if color is None:
            plot.text(0, y, label, "l", r"\scriptsize\itshape")
            continue
        plot.text(6, y, label, "l", r"\scriptsize")
        for k, value in enumerate(values):
            plot.dot(x_axis(value), y + 2.4 * ((k % 3) - 1), 0.9, color)
        median = statistics.median(values)
        plot.line([(x_axis(median), y - 4.6), (x_axis(median), y + 4.6)], "0 0 0", 1.0)
        plot.text(232, y, digits(median, 2), "r", r"\scriptsize")
    plot.write(path)
