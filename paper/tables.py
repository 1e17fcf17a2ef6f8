"""The tables of the paper: tabulars of \\val{key}, whose rows depend on which data there are."""

METRIC_NAMES = {"point_to_point": "point-to-point", "point_to_plane": "point-to-plane",
                "plane_to_plane": "plane-to-plane"}
METHODS = ("pairwise", "metascan", "simultaneous", "graph", "joint")


def val(key):
    return rf"\val{{{key}}}"


def tabular(columns, head, groups):
    """groups: lists of rows, with a little space between them; a row is a list of cells."""
    lines = [rf"\begin{{tabular}}{{{columns}}}", r"\toprule", *head, r"\midrule"]
    for i, rows in enumerate(groups):
        if i:
            lines.append(r"\addlinespace")
        lines += [" & ".join(row) + r" \\" for row in rows]
    return "\n".join([*lines, r"\bottomrule", r"\end{tabular}"]) + "\n"


def cost(real_data):
    sources = [("paper", "2003, Pentium-III-800"), ("office", "simulated office")]
    if real_data:
        sources.append(("hallway", "real hallway"))
    head = [" & ".join(["", ""] + [rf"\multicolumn{{3}}{{c}}{{{title}}}" for _, title in sources]) + r" \\",
            "".join(rf"\cmidrule(lr){{{3 * i + 3}-{3 * i + 5}}}" for i in range(len(sources))),
            " & ".join(["points", "search"] + ["time", "iter.", "ratio"] * len(sources)) + r" \\"]
    rows = [["", ""] + [cell for source, _ in sources for cell in
                        (rf"\multicolumn{{3}}{{c}}{{\footnotesize {val(f'table.{source}.all.points')} all, "
                         rf"{val(f'table.{source}.reduced.points')} reduced}}",)]]
    body = []
    for points, search, label in (("all", "brute_force", "brute force"), ("reduced", "brute_force", "brute force"),
                                  ("all", "kd_tree", "$k$-d tree"), ("reduced", "kd_tree", "$k$-d tree")):
        body.append([points, label] + [val(f"table.{source}.{points}.{search}.{what}") for source, _ in sources
                                       for what in ("time", "iterations", "ratio")])
    return tabular("ll" + "rrr" * len(sources), head, [rows, body])


def cross_check():
    columns = ("tx", "ty", "tz", "rx", "ry", "rz", "rms")
    groups = []
    for key, label in (("first", "1 in 0"), ("second", "2 in 1"), ("narrow", "1 in 0")):
        groups.append([[label, val(f"hallway.{key}.gate")] + [val(f"hallway.{key}.{c}") for c in columns],
                       ["", ""] + [rf"\textcolor{{gray}}{{{val(f'hallway.{key}.reference.{c}')}}}"
                                   for c in columns]])
    head = [r"scans & gate & $t_x$ & $t_y$ & $t_z$ & $\theta_x$ & $\theta_y$ & $\theta_z$ & rms \\"]
    return tabular("@{}llrrrrrrr@{}", head, groups)


def metrics():
    groups = []
    for pair, label in (("first", "1 in 0"), ("second", "2 in 1")):
        rows = []
        for metric, name in METRIC_NAMES.items():
            key = f"hallway.{pair}.{metric}"
            moved = ["--", "--"] if metric == "point_to_point" else \
                [val(f"{key}.moved.cm"), val(f"{key}.moved.deg")]
            rows.append([label if not rows else "", name, val(f"{key}.iterations"), val(f"{key}.time"), *moved,
                         val(f"{key}.sigma.cm"), val(f"{key}.sigma.deg")])
        groups.append(rows)
    head = [r"& & & & \multicolumn{2}{c}{moved by} & \multicolumn{2}{c}{st.\ dev.} \\",
            r"\cmidrule(lr){5-6}\cmidrule(l){7-8}",
            r"scans & metric & iter. & time & cm & deg & cm & deg \\"]
    return tabular("@{}llrrrrrr@{}", head, groups)


def garage():
    def distances(method, when):
        return [val(f"garage.{method}.{when}.{what}") for what in ("median", "p90", "worst")]
    rows = [[method, val(f"garage.{method}.alignments"), val(f"garage.{method}.time"),
             *distances(method, "after")] for method in METHODS]
    return tabular("@{}lrrrrr@{}", [r"& alignments & time & median & 90\,\% & worst \\"],
                   [[["first guesses", "", "", *distances("simultaneous", "before")]], rows])


def garage_steps(scans):
    rows = [[str(scan)] + [val(f"garage.step{scan}.{what}")
                           for what in ("pairs", "before", "after", "moved.cm", "moved.deg")]
            for scan in range(1, scans)]
    head = [r"& & \multicolumn{2}{c}{distance [cm]} & \multicolumn{2}{c}{moved by} \\",
            r"\cmidrule(lr){3-4}\cmidrule(l){5-6}", r"scan & pairs & before & after & cm & deg \\"]
    return tabular("@{}rrrrrr@{}", head, [rows])


