"""Plots of the section on the next best view."""

from plots import BLUE, GRAY, GREEN, GRID, ORANGE, Plot
from values import read_csv

PURPLE, RED, BROWN = "0.50 0.26 0.70", "0.80 0.16 0.20", "0.52 0.34 0.18"
# In the order in which they are drawn, the first on top.
POLICIES = (("default", GREEN), ("paper", ORANGE), ("gain", BLUE), ("potential_area", PURPLE),
            ("two_steps", BROWN), ("nearest_frontier", RED), ("random", GRAY))
LEFT, BOTTOM, RIGHT, TOP = 30, 28, 196, 150


def coverage(path, run, column, label):
    """How much has been seen after multiples of the fewest scans, or of the tour through them: means over all runs."""
    rows = read_csv(run / "curves.csv")
    most = max(float(row["bound"]) for row in rows)
    plot = Plot(200, 154)
    x_of = lambda multiple: LEFT + multiple / most * (RIGHT - LEFT)
    y_of = lambda share: BOTTOM + share * (TOP - BOTTOM)
    for percent in range(0, 101, 25):
        y = y_of(percent / 100)
        plot.line([(LEFT, y), (RIGHT, y)], GRID, 0.3)
        plot.text(LEFT - 3, y, f"{percent}", "r", r"\scriptsize")
    for multiple in range(int(most) + 1):
        plot.line([(x_of(multiple), BOTTOM - 2), (x_of(multiple), BOTTOM)])
        plot.text(x_of(multiple), BOTTOM - 8, str(multiple), "", r"\scriptsize")
    plot.line([(LEFT, BOTTOM), (RIGHT, BOTTOM)])
    plot.text(0.5 * (LEFT + RIGHT), 6, label)
    plot.parts.append(r"\put(5,89){\makebox(0,0){\rotatebox{90}{\footnotesize seen [\%]}}}")
    for name, color in reversed(POLICIES):
        points = [(x_of(float(row["bound"])), y_of(float(row[column]))) for row in rows if row["policy"] == name]
        if points:
            plot.line(points, color, 1.4 if name == "default" else 0.8)
    plot.write(path)


def names(path):
    """Which colour is which, beside the plots."""
    plot = Plot(78, 154)
    for row, (name, color) in enumerate(POLICIES):
        y = TOP - 12 * (row + 0.5)
        plot.line([(0, y), (12, y)], color, 1.4 if name == "default" else 0.8)
        plot.text(16, y, name.replace("_", " "), "l", r"\scriptsize")
    plot.write(path)
