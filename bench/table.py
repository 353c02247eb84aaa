"""Prints the table of bench/run from the files that it measured; standard library only.

    table.py RESULTS [--write]

Our times are in JMH's JSON, the peers' in CSV. A figure is the median of the timed runs with the least and the greatest;
a ratio is the peer's median over ours, from the peer's least over our greatest to the peer's greatest over our least.
"""

import csv
import json
import os
import platform
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from statistics import fmean, median, quantiles

ROOT = Path(__file__).resolve().parent.parent
DOCUMENT = ROOT / "docs" / "performance.md"
TABLE = ROOT / "docs" / "tables" / "bench.csv"
BEGIN = "<!-- bench/run --write: begin -->"
END = "<!-- bench/run --write: end -->"
PLAIN = "plain Java objects"


@dataclass(frozen=True)
class Times:
    """Seconds per step or instance: the median, the least and the greatest of the timed runs."""

    middle: float
    least: float
    most: float

    @classmethod
    def of(cls, runs: list[float]) -> "Times":
        return cls(median(runs), min(runs), max(runs))

    @classmethod
    def quartiles(cls, runs: list[float]) -> "Times":
        low, middle, high = quantiles(runs, n=4)
        return cls(middle, low, high)

    def __str__(self) -> str:
        unit, factor = next((u, f) for u, f in (("s", 1), ("ms", 1e3), ("µs", 1e6)) if self.middle * f >= 1 or f == 1e6)
        return f"{number(self.middle * factor)} {unit} ({number(self.least * factor)} .. {number(self.most * factor)})"


@dataclass(frozen=True)
class Row:
    """A comparison, with the median, the least and the greatest of its ratio."""

    what: str
    peer: str
    ours: Times
    theirs: Times
    ratio: Times

    @classmethod
    def of(cls, what: str, peer: str, ours: Times, theirs: Times) -> "Row":
        """Compares two sets of times; the spread of the ratio follows from the spreads of both."""
        ratio = Times(theirs.middle / ours.middle, theirs.least / ours.most, theirs.most / ours.least)
        return cls(what, peer, ours, theirs, ratio)

    @classmethod
    def paired(cls, what: str, peer: str, ours: list[float], theirs: list[float]) -> "Row":
        """Compares times of the same instances, which differ in difficulty, by medians and quartiles."""
        ratios = [peers / own for own, peers in zip(ours, theirs, strict=True)]
        return cls(what, peer, Times.quartiles(ours), Times.quartiles(theirs), Times.quartiles(ratios))

    def cells(self) -> list[str]:
        low, middle, high = (number(value) for value in (self.ratio.least, self.ratio.middle, self.ratio.most))
        return [self.what, self.peer, str(self.ours), str(self.theirs), f"**{middle}** ({low} .. {high})"]


def number(value: float) -> str:
    """Returns a number with three significant digits and commas between thousands."""
    if value >= 100:
        digits = len(str(int(value))) - 3
        return f"{round(value, -digits):,.0f}"
    return f"{value:.{2 if value < 1 else 2 - (value >= 10)}f}" if value >= 0.1 else f"{value:.2g}"


