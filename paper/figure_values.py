"""The numbers of Table 1 and of the figures 3 and 5."""

import math

from runs import read_json
from values import count, digits, duration, ratio


def add_published_table(values, published):
    table = published["table_1"]
    base = table["rows"][-1]["seconds"]
    for row in table["rows"]:
        key = f"table.paper.{row['points']}.{row['search']}"
        values.set(key + ".time", row["time"].replace("<", "$<$").replace(" ", "\\,"))
        values.set(key + ".iterations", row["iterations"])
        values.set(key + ".ratio", ratio(row["seconds"] / base))
    values.set("table.paper.all.points", count(table["all_points"]))
    values.set("table.paper.reduced.points", count(table["reduced_points"]))


def add_table(values, name, published_seconds, run):
    """published_seconds: of the last row of the original's table."""
    metrics, timing = read_json(run / "metrics.json"), read_json(run / "timing.json")
    base = timing[-1]["seconds"]
    seconds = {}
    for measured, timed in zip(metrics, timing):
        assert (measured["points"], measured["search"]) == (timed["points"], timed["search"])
        key = f"table.{name}.{measured['points']}.{measured['search']}"
        seconds[measured["points"], measured["search"]] = timed["seconds"]
        values.set(key + ".time", duration(timed["seconds"]))
        values.set(key + ".iterations", measured["iterations"])
        values.set(key + ".ratio", ratio(timed["seconds"] / base))
        if measured["search"] == "kd_tree":
            values.set(f"table.{name}.{measured['points']}.points", count(measured["data_points"]))
    by_points = {m["points"]: m for m in metrics}
    share = by_points["all"]["data_points"] / by_points["reduced"]["data_points"]
    values.set(f"table.{name}.reduction", digits(share, 3))
    differences = [abs(a - b) for points in ("all", "reduced")
                   for a, b in zip(*(m["T_model_data"] for m in metrics if m["points"] == points))]
    values.set(f"table.{name}.difference", power(max(differences)))
    values.set(f"table.{name}.reduced.speedup",
               ratio(seconds["reduced", "brute_force"] / seconds["reduced", "kd_tree"]))
    values.set(f"table.{name}.gain", ratio(float(digits(published_seconds / base, 2))))


def power(number):
    """A power of ten that the number does not exceed; 0 is said as such."""
    return "0" if number == 0 else f"$10^{{{math.ceil(math.log10(number))}}}$"


def quaternion_angle(p, q):
    return 2.0 * math.acos(min(1.0, abs(sum(a * b for a, b in zip(p, q)))))


def add_fig_03(values, name, run):
    metrics = read_json(run / "metrics.json")
    final = metrics["stages"][-1]["T_model_data"]
    for key, stage in zip(("start", "during"), metrics["stages"]):
        pose = stage["T_model_data"]
        values.set(f"{name}.{key}.cm", digits(100 * math.dist(pose[:3], final[:3]), 2))
        values.set(f"{name}.{key}.deg", digits(math.degrees(quaternion_angle(pose[3:], final[3:])), 2))
    values.set(f"{name}.iterations", metrics["iterations"])
    values.set(f"{name}.pairs", count(metrics["pairs"]))


def add_fig_05(values, name, run):
    metrics = read_json(run / "metrics.json")
    values.set(f"{name}.points", count(metrics["points"]))
    values.set(f"{name}.reduced", count(metrics["reduced_points"]))
    values.set(f"{name}.share", digits(metrics["points"] / metrics["reduced_points"], 2))
    values.set(f"{name}.edges", count(metrics["edge_points"]))
