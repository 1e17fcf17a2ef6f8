#!/usr/bin/python3
"""Runs the benchmark programs one after the other and prints the medians as ratios.

run.py FOLDER_OF_PROGRAMS [FILTER]

Times are only comparable within one run, and only on an otherwise idle machine; the load is printed.
"""

import json
import os
import subprocess
import sys
import tempfile

PROGRAMS = ["bench_ariadne", "bench_pcl", "bench_open3d", "bench_io", "bench_simulated", "bench_graph",
            "bench_extract", "bench_octree", "bench_view"]
REPETITIONS = 5

# (what, numerator, denominator, goal)
RATIOS = [
    ("plain nanoflann loop / Align, reduced points, 1 thread",
     "point_to_point/plain_loop/reduced/threads:1", "point_to_point/ariadne/reduced/threads:1", 2.0),
    ("plain nanoflann loop / Align, all points, 1 thread",
     "point_to_point/plain_loop/all/threads:1", "point_to_point/ariadne/all/threads:1", 2.0),
    ("the same with covariance and observability, reduced points",
     "point_to_point/plain_loop/reduced/threads:1", "point_to_point/ariadne_assessed/reduced/threads:1", None),
    ("the same with covariance and observability, all points",
     "point_to_point/plain_loop/all/threads:1", "point_to_point/ariadne_assessed/all/threads:1", None),
    ("Align with 1 thread / with 2, reduced points",
     "point_to_point/ariadne/reduced/threads:1", "point_to_point/ariadne/reduced/threads:2", 1.7),
    ("Align with 1 thread / with 2, all points",
     "point_to_point/ariadne/all/threads:1", "point_to_point/ariadne/all/threads:2", 1.7),
    ("PCL / Align, reduced points", "point_to_point/pcl/reduced/threads:1",
     "point_to_point/ariadne/reduced/threads:1", 8.0),
    ("PCL / Align, all points", "point_to_point/pcl/all/threads:1", "point_to_point/ariadne/all/threads:1", 8.0),
    ("Open3D / Align, reduced points", "point_to_point/open3d/reduced/threads:1",
     "point_to_point/ariadne/reduced/threads:1", 4.0),
    ("Open3D / Align, all points", "point_to_point/open3d/all/threads:1",
     "point_to_point/ariadne/all/threads:1", 4.0),
    ("PCL GICP / plane_to_plane, reduced points, whole",
     "plane_to_plane/pcl/reduced/threads:1", "plane_to_plane/ariadne/reduced/threads:1", None),
    ("brute force / k-d tree, one search of all pairs, reduced points",
     "pairs/brute_force/reduced", "pairs/kd_tree/reduced", None),
    ("PCL voxel grid / voxel_mean", "reduce/voxel_mean_pcl/all", "reduce/voxel_mean/all", None),
    ("Open3D voxel grid / voxel_mean", "reduce/voxel_mean_open3d/all", "reduce/voxel_mean/all", None),
]

OCTREES = [("octomap", "octomap, end points only, lazily"), ("pcl_search", "PCL's octree of indices"),
           ("pcl_centroids", "PCL's octree of centroids")]
RATIOS += [(f"{what} / Octree, time to build", f"octree/build/{peer}", "octree/build/ariadne", 1.0)
           for peer, what in OCTREES]
RATIOS += [("plain loop over rays and edges / planning of the next view, 200 candidates, 1000 edges",
            "view/plain_loop/candidates:200/edges:1000", "view/plan/candidates:200/edges:1000", None)]

GRAPHS = ["sphere2500", "torus3D", "cubicle", "parking-garage", "smallGrid3D", "kitti_00", "intel", "MIT", "manhattan"]
RATIOS += [(f"{what} / own, {graph}", f"graph/{graph}/{peer}", f"graph/{graph}/ariadne", 1.0)
           for what, peer in [("Ceres tuned", "ceres_suite_sparse"), ("Ceres tuned, EIGEN_SPARSE", "ceres_eigen"),
                              ("Ceres tuned, CX_SPARSE", "ceres_cxsparse"),
                              ("Ceres tuned but for the radius", "ceres_default_radius"),
                              ("Ceres as in tutorials", "ceres_stock")]
           for graph in GRAPHS]

# (what, numerator, denominator, what it may be at most)
LIMITS = [(f"whole optimization / its factorizations alone, {graph}", f"graph/{graph}/ariadne", f"graph/{graph}/floor",
           1.4) for graph in GRAPHS]
LIMITS += [(f"certificate / optimization, {graph}", f"graph/{graph}/certificate", f"graph/{graph}/ariadne", 2.0)
           for graph in GRAPHS]
LIMITS += [(f"{kind} factor of 100000 pairs / of 10", f"factor/{kind}/pairs:100000", f"factor/{kind}/pairs:10", 1.2)
           for kind in ["point", "plane"]]

