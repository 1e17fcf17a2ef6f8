"""The numbers of the hallway, digit by digit beside those of another program."""

import math

from runs import read_json
from values import count, digits, duration, read_csv, signed, standard_deviation


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
