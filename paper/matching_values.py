"""The numbers of matching: the office against its truth, and simulated tours."""

import math
import re
import statistics

from runs import read_json
from values import digits, duration, read_csv, root_mean_square, standard_deviation

ALL_METHODS = ("pairwise", "metascan", "simultaneous", "graph", "joint")
MATCHING_METHODS = ("odometry", "pairwise", "metascan", "edges", "simultaneous", "graph", "joint", "truth")
MATCHING_MEASURES = {"position cm": "position", "rotation deg": "rotation", "map error cm": "map", "wall cm": "wall",
                     "worst wall cm": "worst"}


def errors_cm(runs, which="map"):
    return [100 * read_json(run / "metrics.json")["errors"][which]["translation_rms_m"] for run in runs]


def errors_deg(runs, which="map"):
    return [math.degrees(read_json(run / "metrics.json")["errors"][which]["rotation_rms_rad"]) for run in runs]


def add_errors(values, key, cm, deg):
    for unit, errors in (("cm", cm), ("deg", deg)):
        values.set(f"{key}.{unit}", digits(statistics.median(errors), 2))
        values.set(f"{key}.{unit}.low", digits(min(errors), 2))
        values.set(f"{key}.{unit}.high", digits(max(errors), 2))


def add_covariance(values, metric, runs):
    """What two scans' alignment says of its error, beside its error."""
    predicted = [read_csv(run / "covariances.csv")[0] for run in runs]
    sigma_cm = root_mean_square([100 * standard_deviation(c, "xyz") for c in predicted])
    sigma_deg = root_mean_square(
        [math.degrees(standard_deviation(c, ("rx", "ry", "rz"))) for c in predicted])
    error_cm, error_deg = root_mean_square(errors_cm(runs)), root_mean_square(errors_deg(runs))
    key = f"covariance.{metric}"
    values.set(key + ".error.cm", digits(error_cm, 2))
    values.set(key + ".sigma.cm", digits(sigma_cm, 2))
    values.set(key + ".error.deg", digits(error_deg, 2))
    values.set(key + ".sigma.deg", digits(sigma_deg, 2))
    values.set(key + ".ratio.cm", digits(error_cm / sigma_cm, 2))
    values.set(key + ".ratio.deg", digits(error_deg / sigma_deg, 2))


def add_matching(values, table, run):
    """Medians with their intervals, paired differences; returns the levels of noise."""
    levels = []
    for row in read_csv(run / "medians.csv"):
        if row["noise"] not in levels:
            levels.append(row["noise"])
        for column, name in MATCHING_MEASURES.items():
            key = f"{table}.{row['noise']}.{row['method']}.{name}"
            estimate, interval = row[column].split(" ", 1)
            values.set(key, estimate)
            values.set(key + ".interval", interval)
    for row in read_csv(run / "paired.csv"):
        key = f"{table}.{row['noise']}.{row['method']}.{MATCHING_MEASURES[row['measure']]}"
        values.set(key + ".difference", row["median difference"])
        values.set(key + ".p", row["p (Holm)"])
    for method, timing in read_json(run / "timing.json").items():
        values.set(f"{table}.{method}.time", duration(timing["median_s"]))
    trials = read_csv(run / "trials.csv")
    tour = (run / "config.yaml").read_text().split("\n  tour:\n", 1)[1]
    scans = int(re.search(r"^    scans: (\d+)", tour, re.M).group(1))
    values.set(f"{table}.scans", scans)
    values.set(f"{table}.seeds", len({row["seed"] for row in trials}))
    values.set(f"{table}.unregistered", sum(scans - int(row["registered"]) for row in trials
                                            if row["method"] in ALL_METHODS))
    return levels