# (what, numerator, denominator, goal); of bytes per point
MEMORY = [(f"{what} / Octree, bytes per point", f"octree/build/{peer}", "octree/build/ariadne", 1.0)
          for peer, what in OCTREES]

# (what, benchmark, goal); how many in a second
RATES = [
    ("simulated AIS scans of 181 x 256 points with all noise, 1 thread", "simulated/scan/threads:1", None),
    ("simulated AIS scans of 181 x 256 points with all noise, 2 threads", "simulated/scan/threads:2", 10.0),
    ("plain ray casts, 1 thread", "simulated/rays/threads:1", None),
    ("plain ray casts, 2 threads", "simulated/rays/threads:2", None),
]


def measure(program, name_filter):
    """Medians by name, and the context, of one benchmark program."""
    with tempfile.NamedTemporaryFile(suffix=".json") as out:
        environment = dict(os.environ, OMP_NUM_THREADS="1")
        subprocess.run([program, f"--benchmark_out={out.name}", f"--benchmark_repetitions={REPETITIONS}",
                        "--benchmark_report_aggregates_only=true", f"--benchmark_filter={name_filter}"],
                       check=True, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        text = out.read() or b"{}"
    result = json.loads(text)
    medians = {b["run_name"].removesuffix("/real_time"): b
               for b in result.get("benchmarks", []) if b.get("aggregate_name") == "median"}
    return medians, result.get("context", {})


def print_medians(medians):
    print(f"\n{'median':>12}  benchmark")
    for name, b in medians.items():
        rate = f"  {b['bytes_per_second'] / 1e6:8.0f} MB/s" if "bytes_per_second" in b else ""
        iterations = f"  {b['icp_iterations']:.0f} iterations" if "icp_iterations" in b else ""
        memory = f"  {b['bytes_per_point']:.1f} B/point" if "bytes_per_point" in b else ""
        peak = f"  {b['peak_MB']:.0f} MB at most" if "peak_MB" in b else ""
        steps = f"  {b['factorizations']:.0f} factorizations" if "factorizations" in b else ""
        print(f"{b['real_time']:9.3f} {b['time_unit']}  {name}{rate}{iterations}{memory}{peak}{steps}")


def nanoseconds(benchmark):
    return benchmark["real_time"] * {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}[benchmark["time_unit"]]


def print_ratios(medians):
    """Returns how many goals are missed."""
    print(f"\n{'ratio':>8}  {'goal':>6}  what")
    missed = 0
    for sign, rows in [(">=", RATIOS), ("<=", LIMITS)]:
        for what, numerator, denominator, goal in rows:
            if numerator not in medians or denominator not in medians:
                continue
            ratio = nanoseconds(medians[numerator]) / nanoseconds(medians[denominator])
            reached = goal is None or (ratio >= goal if sign == ">=" else ratio <= goal)
            missed += not reached
            print(f"{ratio:8.2f}  {'' if goal is None else f'{sign} {goal}':>6}  {what}{'' if reached else '  MISSED'}")
    return missed


def print_memory(medians):
    """Returns how many goals are missed."""
    missed = 0
    for what, numerator, denominator, goal in MEMORY:
        if numerator not in medians or denominator not in medians:
            continue
        ratio = medians[numerator]["bytes_per_point"] / medians[denominator]["bytes_per_point"]
        missed += ratio < goal
        print(f"{ratio:8.2f}  {f'>= {goal}':>6}  {what}{'' if ratio >= goal else '  MISSED'}")
    return missed


def print_rates(medians):
    """Returns how many goals are missed."""
    print(f"\n{'1/s':>12}  {'goal':>6}  what")
    missed = 0
    for what, name, goal in RATES:
        if name not in medians:
            continue
        rate = medians[name]["items_per_second"]
        mark = "" if goal is None or rate >= goal else "  MISSED"
        missed += bool(mark)
        print(f"{rate:12.1f}  {'' if goal is None else f'>= {goal:g}':>6}  {what}{mark}")
    return missed


def main():
    folder = sys.argv[1]
    name_filter = (sys.argv[2] if len(sys.argv) > 2 else "") or "."
    print(f"load before: {os.getloadavg()[0]:.2f}")
    medians, data, world, graphs = {}, "?", "?", "?"
    for name in PROGRAMS:
        program = os.path.join(folder, name)
        if not os.path.exists(program):
            print(f"{name} is not built: the library is not installed")
            continue
        print(f"running {name} ...", flush=True)
        found, context = measure(program, name_filter)
        medians.update(found)
        data = context.get("data", data)
        world = context.get("world", world)
        graphs = context.get("graphs", graphs)
    print(f"data: {data}; world: {world}; graphs: {graphs}; medians of {REPETITIONS} repetitions; load after: {os.getloadavg()[0]:.2f}")
    print_medians(medians)
    print_ratios(medians)
    print_memory(medians)
    print_rates(medians)


if __name__ == "__main__":
    main()
