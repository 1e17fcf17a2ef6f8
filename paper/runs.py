"""Runs experiments through the program, and leaves alone what is up to date."""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import subprocess

# What makes the program; a commit that changes nothing here leaves all runs as they are.
SOURCES = ["CMakeLists.txt", "slam", "planning", "control", "drivers", "experiments", "third_party",
           ":!experiments/configs", ":!experiments/bench"]


class RunError(Exception):
    pass


def read_json(path):
    return json.loads(pathlib.Path(path).read_text())


class Experiments:
    """The run directories that the paper is made of.

    A run is used again if it is finished, was made from the same config and assignments, its resolved config
    is still what it was, and the program is the same: by the commit in the manifests, or, of a program with
    uncommitted changes, by its bytes. `records` says what the runs were made from.
    """

    def __init__(self, root, program, data, records, fresh):
        self.root = root
        self.program = program
        self.environment = dict(os.environ, ARIADNE_DATA=str(data))
        self.records_path = records
        self.records = {} if fresh or not records.exists() else read_json(records)
        self.program_hash = hashlib.sha256(program.read_bytes()).hexdigest()
        self.used = []
        self.made = 0
        self.current = self._probe()

    def _probe(self):
        """The manifest of the program as it is: that of a run of a moment."""
        directory = self.root / "results" / "paper" / "probe"
        self._execute("experiments/configs/fig_05.yaml", directory, [])
        return read_json(directory / "manifest.json")

    def run(self, config, name=None, sets=()):
        """The directory of a finished run of experiments/configs/CONFIG.yaml."""
        path = f"experiments/configs/{config}.yaml"
        directory = self.root / "results" / "paper" / (name or config)
        key = str(directory.relative_to(self.root))
        self.used.append(directory)
        if self._is_up_to_date(directory, key, path, sets):
            return directory
        self._execute(path, directory, sets)
        self.made += 1
        self.records[key] = self._record(directory, path, sets)
        return directory

    def run_all(self, jobs):
        """Runs (config, name, sets) side by side; only for runs whose times do not count."""
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            return list(pool.map(lambda job: self.run(*job), jobs))

    def save_records(self):
        self.records_path.write_text(json.dumps(self.records, indent=1, sort_keys=True) + "\n")

    def _record(self, directory, path, sets):
        return {"config": hashlib.sha256((self.root / path).read_bytes()).hexdigest(), "sets": list(sets),
                "resolved": hashlib.sha256((directory / "config.yaml").read_bytes()).hexdigest(),
                "program": self.program_hash}

    def _is_up_to_date(self, directory, key, path, sets):
        if key not in self.records or not self._is_finished(directory):
            return False
        record, now = self.records[key], self._record(directory, path, sets)
        if any(record[part] != now[part] for part in ("config", "sets", "resolved")):
            return False
        made_by = read_json(directory / "manifest.json")
        if made_by["dirty"] or self.current["dirty"]:
            return record["program"] == now["program"]
        return self._same_sources(made_by["commit"], self.current["commit"])

    @staticmethod
    def _is_finished(directory):
        progress = directory / "progress.json"
        return (directory / "manifest.json").exists() and progress.exists() and \
            read_json(progress)["state"] == "finished"

    def _same_sources(self, before, after):
        if before == after:
            return True
        difference = subprocess.run(["git", "diff", "--quiet", before, after, "--", *SOURCES], cwd=self.root,
                                    stderr=subprocess.DEVNULL)
        return difference.returncode == 0

    def _execute(self, path, directory, sets):
        command = [str(self.program), "run", path, "--quiet", "--overwrite", "--out",
                   str(directory.relative_to(self.root))]
        for assignment in sets:
            command += ["--set", assignment]
        directory.parent.mkdir(parents=True, exist_ok=True)
        progress = directory / "progress.json"
        before = progress.stat().st_mtime_ns if progress.exists() else None
        finished = subprocess.run(command, cwd=self.root, env=self.environment, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        # A run whose scans could not all be registered is a result, too.
        ended = self._is_finished(directory) and progress.stat().st_mtime_ns != before
        if finished.returncode != 0 and not ended:
            lines = finished.stdout.strip().splitlines() or ["no output"]
            raise RunError(f"{path} {' '.join(sets)}: {lines[-1]}")
