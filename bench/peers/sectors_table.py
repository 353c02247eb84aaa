"""Prints a line of bench/sectors: our mean time, CP-SAT's, and their ratio, after checking that all optima are equal.

    sectors_table.py FOLDER OBJECTIVE
"""

import csv
import json
import pathlib
import sys


def main() -> None:
    folder, objective = pathlib.Path(sys.argv[1]), sys.argv[2]
    with open(folder / "cpsat.csv", newline="") as file:
        peer = list(csv.DictReader(file))
    name = "instances.jsonl" + ("" if objective == "kmin" else f"-{objective}")
    ours = (folder / f"{name}.values").read_text().split()
    for row, value in zip(peer, ours, strict=True):
        if row["proven"] == "True" and row["value"] != value:
            sys.exit(f"instance {row['instance']} of {objective}: {value}, CP-SAT {row['value']}")
    times = json.loads((folder / "ours.json").read_text())
    own = next(t["primaryMetric"]["score"] for t in times if t["params"]["objective"] == objective)
    theirs = 1e6 * sum(float(row["seconds"]) for row in peer) / len(peer)
    print(f"{objective:12s} ours {own:8.1f} us  CP-SAT {theirs:10.1f} us  ratio {theirs / own:8.0f}")


if __name__ == "__main__":
    main()
