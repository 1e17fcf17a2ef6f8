"""The numbers of pose graphs."""

import re

from runs import read_json
from values import count, duration, read_csv


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
