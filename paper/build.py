#!/usr/bin/python3
"""Builds paper/build/paper.pdf: runs the experiments, takes the numbers out of them, calls LaTeX.

paper/build.py PROGRAM [--fresh]    --fresh runs again what is up to date
"""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

import driving_tables
import driving_values
import figure_values
import garage_values
import graph_values
import hallway_values
import matching_values
import plots
import png
import tables
import values as v
import view_plots
import view_values
from runs import Experiments, RunError, read_json

PAPER = pathlib.Path(__file__).resolve().parent
BUILD = PAPER / "build"
METHODS = ("pairwise", "metascan", "simultaneous")  # of 2003
SEEDS = range(1, 21)
MISSION_SETS = ("seeds=2",)  # of ten: a mission takes minutes
NO_OUTPUT = ("output.map=false", "output.figures=false")

# The variants of the office: key, config, assignments.
VARIANTS = (
    [(f"slices_point_{m}", "register_2003", (f"registration.method={m}",)) for m in METHODS] +
    [("slices_gicp", "register_2003", ("icp.metric=plane_to_plane",)),
     ("voxel_point", "register_2003", ("reduce.method=voxel_mean",)),
     ("voxel_point_robust", "register_office", ("icp.metric=point_to_point",)),
     ("voxel_plane", "register_office", ("icp.metric=point_to_plane",))] +
    [(f"voxel_gicp_{m}", "register_office", (f"registration.method={m}",)) for m in METHODS])

STRIPS = [
    ("odometry", plots.GRAY, "odometry"),
    ("reduced points of 2003, point-to-point", None, None),
    ("pairwise", plots.BLUE, "slices_point_pairwise"),
    ("metascan", plots.BLUE, "slices_point_metascan"),
    ("simultaneous", plots.BLUE, "slices_point_simultaneous"),
    ("one thing changed, simultaneous", None, None),
    ("2003, plane-to-plane", plots.ORANGE, "slices_gicp"),
    ("2003, on voxel means", plots.ORANGE, "voxel_point"),
    ("default, point-to-point", plots.ORANGE, "voxel_point_robust"),
    ("default, point-to-plane", plots.ORANGE, "voxel_plane"),
    ("default: voxel means, plane-to-plane", None, None),
    ("pairwise", plots.GREEN, "voxel_gicp_pairwise"),
    ("metascan", plots.GREEN, "voxel_gicp_metascan"),
    ("simultaneous", plots.GREEN, "voxel_gicp_simultaneous"),
]


def say(text):
    print(text, flush=True)


def fail(text):
    sys.exit(f"paper/build.py: {text}")


def office(values, published_seconds, experiments):
    """What needs no files."""
    say("the built-in office: Table 1, Fig. 3, Fig. 5, the map")
    table = experiments.run("table_1")
    figure_values.add_table(values, "office", published_seconds, table)
    v.add_options(values, "table", table)
    fig_03 = experiments.run("fig_03")
    figure_values.add_fig_03(values, "fig3.office", fig_03)
    v.add_options(values, "fig3", fig_03)
    for view in ("top", "oblique"):
        png.write(BUILD / f"fig_03_{view}.png", png.bolder(png.read(fig_03 / "figures" / f"{view}.png")))
    stacked_parts(values, "fig_03_top", 3, gap=12)  # half of the program's, as the picture
    figure_values.add_fig_05(values, "fig5.office", copy_fig_05(experiments.run("fig_05"), "fig_05"))
    office = experiments.run("register_office")
    make_readme_picture(office)
    v.add_options(values, "default", office)
    v.add_options(values, "faithful", experiments.run("register_2003"))
    metrics = read_json(office / "metrics.json")
    values.set("office.scans", metrics["scans"])
    values.set("processor", read_json(office / "manifest.json")["processor"])