class Results:
    """The files of one call of bench/run."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.jmh = [entry for path in sorted(folder.glob("*.json")) for entry in json.loads(path.read_text())]

    def ours(self, benchmark: str, **parameters: str) -> Times | None:
        """Returns the timed iterations of a benchmark with these parameters."""
        for entry in self.jmh:
            if entry["benchmark"].endswith("." + benchmark) and parameters.items() <= entry["params"].items():
                runs = [run for fork in entry["primaryMetric"]["rawData"] for run in fork]
                return Times.of([run * 1e-6 for run in runs])
        return None

    def numpy(self, name: str) -> Times | None:
        path = self.folder / f"numpy-{name}.csv"
        return Times.of([float(row["seconds"]) for row in rows(path)]) if path.exists() else None

    def whole(self, policy: str, side: str) -> Times | None:
        path = self.folder / f"whole-{policy}.csv"
        return Times.of([float(row[side]) for row in rows(path)]) if path.exists() else None

    def cp_sat(self, kind: str) -> Times | None:
        """Returns the mean over the instances for each repeat, after checking that the optima equal ours."""
        paths = sorted(self.folder.glob(f"cpsat-{kind}-*.csv"))
        if not paths:
            return None
        optima = (self.folder / f"{kind}.jsonl.values").read_text().split()
        for path in paths:
            found = [row["value"] for row in rows(path) if row["proven"] == "True"]
            if found != optima:
                sys.exit(f"error: {path} differs from the optima in {kind}.jsonl.values")
        return Times.of([fmean(float(row["seconds"]) for row in rows(path)) for path in paths])

    def skip(self, why: str) -> None:
        with open(self.folder / "skipped.txt", "a") as file:
            print(why, file=file)

    def skipped(self) -> list[str]:
        return (self.folder / "skipped.txt").read_text().splitlines()

    def table(self) -> list[Row]:
        table: list[Row] = []

        def add(what: str, peer: str, ours: Times | None, theirs: Times | None) -> None:
            if ours and theirs:
                table.append(Row.of(what, peer, ours, theirs))

        for policy in ("zoom-out", "epsilon-greedy", "sarsa"):
            task = {"scenario": "bench/cluster-8.xml", "policy": policy}
            ours = self.ours("PeerBenchmark.ours", **task)
            what = f"cluster, 14 cameras, 8 targets: {policy}"
            add(what, PLAIN, ours, self.ours("PeerBenchmark.plain", **task))
            add(what, "NumPy", ours, self.numpy(f"cluster-8-{policy}"))
        for policy in ("zoom-out", "epsilon-greedy", "sarsa"):
            what = f"coverage study's rule, 10 cameras, 6 targets, whole runs with steps.csv: {policy}"
            add(what, PLAIN, self.whole(policy, "ours"), self.whole(policy, "plain"))
        for cameras in (15, 100):
            task = {"scenario": f"{self.folder}/auction-{cameras}.xml"}
            what = f"CamSim's auctions (Passive, Broadcast), {cameras} cameras, {cameras // 2} targets"
            ours = self.ours("AuctionPeerBenchmark.ours", **task)
            add(what, PLAIN, ours, self.ours("AuctionPeerBenchmark.plain", **task))
        for cameras in (100, 1000, 10_000):
            for policy in ("zoom-out", "epsilon-greedy"):
                task = {"scenario": f"{self.folder}/field-{cameras}.xml", "policy": policy}
                ours = self.ours("PeerBenchmark.ours", **task)
                what = f"random field, {cameras:,} cameras, {round(0.6 * cameras):,} targets: {policy}"
                add(what, PLAIN, ours, self.ours("PeerBenchmark.plain", **task))
                add(what, "NumPy", ours, self.numpy(f"field-{cameras}-{policy}"))
        for kind, name in (("nested", "nested sets"), ("general", "sets not nested")):
            ours = self.ours("StepOptimumBenchmark.solve", instances=f"{self.folder}/{kind}.jsonl")
            add(f"optimum of a step, 14 cameras, 8 targets, {name}: proof", "CP-SAT", ours, self.cp_sat(kind))
        step = self.ours("PeerBenchmark.ours", scenario="bench/crowd-8.xml", policy="optimal")
        add("the same, nested sets: ours a whole step of `optimal`", "CP-SAT", step, self.cp_sat("nested"))
        return table + self.large_optima()

    def large_optima(self) -> list[Row]:
        """Compares processor times of the instances that both solvers proved, by density; empty if there are none."""
        folder = self.folder / "optimum"
        if not (folder / "cpsat.csv").exists():
            return []
        pairs: dict[str, list[tuple[float, float]]] = {}
        unproven = [0, 0]
        for own, peer in zip(rows(folder / "ours.csv"), rows(folder / "cpsat.csv"), strict=True):
            times = (float(own["cpu_ms"]) * 1e-3, float(peer["cpu_ms"]) * 1e-3)
            open_ones = [side["value"] != side["bound"] for side in (own, peer)]
            unproven = [count + is_open for count, is_open in zip(unproven, open_ones)]
            if not any(open_ones):
                pairs.setdefault(own["density"], []).append(times)
        if any(unproven):
            self.skip(f"optima for 200 cameras left unproven, by ours in {unproven[0]} cases, by CP-SAT in {unproven[1]}")
        what = "optimum, 200 cameras, 40 targets, not nested, {} instances `{}`, quartiles: proof"
        return [
            Row.paired(what.format(len(times), density), "CP-SAT", *map(list, zip(*times)))
            for density, times in pairs.items()
        ]

    def machine(self) -> str:
        """Returns processor, cores and versions in one line."""
        java = self.jmh[0]
        parts = [processor(), f"{os.cpu_count()} cores", f"{java['vmName']} {java['vmVersion']}", f"JMH {java['jmhVersion']}"]
        parts.append(f"Python {platform.python_version()}")
        log = self.folder / "versions.txt"
        parts += log.read_text().splitlines() if log.exists() else []
        return ", ".join(parts)


def rows(path: Path) -> list[dict[str, str]]:
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def processor() -> str:
    """Returns the model of the processor as the system names it."""
    if platform.system() == "Darwin":
        return subprocess.check_output(["sysctl", "-n", "machdep.cpu.brand_string"], text=True).strip()
    found = re.search(r"^model name\s*: (.*)$", Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    return found.group(1) if found else platform.processor() or platform.machine()


HEADER = ["what (one thread)", "peer", "ours", "peer's", "peer's / ours"]


def markdown(lines: list[list[str]]) -> str:
    return "".join("| " + " | ".join(cells) + " |\n" for cells in [HEADER, ["---"] * len(HEADER), *lines])


def note(results: Results, command: str) -> str:
    load = (results.folder / "load.txt").read_text().strip()
    text = f"`{command}`; {results.machine()}; load when it began: {load}."
    return text + "".join(f"\nSkipped: {line}." for line in results.skipped())


def write(lines: list[list[str]], text: str) -> None:
    """Writes the table, and puts the note under the link to it, between two markers."""
    document = DOCUMENT.read_text(encoding="utf-8")
    if BEGIN not in document or END not in document:
        sys.exit(f"error: {DOCUMENT.name} has no line '{BEGIN}' followed by '{END}'")
    before, rest = document.split(BEGIN, 1)
    after = rest.split(END, 1)[1]
    DOCUMENT.write_text(f"{before}{BEGIN}\n[Table: bench](tables/{TABLE.name})\n\n{text}\n{END}{after}", encoding="utf-8")
    with open(TABLE, "w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows([HEADER, *lines])


def main() -> None:
    folder, *options = sys.argv[1:]
    results = Results(Path(folder))
    lines = [row.cells() for row in results.table()]
    text = note(results, (results.folder / "command.txt").read_text().strip())
    print(f"{markdown(lines)}\n{text}")
    if "--write" in options:
        write(lines, text)


if __name__ == "__main__":
    main()
