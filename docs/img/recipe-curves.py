"""Draws recipe-curves.png from recipe-curves.csv (docs/tables.py curves): pip install matplotlib numpy, then run it here."""

import csv
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

COLORS = {"imitation": "#1d4ed8", "mappo": "#b45309", "ippo": "#047857", "vdn": "#7c3aed", "qmix": "#4b5563"}
curves = defaultdict(lambda: defaultdict(list))
with open("recipe-curves.csv", newline="") as file:
    for row in csv.DictReader(file):
        curves[row["method"]][row["training"]].append((int(row["round"]), float(row["score"])))

figure, panels = plt.subplots(1, len(curves), figsize=(4.6 * len(curves), 3.4), squeeze=False, sharey=True)
for panel, (method, trainings) in zip(panels[0], curves.items()):
    rounds = [number for number, _ in min(trainings.values(), key=len)]
    scores = np.array([[dict(training)[number] for number in rounds] for training in trainings.values()])
    for single in scores:
        panel.plot(rounds, single, color=COLORS[method], linewidth=0.6, alpha=0.6)
    panel.plot(rounds, scores.mean(0), color=COLORS[method], linewidth=2)
    panel.set_title(f"{method}, {len(scores)} training seed{'s' if len(scores) > 1 else ''}")
    panel.set_xlabel("round")
    panel.set_xticks(rounds)
panels[0][0].set_ylabel("score of the episodes played, 0 to 1")
figure.tight_layout()
figure.savefig("recipe-curves.png", dpi=110)