def office_truth(values, experiments):
    say(f"the built-in office against the truth: {len(VARIANTS)} variants, {len(SEEDS)} seeds")
    def job(config, name, seed, sets):
        return (config, f"seeds/{name}/{seed}", (*NO_OUTPUT, f"input.office.seed={seed}", *sets))
    runs = {key: experiments.run_all([job(config, key, seed, sets) for seed in SEEDS])
            for key, config, sets in VARIANTS}
    errors = {key: (matching_values.errors_cm(r), matching_values.errors_deg(r)) for key, r in runs.items()}
    last = runs[VARIANTS[-1][0]]
    errors["odometry"] = (matching_values.errors_cm(last, "odometry"), matching_values.errors_deg(last, "odometry"))
    for key, (cm, deg) in errors.items():
        matching_values.add_errors(values, f"truth.{key}", cm, deg)
    values.set("truth.seeds", len(SEEDS))
    values.set("truth.unregistered", sum(
        m["scans"] - m["registered"] for r in runs.values() for m in (read_json(x / "metrics.json") for x in r)))
    plots.strips(BUILD / "plot_truth.tex",
                 [(label, color, errors[key][0] if key else None) for label, color, key in STRIPS],
                 -1.3, 2.0, "error of the positions, rms [cm]")
    for metric in v.METRICS:
        two = ("registration.method=pairwise", "input.last=1", f"icp.metric={metric}")
        matching_values.add_covariance(values, metric,
                         experiments.run_all([job("register_office", f"two_{metric}", seed, two) for seed in SEEDS]))


def hallway(values, published_seconds, published, experiments):
    say("the real hallway: Table 1 (brute force takes minutes), cross-check")
    figure_values.add_table(values, "hallway", published_seconds, experiments.run("table_1_hallway"))
    figure_values.add_fig_05(values, "fig5.hallway", copy_fig_05(experiments.run("fig_05_hallway"), "fig_05_hallway"))
    wide = {metric: experiments.run("hallway_cross_check", f"hallway_cross_check/{metric}",
                                    (f"icp.metric={metric}",)) for metric in v.METRICS}
    narrow = experiments.run("hallway_cross_check", "hallway_cross_check/narrow", ("icp.max_distance=0.25",))
    hallway_values.add_cross_check(values, published, wide, narrow)
    labels = ("point-to-point", "point-to-plane", "plane-to-plane")
    colors = (plots.BLUE, plots.ORANGE, plots.GREEN)
    plots.convergence(BUILD / "plot_convergence.tex",
                      [(label, color, hallway_values.step_lengths(wide[metric], 0))
                       for label, color, metric in zip(labels, colors, v.METRICS)])


def garage(values, experiments):
    say("the real car park: three methods")
    runs = {method: experiments.run(f"garage13_{method}") for method in matching_values.ALL_METHODS}
    for method, run in runs.items():
        garage_values.add_garage(values, method, run)
    garage_values.add_garage_neighbours(values, runs["simultaneous"])
    garage_values.add_garage_differences(values, runs)
    for when in ("before", "after"):
        copy_map(runs["simultaneous"] / "figures" / f"top_{when}.png", BUILD / f"garage_{when}.png")


def corridor(values, experiments):
    say("the simulated corridor: Fig. 4, matching over many tours (takes a quarter of an hour)")
    fig_04 = experiments.run("fig_04")
    shutil.copyfile(fig_04 / "figures" / "fig_04.png", BUILD / "fig_04.png")
    stacked_parts(values, "fig_04", 7, gap=24)
    v.add_options(values, "fig4", fig_04)
    matching(values, "matching", experiments.run("ablation_matching"))


def features(values, real_data, experiments):
    say("lines, surfaces, objects and the octree: Fig. 2, Fig. 11, the detectors")
    fig_02, fig_11 = experiments.run("fig_02"), experiments.run("fig_11")
    for run, name in ((fig_02, "distorted"), (fig_02, "fig_02"), (fig_11, "fig_11")):
        shutil.copyfile(run / "figures" / f"{name}.png", BUILD / f"{name}.png")
    v.add_metrics(values, "fig2", fig_02)
    v.add_metrics(values, "fig11", fig_11)
    run = experiments.run("ablation_features")
    v.add_options(values, "features", run)
    for name in ("lines", "surfaces") + (("logs",) if real_data else ()):
        (BUILD / f"table_{name}.tex").write_text(tables.features(v.read_csv(run / f"{name}.csv"), name))


