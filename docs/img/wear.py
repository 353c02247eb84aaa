"""Draws wear.png from wear.csv: the score of cooperative against the rate at which cameras change views, by hold.

With the folders of `hificamsim compare`, one for each site, it first rewrites wear.csv: python wear.py OUT/campus OUT/hall ...
"""

import csv
import pathlib
import statistics
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

HERE = pathlib.Path(__file__).parent


def hold_of(policy):
    return float(policy.partition("hold=")[2])


def means(folder):
    """Returns the mean score and the rate of view changes on a site, by hold."""
    values = {}
    with open(pathlib.Path(folder) / "metrics.csv", newline="", encoding="utf-8") as rows:
        for row in csv.DictReader(rows):
            if row["metric"] in ("score", "zoom_change_rate"):
                values.setdefault((row["metric"], hold_of(row["policy"])), []).append(float(row["value"]))
    return {key: statistics.mean(found) for key, found in values.items()}


def write(folders):
    sites = [means(folder) for folder in folders]
    holds = sorted({hold for site in sites for _, hold in site})
    with open(HERE / "wear.csv", "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["hold", "changes", "score"])
        for hold in holds:
            changes = statistics.mean(site["zoom_change_rate", hold] for site in sites)
            score = statistics.mean(site["score", hold] / site["score", 0] for site in sites)
            table.writerow([hold, round(changes, 4), round(score, 4)])


def draw():
    with open(HERE / "wear.csv", newline="", encoding="utf-8") as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    figure, axes = plt.subplots(figsize=(5.6, 3.4))
    axes.plot([row["changes"] for row in rows], [row["score"] for row in rows], marker="o", color="#1d4ed8")
    for row in rows:
        axes.annotate(f"{row['hold']:g}", (row["changes"], row["score"]), textcoords="offset points", xytext=(6, -11), fontsize=8)
    axes.set_xlabel("changes of view per camera and step")
    axes.set_ylabel("score, compared with hold=0")
    axes.set_xlim(left=0, right=0.5)
    axes.set_title("Ten sites, 300 steps; labels are hold", fontsize=10)
    axes.grid(alpha=0.3)
    figure.tight_layout()
    figure.savefig(HERE / "wear.png", dpi=110)


if sys.argv[1:]:
    write(sys.argv[1:])
draw()
