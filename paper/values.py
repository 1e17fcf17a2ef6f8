"""The numbers of the text, taken from run directories. Each is a LaTeX macro: \\val{key}."""

import csv
import math
import re
import statistics

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


# --- Table 1

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


# --- Figures 3 and 5

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


def add_metrics(values, name, run):
    """The counts of a run."""
    for key, value in read_json(run / "metrics.json").items():
        values.set(f"{name}.{key}", count(value))


# --- The hallway, digit by digit

def read_frame(run, scan):
    """The pose of a scan, in the uos convention: rotation by rows, translation [cm]."""
    numbers = [float(n) for n in
               (run / "scans" / f"scan{scan:03}.frames").read_text().split("\n")[-2].split()]
    return [[numbers[4 * column + row] for column in range(3)] for row in range(3)], numbers[12:15]


def relative_pose(run, scan):
    """Of a scan in the frame of the one before: translation [cm], Euler angles [deg], rotation."""
    (A, a), (B, b) = read_frame(run, scan - 1), read_frame(run, scan)
    R = [[sum(A[k][i] * B[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
    t = [sum(A[k][i] * (b[k] - a[k]) for k in range(3)) for i in range(3)]
    euler = (math.atan2(-R[1][2], R[2][2]), math.asin(R[0][2]), math.atan2(-R[0][1], R[0][0]))
    return t, [math.degrees(angle) for angle in euler], R


def rotation_between(A, B):
    trace = sum(A[i][j] * B[i][j] for i in range(3) for j in range(3))
    return math.degrees(math.acos(max(-1.0, min(1.0, 0.5 * (trace - 1.0)))))


def standard_deviation(covariance, axes):
    return math.sqrt(sum(float(covariance[f"{axis}_{axis}"]) for axis in axes))


def add_cross_check(values, published, wide, narrow):
    """wide: the run of each metric with a gate of 0.5 m; narrow: point-to-point with half of it."""
    worst_cm = worst_deg = 0.0
    for reference in published["hallway"]["pairs"]:
        run = narrow if reference["key"] == "narrow" else wide["point_to_point"]
        t, euler, _ = relative_pose(run, reference["scan"])
        step = read_csv(run / "steps.csv")[reference["scan"] - 1]
        key = f"hallway.{reference['key']}"
        for axis, ours, theirs in zip("xyz", t, reference["translation_cm"]):
            worst_cm = max(worst_cm, abs(ours - theirs))
            values.set(f"{key}.t{axis}", signed(ours, 3))
            values.set(f"{key}.reference.t{axis}", signed(theirs, 3))
        for axis, ours, theirs in zip("xyz", euler, reference["euler_deg"]):
            worst_deg = max(worst_deg, abs(ours - theirs))
            values.set(f"{key}.r{axis}", signed(ours, 3))
            values.set(f"{key}.reference.r{axis}", signed(theirs, 3))
        values.set(f"{key}.gate", f"{reference['gate_m']:g}")
        values.set(f"{key}.rms", f"{100 * float(step['rms_m']):.2f}")
        values.set(f"{key}.reference.rms", f"{reference['rms_cm']:.2f}")
        values.set(f"{key}.iterations", step["iterations"])
        values.set(f"{key}.pairs", count(int(step["pairs"])))
    values.set("hallway.narrow.moved.cm", digits(
        math.dist(relative_pose(narrow, 1)[0], relative_pose(wide["point_to_point"], 1)[0]), 2))
    values.set("hallway.worst.cm", f"{worst_cm:.4f}")
    values.set("hallway.worst.deg", f"{worst_deg:.4f}")
    for scan, name in ((1, "first"), (2, "second")):
        t0, _, R0 = relative_pose(wide["point_to_point"], scan)
        for metric, run in wide.items():
            t, _, R = relative_pose(run, scan)
            step, covariance = (read_csv(run / f"{table}.csv")[scan - 1] for table in ("steps", "covariances"))
            key = f"hallway.{name}.{metric}"
            values.set(key + ".iterations", step["iterations"])
            values.set(key + ".time", duration(read_json(run / "timing.json")["match_s"][scan]))
            values.set(key + ".moved.cm", digits(math.dist(t, t0), 2))
            values.set(key + ".moved.deg", digits(rotation_between(R, R0), 2))
            values.set(key + ".sigma.cm", digits(100 * standard_deviation(covariance, "xyz"), 2))
            values.set(key + ".sigma.deg",
                       digits(math.degrees(standard_deviation(covariance, ("rx", "ry", "rz"))), 2))


def step_lengths(run, step):
    """Translations [m] of the iterations of one alignment."""
    return [float(row["step_m"]) for row in read_csv(run / "iterations.csv") if row["step"] == str(step)]


# --- The car park

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


# --- The office against the truth

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


# --- matching over simulated tours

ALL_METHODS = ("pairwise", "metascan", "simultaneous", "graph", "joint")
MATCHING_METHODS = ("odometry", "pairwise", "metascan", "edges", "simultaneous", "graph", "joint", "truth")
MATCHING_MEASURES = {"position cm": "position", "rotation deg": "rotation", "map error cm": "map", "wall cm": "wall",
                     "worst wall cm": "worst"}


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


# --- pose graphs

def add_posegraphs(values, run):
    """The public graphs; returns their names."""
    times = read_json(run / "timing.json")
    names, worst, lost, known = [], 0.0, 0, 0
    for row in read_csv(run / "graphs.csv"):
        name = row["graph"]
        names.append(name)
        key = f"graphs.{name.replace('-', '_')}"
        for column in ("vertices", "edges"):
            values.set(f"{key}.{column}", count(int(row[column])))
        values.set(key + ".optimum", f"{float(row['F']):.6f}")
        values.set(key + ".difference", scientific(row["difference"]))
        values.set(key + ".gap", scientific(row["gap"]))
        values.set(key + ".iterations", row["iterations"])
        information = row["information"]
        values.set(key + ".information", information if information == "unbounded" else f"{float(information):.3f}")
        certified = row["verdict from guess"] == "optimal"
        values.set(key + ".guess", "the same" if certified else f"{float(row['F from guess']):.1f}")
        values.set(key + ".time", duration(times[name]["isotropic_s"]["total"]))
        values.set(key + ".certificate", duration(times[name]["certificate_s"]))
        if row["difference"]:
            known += 1
            worst = max(worst, float(row["difference"]))
            lost += not certified
    values.set("graphs.known", known)
    values.set("graphs.worst", scientific(worst))
    values.set("graphs.lost", lost)
    return names


def scientific(text):
    if text == "":
        return "--"
    mantissa, exponent = f"{float(text):.0e}".split("e")
    return rf"${mantissa}\cdot 10^{{{int(exponent)}}}$"


def add_ablation_graph(values, run):
    """Kernels against wrong closures, and starts; returns the shares and the kernels."""
    shares, kernels = [], []
    for row in read_csv(run / "kernels.csv"):
        share, kernel = row["wrong %"].removesuffix(".0"), row["kernel"]
        if share not in shares:
            shares.append(share)
        if kernel not in kernels:
            kernels.append(kernel)
        key = f"kernels.{share}.{kernel}"
        estimate, interval = row["position cm"].split(" ", 1)
        values.set(key + ".position", estimate)
        values.set(key + ".interval", interval)
        values.set(key + ".within", row["within 2x %"])
    for row in read_csv(run / "starts.csv"):
        key = f"starts.{row['noise']}.{row['start']}"
        values.set(key + ".certified", row["certified %"])
        values.set(key + ".nees", row["mean NEES"])
        values.set(key + ".band", row["95 % band"])
    for key, pattern in (("seeds", r"^seeds: (\d+)"), ("poses", r"^  poses: (\d+)")):
        values.set(f"ablation_graph.{key}", re.search(pattern, (run / "config.yaml").read_text(), re.M).group(1))
    return shares, kernels