def views(values, experiments):
    say("next best views on all floor plans (takes an hour)")
    for name in ("fig_06", "fig_07"):
        shutil.copyfile(experiments.run(name) / "figures" / f"{name}.png", BUILD / f"{name}.png")
    run = experiments.run("ablation_nbv", sets=("studies=policies, samplers, ways", "seeds=4", "study_seeds=2"))
    v.add_options(values, "nbv", run)
    view_values.add_views(values, "nbv", run)
    (BUILD / "table_nbv.tex").write_text(tables.views(v.read_csv(run / "policies.csv")))
    view_plots.coverage(BUILD / "plot_by_scans.tex", run, "covered_by_scans", "scans / fewest")
    view_plots.coverage(BUILD / "plot_by_way.tex", run, "covered_by_way", "way / tour")
    view_plots.names(BUILD / "plot_policies.tex")
    driving_values.add_planning_time(values, "planning", experiments.run("planning_time"))


def driving(values, experiments):
    say("control and missions (takes hours: whole missions in two buildings, in each way)")
    runs = {name: experiments.run(name) for name in ("fig_08", "fig_09", "fig_10", "fig_12", "fig_13")}
    for name, run in runs.items():
        for picture in (run / "figures").glob("fig_*.png"):
            shutil.copyfile(picture, BUILD / picture.name)
    v.add_options(values, "fig9", runs["fig_09"])
    v.add_metrics(values, "fig12", runs["fig_12"])
    v.add_metrics(values, "fig13", runs["fig_13"])
    for key, config, sets in (("control", "ablation_control", ()), ("persons", "walking_persons", ()),
                              ("missions", "ablation_mission", MISSION_SETS)):
        run = experiments.run(config, sets=sets)
        v.add_options(values, key, run)
        getattr(driving_values, f"add_{key}")(values, run)
        (BUILD / f"table_{key}.tex").write_text(getattr(driving_tables, key)(run))


def devices(values, experiments):
    say("emulated devices against the simulated robot")
    run = experiments.run("emulated_robot")
    v.add_options(values, "devices", run)
    (BUILD / "table_devices.tex").write_text(driving_tables.devices(run))


def loop(values, experiments):
    say("matching on a simulated loop over many tours (takes a quarter of an hour)")
    matching(values, "loop", experiments.run("ablation_matching_loop"))


def matching(values, key, run):
    levels = matching_values.add_matching(values, key, run)
    (BUILD / f"table_{key}.tex").write_text(
        tables.matching(key, levels, matching_values.MATCHING_METHODS, matching_values.MATCHING_MEASURES.values()))


def graphs(values, real_data, experiments):
    say("pose graphs: the public ones, wrong closures, starts")
    if real_data:
        names = graph_values.add_posegraphs(values, experiments.run("posegraph_benchmark"))
        (BUILD / "table_posegraphs.tex").write_text(tables.posegraphs(names))
    shares, kernels = graph_values.add_ablation_graph(values, experiments.run("ablation_graph"))
    (BUILD / "table_kernels.tex").write_text(tables.kernels([s for s in ("0", "10", "30", "50") if s in shares], kernels))


def copy_fig_05(run, name):
    """Copies the picture of a run, for a smaller print; returns the run."""
    png.write(BUILD / f"{name}.png", png.bolder(png.read(run / "figures" / "fig_05.png")))
    return run


def copy_map(source, target):
    """A top view without title and legend: the caption says what they say."""
    png.write(target, png.without_legend(png.read(source), with_title=False))


def make_readme_picture(run):
    pictures = [png.halved(png.without_legend(png.read(run / "figures" / f"top_{when}.png"), with_title=True))
                for when in ("before", "after")]
    png.write_palette(PAPER / "readme_map.png", png.beside(*pictures, gap=24))


def stacked_parts(values, name, count, gap):
    """Where the pictures are that stand one above the other in a file, for LaTeX to set them side by side."""
    width, height = png.size(BUILD / f"{name}.png")
    part = (height - (count - 1) * gap) / count
    for k in range(count):
        top = height - k * (part + gap)
        values.set(f"part.{name}.{k + 1}", f"0 {top - part:.1f} {width} {top:.1f}")


