"""The numbers of the section on the next best view, from the tables of ablation_nbv."""

import re

from values import read_csv


def add_views(values, name, run):
    """What samplers and ways change, and how often the paper's constants get to the end."""
    values.set(f"{name}.floor_count", str(len(read_csv(run / "floors.csv"))))
    paper = next(row for row in read_csv(run / "policies.csv") if row["policies"] == "paper")
    values.set(f"{name}.paper.reached", paper["reached %"])
    values.set(f"{name}.paper.ended", paper["ended %"])
    samplers = [row for row in read_csv(run / "samplers.csv") if row["samplers"] != "uniform"]
    samplers.sort(key=lambda row: float(row["scans, change %"].split()[0]))
    for key, row in (("best", samplers[0]), ("worst", samplers[-1])):
        values.set(f"{name}.samplers.{key}.name", row["samplers"].replace("_", " "))
        values.set(f"{name}.samplers.{key}.change", with_minus_signs(row["scans, change %"]))
        values.set(f"{name}.samplers.{key}.p", row["p"])
    for row in read_csv(run / "ways.csv"):
        values.set(f"{name}.ways.{row['ways']}.change", with_minus_signs(row["way, change %"]))
        values.set(f"{name}.ways.{row['ways']}.p", row["p way"])


def with_minus_signs(text):
    """Signs as mathematics has them."""
    return re.sub(r"([+-])(\d)", r"$\1$\2", text)
