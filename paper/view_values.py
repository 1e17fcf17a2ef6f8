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
    samplers.sort(key=lambda row: estimate(row["scans, change %"]))
    values.set(f"{name}.samplers.verdict", sampler_verdict(samplers))
    for key, row in (("best", samplers[0]), ("worst", samplers[-1])):
        values.set(f"{name}.samplers.{key}.name", row["samplers"].replace("_", " "))
        values.set(f"{name}.samplers.{key}.change", with_minus_signs(row["scans, change %"]))
        values.set(f"{name}.samplers.{key}.p", row["p"])
    for row in read_csv(run / "ways.csv"):
        for what, change, p in (("way", "way, change %", "p way"), ("scans", "scans, change %", "p")):
            values.set(f"{name}.ways.{row['ways']}.{what}.change", with_minus_signs(row[change]))
            values.set(f"{name}.ways.{row['ways']}.{what}.p", row[p])


def estimate(text):
    """Of "+3 [-1, +7]"; what never got there comes last."""
    first = text.split()[0]
    return float("inf") if first == "never" else float(first)


def sampler_verdict(rows, level=0.05):
    """Which samplers differ from the uniform one after Holm's correction, with their intervals."""
    named = {sign: [f"{row['samplers'].replace('_', ' ')} ({with_minus_signs(row['scans, change %'])}\\,\\%)"
                    for row in rows
                    if float(row["p"]) < level and estimate(row["scans, change %"]) * sign > 0]
             for sign in (-1, 1)}
    fewer, more = ", ".join(named[-1]), ", ".join(named[1])
    if not fewer and not more:
        return "no sampler differs from the uniform one in the number of scans"
    return " and ".join(([f"fewer scans than with uniform candidates are needed with {fewer}"] if fewer else
                         ["no sampler needs fewer scans than the uniform one"]) +
                        ([f"more with {more}"] if more else []))


def with_minus_signs(text):
    """Signs as mathematics has them."""
    return re.sub(r"([+-])(\d)", r"$\1$\2", text)
