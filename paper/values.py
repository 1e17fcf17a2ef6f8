"""The numbers of the text, taken from run directories. Each is a LaTeX macro: \\val{key}."""

import csv
import math
import re

from runs import read_json

METRICS = ("point_to_point", "point_to_plane", "plane_to_plane")


class Values:
    def __init__(self):
        self.texts = {}

    def set(self, key, text):
        assert re.fullmatch(r"[A-Za-z0-9_.]+", key) and key not in self.texts, key
        self.texts[key] = str(text)

    def write(self, path, real_data):
        lines = ["% Written by build.py from run directories.",
                 r"\realdatatrue" if real_data else r"\realdatafalse"]
        lines += [rf"\setval{{{key}}}{{{text}}}" for key, text in self.texts.items()]
        path.write_text("\n".join(lines) + "\n")


def read_csv(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def count(number):
    return f"{number:,}".replace(",", r"\,")


def digits(number, significant):
    """Rounded to significant digits, without an exponent."""
    if number == 0:
        return "0"
    decimals = max(0, significant - 1 - math.floor(math.log10(abs(number))))
    return f"{round(number, significant - 1 - math.floor(math.log10(abs(number)))):.{decimals}f}"


def signed(number, decimals):
    return f"${number:.{decimals}f}$"


def duration(seconds):
    if seconds < 1:
        return f"{digits(1e3 * seconds, 3)}\\,ms"
    return f"{digits(seconds, 3)}\\,s"


def ratio(number):
    return count(int(float(digits(number, 3)))) if number >= 100 else digits(number, 2)


def percentile(values, share):
    ordered = sorted(values)
    position = share * (len(ordered) - 1)
    below = int(position)
    above = min(below + 1, len(ordered) - 1)
    return ordered[below] + (position - below) * (ordered[above] - ordered[below])


def root_mean_square(values):
    return math.sqrt(sum(v * v for v in values) / len(values))


def add_options(values, name, run):
    """All options of a run, from its resolved config: NAME.section.key."""
    path = []
    for line in (run / "config.yaml").read_text().splitlines():
        depth = (len(line) - len(line.lstrip())) // 2
        key, _, value = line.strip().partition(":")
        path = path[:depth] + [key]
        if value:
            values.set(".".join([name, *path]), option_text(value.strip().strip("'")))


def option_text(value):
    """Powers of ten and names, as one sets them."""
    exponent = re.fullmatch(r"1e([+-]\d+)", value)
    return f"$10^{{{int(exponent[1])}}}$" if exponent else value.replace("_", r"\_")


def add_metrics(values, name, run):
    """The counts of a run."""
    for key, value in read_json(run / "metrics.json").items():
        values.set(f"{name}.{key}", count(value))


def standard_deviation(covariance, axes):
    return math.sqrt(sum(float(covariance[f"{axis}_{axis}"]) for axis in axes))