def covariance():
    rows = [[name] + [val(f"covariance.{metric}.{what}.{unit}") for unit in ("cm", "deg")
                      for what in ("error", "sigma", "ratio")] for metric, name in METRIC_NAMES.items()]
    head = [r"& \multicolumn{3}{c}{position [cm]} & \multicolumn{3}{c}{rotation [deg]} \\",
            r"\cmidrule(lr){2-4}\cmidrule(l){5-7}", r"metric & error & st.\,d. & ratio & error & st.\,d. & ratio \\"]
    return tabular("@{}lrrrrrr@{}", head, [rows])


def options():
    def row(label, faithful, default):
        return [label, faithful, default]
    def both(label, key, unit):
        return row(label, val(f"faithful.{key}") + unit, val(f"default.{key}") + unit)
    return tabular("@{}lll@{}", [r"& as in 2003 & default \\"], [[
        row("points", f"of slices, {val('faithful.reduce.join_distance')}\\,m",
            f"of voxels, {val('default.reduce.voxel_size')}\\,m"),
        row("metric", "point-to-point", "plane-to-plane"),
        row("gate", f"{val('faithful.icp.max_distance')}\\,m",
            f"{val('default.icp.start_distance')} to {val('default.icp.max_distance')}\\,m"),
        row("weights", "equal", "Cauchy"),
        both("tolerance of the rms", "icp.convergence_rms", r"\,m"),
        both("overlap, more than", "registration.overlap_pairs", " pairs"),
        both("location changed by", "registration.moved_translation", r"\,m"),
        both("or by", "registration.moved_rotation", r"\,rad"),
        both("alignments per scan, up to", "registration.max_pops", "")]])


def matching(table, levels, methods, measures):
    def cell(key):
        return rf"{val(key)} {{\scriptsize {val(key + '.interval')}}}"
    groups = [[[level if i == 0 else "", method, *(cell(f"{table}.{level}.{method}.{m}") for m in measures)]
               for i, method in enumerate(methods)] for level in levels]
    head = [r"noise & method & position [cm] & rotation [deg] & map error [cm] & median wall [cm] & worst wall [cm] \\"]
    return tabular("@{}ll" + "r" * len(measures) + "@{}", head, groups)


def posegraphs(names):
    rows = [[name.replace('_', r'\_'), *(val(f"graphs.{name.replace('-', '_')}.{what}") for what in
                     ("vertices", "edges", "optimum", "difference", "gap", "iterations", "time", "certificate",
                      "information", "guess"))] for name in names]
    head = [r"graph & vertices & edges & $F$ & difference & gap & iter. & time & certificate & $\chi^2$ & from the guess \\"]
    return tabular("@{}lrrrrrrrrrr@{}", head, [rows])


def kernels(shares, names):
    def cell(share, name):
        key = f"kernels.{share}.{name}"
        return [val(key + ".position") + rf" {{\scriptsize {val(key + '.interval')}}}", val(key + ".within")]
    groups = [[[rf"{share}\,\%" if i == 0 else "", name.replace("_", " "), *cell(share, name)]
               for i, name in enumerate(names)] for share in shares]
    return tabular("@{}llrr@{}", [r"wrong & kernel & position [cm] & within $2\times$ [\%] \\"], groups)


FEATURE_HEADS = {"detector": "detector", "method": "method", "log": "log", "walls": "walls", "planes": "planes",
                 "recall": "recall", "precision": "precision", "angle_deg": "angle [deg]", "offset_mm": "offset [mm]",
                 "ends_mm": "ends [mm]", "ends_within_5cm": "within 5\\,cm", "surfaces": "surfaces",
                 "cover": "cover", "pieces_per_plane": "pieces", "sweeps": "sweeps", "lines_per_sweep": "lines",
                 "points_explained": "points", "rms_mm": "rms [mm]", "found_again": "again"}


def features(rows, first):
    """A table of ablation_features as it stands; `first` is only its name in errors."""
    if not rows:
        raise ValueError(f"{first}.csv is empty")
    columns = list(rows[0])
    texts = [c for c in columns if c in ("detector", "method", "log")]
    cells = [[row[c].replace("_", " ").removesuffix(".clf.bz2") for c in columns] for row in rows]
    return tabular("@{}" + "l" * len(texts) + "r" * (len(columns) - len(texts)) + "@{}",
                   [" & ".join(FEATURE_HEADS[c] for c in columns) + r" \\"], [cells])


def views(rows):
    """The policies of ablation_nbv."""
    columns = ("policies", "scans / fewest", "way / tour", "reached %", "ended %", "covered %", "least %")
    heads = ("policy", "scans / fewest", "way / tour", r"reached [\%]", r"ended [\%]", r"seen [\%]", r"least [\%]")
    return tabular("l" + "r" * (len(columns) - 1), [" & ".join(heads) + r" \\"],
                   [[[row[c].replace("_", " ") for c in columns] for row in rows]])
