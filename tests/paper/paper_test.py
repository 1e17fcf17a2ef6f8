"""The sections on views, driving and devices find their numbers, pictures and tables: paper_test.py PROGRAM.

The runs are made up; their options are those of the program.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "paper"))

import build  # noqa: E402
import driving_tables  # noqa: E402
import driving_values  # noqa: E402
import values as v  # noqa: E402

PROGRAM = None
SECTIONS = ("views", "driving", "devices")

CONTROLLERS = """controller,starts,at goal %,way / line,95 %,time s,95 % s,worst mm,worst deg,1/m at 0.5 m,1/m at 5 cm,turning,violations
indiveri,100,100.0000,1.466,2.172,15.925,26.472,9.992,0.245,0.638,0.596,1.700,0
"indiveri, many",1000000,99.9000,1.445,2.210,16.300,25.950,10.000,0.250,0.667,0.631,1.847,3
"""
PERSONS = """robot,episodes,reached %,contacts,needless,foreseeable,given up,time s,95 % s
looks where it goes,1000,99.0,18,3,1,25,20.0,24.9
does not look,1000,100.0,38,30,20,35,16.8,24.3
"""
TRIALS = """world,way,seed,end,surface_covered,translation_rms_m,map_error_median_m,collisions
hall,default,1,nothing is left that is worth a scan,0.98,0.01,0.004,0
hall,default,2,the limit of scans is reached,0.96,0.06,0.03,2
hall,2003,1,the robot is lost,0.5,0.9,0.02,1
"""
WORLDS = """world,mission,runs,scans,way m,minutes,surface %,least surface %,position cm,worst cm,map mm,refused,given up,collisions,ended %
entrance_hall,default,2,36.5,150,12.5,97.0,96.0,3.5,6.0,4.0,0.00,0.5,1.00,50
entrance_hall,wheels' errors x 2,2,-,-,-,-,-,-,-,-,0.00,0.5,1.00,50
"""
DIFFERENCES = """mission,pairs,walls %,surface %,position mm,map mm
robot emulated - default,5,"+2.1 [-0.9, +5.0]","+2.5 [-2.0, +6.9]","+0.3 [-1.0, +2.0]","-0.1 [-0.3, +0.2]"
"""
POLICIES = """policies,scans / fewest,way / tour,reached %,ended %,covered %,least %,"scans, change %",p,"way, change %",p way
default,"1.6 [1.5, 1.7]","1.3 [1.2, 1.4]",100.0,100.0,99.6,96.3,"+0 [+0, +0]",1,"+0 [+0, +0]",1
paper,"8.1 [8, never]","2.1 [2, never]",75.0,78.0,95.0,9.0,"+400 [+300, never]",0.001,"+60 [+40, never]",0.001
"""
SAMPLERS = """samplers,"scans, change %",p
uniform,"+0 [+0, +0]",1
gaussian,"-3 [-5, -1]",0.01
bridge_test,"never [+4, never]",0.2
"""
WAYS = """ways,"scans, change %",p,"way, change %",p way
straight,"+1 [-6, +8]",0.97,"+13 [+9, +17]",0.01
controller_length,"+9 [+4, +14]",0.0035,"-10 [-13, -5]",0.02
controller_time,"+14 [+8, +17]",0.001,"-2 [-5, +1]",0.4
"""
CURVES = """policy,bound,covered_by_scans,covered_by_way
default,0.0,0.05,0.05
default,4.0,0.99,1.0
paper,0.0,0.05,0.05
paper,4.0,0.5,0.7
"""
TIMES = """what,candidates,edges,decisions,median ms,99 % ms,max ms
whole decision,200,996,200,10.31,14.04,17.30
candidates and gain,200,996,200,5.38,7.74,8.76
whole decision,50,996,200,3.91,7.44,9.23
"""
FILES = {"ablation_nbv": {"policies.csv": POLICIES, "samplers.csv": SAMPLERS, "ways.csv": WAYS, "curves.csv": CURVES,
                          "floors.csv": "floor\nschool\noffice\n"},
         "planning_time": {"timing.csv": TIMES},
         "ablation_control": {"controllers.csv": CONTROLLERS}, "walking_persons": {"persons.csv": PERSONS},
         "ablation_mission": {"trials.csv": TRIALS, "worlds.csv": WORLDS},
         "emulated_robot": {"differences.csv": DIFFERENCES}, "fig_12": {"metrics.json": '{"stops": 114}'},
         "fig_13": {"metrics.json": '{"scans": 9}'}}
PICTURES = {"fig_13": ("fig_13_scans", "fig_13_boxes")}


class MadeUpExperiments:
    """Run directories with the files that the sections read, and no program run for more than its options."""

    def __init__(self, root):
        self.root = root

    def run(self, config, name=None, sets=()):
        directory = self.root / config
        (directory / "figures").mkdir(parents=True, exist_ok=True)
        text = (ROOT / "experiments" / "configs" / f"{config}.yaml").read_text()
        experiment = re.search(r"^experiment: (\w+)$", text, re.MULTILINE)[1]
        options = subprocess.run([PROGRAM, "config", experiment], capture_output=True, text=True, check=True)
        (directory / "config.yaml").write_text(options.stdout)
        for file, content in FILES.get(config, {}).items():
            (directory / file).write_text(content)
        for picture in PICTURES.get(config, (config,)):
            (directory / "figures" / f"{picture}.png").write_bytes(b"")
        return directory


class Sections(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        build.BUILD = pathlib.Path(cls.folder.name) / "build"
        build.BUILD.mkdir()
        build.say = lambda text: None
        cls.values = v.Values()
        experiments = MadeUpExperiments(pathlib.Path(cls.folder.name))
        build.views(cls.values, experiments)
        build.driving(cls.values, experiments)
        build.devices(cls.values, experiments)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def text_of(self, section):
        return (ROOT / "paper" / "sections" / f"{section}.tex").read_text()

    def test_every_number_is_there(self):
        for section in SECTIONS:
            for key in re.findall(r"\\val\{([^}]+)\}", self.text_of(section)):
                self.assertIn(key, self.values.texts, section)

    def test_every_picture_and_table_is_there(self):
        for section in SECTIONS:
            for picture in re.findall(r"\\includegraphics(?:\[[^]]*\])?\{([^}]+)\}", self.text_of(section)):
                self.assertTrue((build.BUILD / f"{picture}.png").exists(), picture)
            for table in re.findall(r"\\input\{([^}]+)\}", self.text_of(section)):
                self.assertTrue((build.BUILD / f"{table}.tex").exists(), table)

    def test_samplers_are_judged_by_their_tests(self):
        self.assertEqual(self.values.texts["nbv.samplers.best.name"], "gaussian")
        self.assertEqual(self.values.texts["nbv.samplers.worst.name"], "bridge test")
        verdict = self.values.texts["nbv.samplers.verdict"]
        self.assertIn(r"fewer scans than with uniform candidates are needed with gaussian ($-$3 [$-$5, $-$1]", verdict)
        self.assertNotIn("bridge", verdict)

    def test_ways_cost_scans_too(self):
        self.assertEqual(self.values.texts["nbv.ways.controller_length.scans.change"], "$+$9 [$+$4, $+$14]")
        self.assertEqual(self.values.texts["nbv.ways.controller_length.way.p"], "0.02")

    def test_the_whole_decision_is_timed(self):
        self.assertEqual(self.values.texts["planning.median"], "10.3")
        self.assertEqual(self.values.texts["planning.late"], "14.0")
        self.assertEqual(self.values.texts["nbv.floor_count"], "2")

    def test_curves_end_where_they_say(self):
        text = (build.BUILD / "plot_by_scans.tex").read_text()
        top = 28 + 0.99 * (150 - 28)
        self.assertIn(f"196.00 {top:.2f} l", text)
        self.assertIn("nearest frontier", (build.BUILD / "plot_policies.tex").read_text())

    def test_missions_are_held_to_what_they_should_reach(self):
        for key, text in (("runs", 2), ("ended", 1), ("untouched", 1), ("contacts", 2), ("covering", 1), ("straight", 1),
                          ("sharp", 1), ("surface.low", 96.0), ("surface.high", 98.0), ("position.high", 6.0)):
            self.assertEqual(self.values.texts[f"missions.default.{key}"], str(text), key)
        self.assertEqual(self.values.texts["missions.2003.sharp"], "1")
        self.assertEqual(self.values.texts["missions.2003.ended"], "0")

    def test_the_many_starts_are_not_the_few(self):
        self.assertEqual(self.values.texts["control.many.starts"], r"1\,000\,000")
        self.assertEqual(self.values.texts["control.many.at_goal"], "99.9")
        self.assertEqual(self.values.texts["control.many.violations"], "3")

    def test_tables_are_as_wide_as_their_heads(self):
        for table in build.BUILD.glob("table_*.tex"):
            lines = table.read_text().splitlines()
            columns = len(re.sub(r"@\{\}", "", re.match(r"\\begin\{tabular\}\{(.*)\}$", lines[0])[1]))
            for line in lines:
                if line.endswith(r"\\") and r"\multicolumn" not in line:
                    self.assertEqual(line.count("&") + 1, columns, f"{table.name}: {line}")


class Cells(unittest.TestCase):
    def test_decay(self):
        self.assertAlmostEqual(driving_values.slowest_decay(2.0, 2.9), 1.1298, places=4)
        self.assertAlmostEqual(driving_values.slowest_decay(2.0, 2.0), 1.0)  # two complex ones

    def test_texts(self):
        self.assertEqual(driving_tables.mission("wheels' errors x 2"), r"wheels' errors $\times$\,2")
        self.assertEqual(driving_tables.whole("-"), "-")
        self.assertEqual(driving_tables.whole("36.5"), "36")
        self.assertEqual(driving_tables.interval("+1.2 [-3.0, +4.1]"),
                         r"$+$1.2 {\scriptsize [$-$3.0, $+$4.1]}")


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