def write_tables(real_data):
    (BUILD / "table_cost.tex").write_text(tables.cost(real_data))
    (BUILD / "table_options.tex").write_text(tables.options())
    (BUILD / "table_covariance.tex").write_text(tables.covariance())
    if real_data:
        (BUILD / "table_cross_check.tex").write_text(tables.cross_check())
        (BUILD / "table_metrics.tex").write_text(tables.metrics())
        (BUILD / "table_garage.tex").write_text(tables.garage())
        (BUILD / "table_garage_steps.tex").write_text(tables.garage_steps(13))


def first_latex_error(log):
    """The first error, with the lines that follow it, or nothing."""
    lines = log.splitlines()
    for i, line in enumerate(lines):
        if line.startswith("!") or re.match(r"\S+:\d+: ", line):
            return "\n".join(lines[i:i + 4])
    return None


def latex(command):
    environment = dict(os.environ, TEXINPUTS=f"{PAPER}:{PAPER}/sections:", BIBINPUTS=f"{PAPER}:",
                       max_print_line="1000")
    finished = subprocess.run(command, cwd=BUILD, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
    return finished.returncode, finished.stdout.decode(errors="replace")


def build_pdf():
    if not shutil.which("pdflatex"):
        fail("pdflatex is missing; ./dev paper installs it")
    pdflatex = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "-file-line-error", "paper.tex"]
    for command in (pdflatex, ["bibtex", "paper"], pdflatex, pdflatex):
        status, output = latex(command)
        if status != 0:
            fail(f"{command[0]}: {first_latex_error(output) or output[-500:]}\nall of it: paper/build/paper.log")
    for warning in re.findall(r"LaTeX Warning: (?:Reference|Citation).*undefined.*", output):
        fail(warning)


def main():
    parser = argparse.ArgumentParser(description="Build paper/build/paper.pdf.")
    parser.add_argument("program", help="build/release/ariadne")
    parser.add_argument("--fresh", action="store_true", help="run again what is up to date")
    arguments = parser.parse_args()
    program = pathlib.Path(arguments.program).resolve()
    if not program.is_file():
        fail(f"there is no program {arguments.program}; ./dev build makes it")
    data = pathlib.Path(os.environ.get("ARIADNE_DATA", PAPER.parent.parent / "shared" / "data"))
    real_data = (data / "scans" / "hallway").is_dir() and (data / "scans" / "garage13").is_dir()
    BUILD.mkdir(exist_ok=True)
    if os.getloadavg()[0] > os.cpu_count():
        say("the machine is busy: times that are measured now will be too long (--fresh measures them again)")
    values = v.Values()
    published = read_json(PAPER / "published.json")
    figure_values.add_published_table(values, published)
    published_seconds = published["table_1"]["rows"][-1]["seconds"]
    try:
        experiments = Experiments(PAPER.parent, program, data.resolve(), BUILD / "runs.json", arguments.fresh)
        try:
            office(values, published_seconds, experiments)
            if real_data:
                hallway(values, published_seconds, published, experiments)
                garage(values, experiments)
            else:
                say(f"no data sets in {data}: the paper says so in place of their results (set ARIADNE_DATA)")
            office_truth(values, experiments)
            features(values, real_data, experiments)
            corridor(values, experiments)
            if real_data:
                loop(values, experiments)
            graphs(values, real_data, experiments)
            if real_data:
                views(values, experiments)
            driving(values, experiments)
            devices(values, experiments)
        finally:
            experiments.save_records()
    except RunError as error:
        fail(str(error))
    say(f"{len(experiments.used)} runs, {experiments.made} of them made now")
    values.write(BUILD / "numbers.tex", real_data)
    write_tables(real_data)
    shutil.copyfile(PAPER / "paper.tex", BUILD / "paper.tex")
    build_pdf()
    say("paper/build/paper.pdf")


if __name__ == "__main__":
    main()
