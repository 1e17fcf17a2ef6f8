"""The numbers of the sections on driving, missions and devices."""

import math

from values import count, digits, read_csv

SURFACE_GOAL = 0.97  # share of what can be seen
POSITION_GOAL = 0.05  # [m], rms
MAP_GOAL = 0.02  # [m], median


def add_control(values, run):
    """Of the many starts of the paper's controller, and how fast the curvature falls with its gains."""
    row = next(r for r in read_csv(run / "controllers.csv") if r["controller"] == "indiveri, many")
    values.set("control.many.starts", count(int(row["starts"])))
    for key, column in (("at_goal", "at goal %"), ("detour", "way / line"), ("detour95", "95 %"),
                        ("worst_mm", "worst mm"), ("worst_deg", "worst deg"), ("far", "1/m at 0.5 m"),
                        ("near", "1/m at 5 cm"), ("violations", "violations")):
        values.set(f"control.many.{key}", f"{float(row[column]):g}")
    h, beta = (float(values.texts[f"control.approach.law.{gain}"]) for gain in ("h", "beta"))
    values.set("control.exponent", digits(slowest_decay(h, beta) - 1, 2))


def slowest_decay(h, beta):
    """Of alpha and theta near the goal, as a power of the distance: of lambda^2 - beta lambda + h = 0."""
    discriminant = beta * beta - 4 * h
    return 0.5 * (beta - math.sqrt(discriminant)) if discriminant > 0 else 0.5 * beta


def add_persons(values, run):
    looks, blind = read_csv(run / "persons.csv")
    values.set("persons.count", count(int(looks["episodes"])))
    for name, row in (("looks", looks), ("blind", blind)):
        values.set(f"persons.{name}.reached", row["reached %"])
        values.set(f"persons.{name}.contacts", row["contacts"])
        values.set(f"persons.{name}.needless", row["needless"])
        values.set(f"persons.{name}.foreseeable", row["foreseeable"])


def add_missions(values, run):
    """What came of the missions as configured, held to what they should reach; and of those of 2003."""
    trials = read_csv(run / "trials.csv")
    for key, way in (("default", "default"), ("2003", "2003")):
        own = [t for t in trials if t["way"] == way]
        number = lambda column: [float(t[column]) for t in own]
        values.set(f"missions.{key}.runs", len(own))
        values.set(f"missions.{key}.ended", sum(t["end"].startswith("nothing is left") for t in own))
        values.set(f"missions.{key}.untouched", sum(c == 0 for c in number("collisions")))
        values.set(f"missions.{key}.contacts", f"{sum(number('collisions')):.0f}")
        values.set(f"missions.{key}.covering", sum(s >= SURFACE_GOAL for s in number("surface_covered")))
        values.set(f"missions.{key}.straight", sum(p <= POSITION_GOAL for p in number("translation_rms_m")))
        values.set(f"missions.{key}.sharp", sum(e <= MAP_GOAL for e in number("map_error_median_m")))
        values.set(f"missions.{key}.surface.low", f"{100 * min(number('surface_covered')):.1f}")
        values.set(f"missions.{key}.surface.high", f"{100 * max(number('surface_covered')):.1f}")
        values.set(f"missions.{key}.position.high", f"{100 * max(number('translation_rms_m')):.1f}")
        values.set(f"missions.{key}.map.high", f"{1000 * max(number('map_error_median_m')):.1f}")
    values.set("missions.goal.surface", f"{100 * SURFACE_GOAL:.0f}")
    values.set("missions.goal.position", f"{100 * POSITION_GOAL:.0f}")
    values.set("missions.goal.map", f"{100 * MAP_GOAL:.0f}")


def add_planning_time(values, name, run):
    """Of the usual number of candidates and edges, which is measured first."""
    row = next(r for r in read_csv(run / "timing.csv") if r["what"] == "whole decision")
    for key, column in (("candidates", "candidates"), ("edges", "edges"), ("decisions", "decisions")):
        values.set(f"{name}.{key}", count(int(row[column])))
    values.set(f"{name}.median", digits(float(row["median ms"]), 3))
    values.set(f"{name}.late", digits(float(row["99 % ms"]), 3))
