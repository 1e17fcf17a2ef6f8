"""The numbers of the car park."""

import math
import statistics

from runs import read_json
from values import count, digits, duration, percentile, read_csv


def add_garage(values, method, run):
    metrics = read_json(run / "metrics.json")
    residuals = read_csv(run / "residuals.csv")
    key = f"garage.{method}"
    values.set(key + ".registered", metrics["registered"])
    values.set(key + ".alignments", metrics["alignments"])
    values.set(key + ".overlapping", metrics["overlapping_pairs"])
    timing = read_json(run / "timing.json")
    values.set(key + ".time", duration(sum(timing["match_s"]) + timing["finish_s"]))
    for when in ("before", "after"):
        plane = [100 * float(r[f"plane_median_{when}_m"]) for r in residuals]
        values.set(f"{key}.{when}.median", digits(statistics.median(plane), 2))
        values.set(f"{key}.{when}.p90", digits(percentile(plane, 0.9), 2))
        values.set(f"{key}.{when}.worst", digits(max(plane), 2))
    far = [100 * float(r["plane_median_after_m"]) for r in residuals if int(r["data"]) - int(r["model"]) >= 5]
    values.set(f"{key}.median_far", digits(statistics.median(far), 3))


def add_garage_neighbours(values, run):
    """Residuals of each scan to the one before."""
    for r in read_csv(run / "residuals.csv"):
        model, data = int(r["model"]), int(r["data"])
        if data != model + 1:
            continue
        values.set(f"garage.step{data}.pairs", count(int(r["pairs_after"])))
        for when in ("before", "after"):
            values.set(f"garage.step{data}.{when}", f"{100 * float(r[f'plane_median_{when}_m']):.1f}")
    for row in read_csv(run / "scans.csv"):
        if int(row["scan"]) > 0:
            values.set(f"garage.step{row['scan']}.moved.cm", f"{100 * float(row['moved_m']):.1f}")
            values.set(f"garage.step{row['scan']}.moved.deg", f"{math.degrees(float(row['moved_rad'])):.2f}")


def read_trajectory(run):
    return [[float(n) for n in line.split()[1:]] for line in (run / "trajectory.tum").read_text().splitlines()
            if not line.startswith("#")]


def last_position(run):
    return read_trajectory(run)[-1][:3]


def add_garage_differences(values, runs):
    for method in ("metascan", "simultaneous"):
        values.set(f"garage.{method}.last.mm",
                   digits(1e3 * math.dist(last_position(runs[method]), last_position(runs["pairwise"])), 2))
    path = read_trajectory(runs["simultaneous"])
    values.set("garage.path.m", digits(sum(math.dist(a[:3], b[:3]) for a, b in zip(path, path[1:])), 2))
    values.set("garage.climb.cm", digits(100 * (path[-1][2] - path[0][2]), 2))
    values.set("garage.tilt.deg", digits(math.degrees(2 * math.hypot(path[-1][3], path[-1][4])), 2))
    residuals = read_csv(runs["simultaneous"] / "residuals.csv")
    for name, least, most in (("near", 1, 1), ("middle", 2, 4), ("far", 5, 99)):
        plane = [100 * float(r["plane_median_after_m"]) for r in residuals
                 if least <= int(r["data"]) - int(r["model"]) <= most]
        values.set(f"garage.{name}.cm", digits(statistics.median(plane), 2))
