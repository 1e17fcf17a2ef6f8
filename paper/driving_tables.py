"""The tables of driving, missions and devices, from those of their runs."""

import re

from tables import tabular
from values import read_csv

CONTROLLERS = {"indiveri": "the law", "turn_first": "turn, the law", "turn_straight_turn": "turn, straight, turn",
               "pure_pursuit": "path, pure pursuit", "indiveri, many": "the law, many starts"}
WORLDS = {"robobench": "laboratory", "entrance_hall": "entrance hall"}


def grouped(number):
    """Thousands apart."""
    return f"{int(number):,}".replace(",", r"\,")


def control(run):
    """Medians and 95 % of the ways, by controller."""
    rows = [[CONTROLLERS[r["controller"]], grouped(r["starts"]), f"{float(r['at goal %']):g}", f"{float(r['way / line']):.2f}",
             f"{float(r['95 %']):.2f}", f"{float(r['time s']):.1f}", f"{float(r['worst mm']):.1f}",
             f"{float(r['1/m at 0.5 m']):.2f}", f"{float(r['1/m at 5 cm']):.2f}"]
            for r in read_csv(run / "controllers.csv")]
    head = [r"& & at goal & \multicolumn{2}{c}{way over line} & time & worst & \multicolumn{2}{c}{curvature at} \\",
            r"\cmidrule(lr){4-5}\cmidrule(l){8-9}",
            r"behaviour & starts & [\%] & median & 95\,\% & [s] & [mm] & 50\,cm & 5\,cm \\"]
    return tabular("@{}lrrrrrrrr@{}", head, [rows])


def persons(run):
    rows = [[r["robot"], grouped(r["episodes"]), r["reached %"], r["contacts"], r["needless"], r["foreseeable"],
             r["given up"], r["time s"]]
            for r in read_csv(run / "persons.csv")]
    head = [r"& drives & reached [\%] & contacts & needless & foreseeable & given up & time [s] \\"]
    return tabular("@{}lrrrrrrr@{}", head, [rows])


def missions(run):
    """World by world; where a value has a worst run, it stands behind the median."""
    groups = {}
    for r in read_csv(run / "worlds.csv"):
        rows = groups.setdefault(r["world"], [])
        rows.append([WORLDS.get(r["world"], plain(r["world"])) if not rows else "", mission(r["mission"]), r["runs"],
                     whole(r["scans"]), r["way m"], whole(r["minutes"]), r["surface %"] + worst(r["least surface %"]),
                     r["position cm"] + worst(r["worst cm"]), r["map mm"], r["refused"], r["given up"],
                     r["collisions"], whole(r["ended %"])])
    head = [r"& & & & way & time & surface & position & map & \multicolumn{3}{c}{per mission} & ended \\",
            r"\cmidrule(lr){10-12}",
            r"world & mission & runs & scans & [m] & [min] & [\%] & [cm] & [mm] & refused & given up & contacts & [\%] \\"]
    return tabular("@{}llrrrrllrrrrr@{}", head, list(groups.values()))


def devices(run):
    """Means of what differs from the simulated robot, in pairs; what has no scanners beside its wheels stands alone."""
    columns = ("walls %", "surface %", "position mm", "map mm")
    rows = [[mission(r["mission"].split(" - ")[0]), r["pairs"], *(interval(r[c]) for c in columns)]
            for r in read_csv(run / "differences.csv")]
    head = [r"& pairs & walls [\%] & surface [\%] & positions [mm] & map [mm] \\"]
    return tabular("@{}lrllll@{}", head, [rows])


def plain(name):
    return name.replace("_", " ")


def mission(name):
    return plain(name).replace(" x ", r" $\times$\,").replace("default", "as configured")


def worst(text):
    return rf" {{\scriptsize ({text})}}"


def whole(text):
    """Without decimals, where a median has some."""
    return text if text == "-" else f"{float(text):.0f}"


def interval(text):
    """"+1.2 [-3.0, +4.1]" with the signs of mathematics, its interval small."""
    estimate, rest = re.sub(r"([+-])(\d)", r"$\1$\2", text).split(" ", 1)
    return rf"{estimate} {{\scriptsize {rest}}}"
