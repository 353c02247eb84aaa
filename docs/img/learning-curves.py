"""Draws learning-curves.png from learning-curves.csv: pip install matplotlib numpy, then run it in this folder."""

import csv
from collections import defaultdict

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

curves = defaultdict(lambda: defaultdict(list))
with open("learning-curves.csv", newline="") as file:
    for row in csv.DictReader(file):
        curves[row["scenario"]][row["seed"]].append((int(row["episodes"]), float(row["score"])))
others = defaultdict(dict)  # by compare on seeds 100 to 119, as in docs/learning.md
with open("learning-beside.csv", newline="") as file:
    for row in csv.DictReader(file):
        others[row["scenario"]][row["policy"]] = float(row["score"])

figure, panels = plt.subplots(1, len(curves), figsize=(4.6 * len(curves), 3.6), squeeze=False)
for panel, (scenario, seeds) in zip(panels[0], curves.items()):
    episodes = min((sorted(e for e, _ in seed) for seed in seeds.values()), key=len)
    scores = np.array([[dict(seed)[e] for e in episodes] for seed in seeds.values()])
    for one in scores:
        panel.plot(episodes, one, color="#1d4ed8", linewidth=0.6, alpha=0.6)
    panel.plot(episodes, scores.mean(0), color="#1d4ed8", linewidth=2, label="PPO while it learns")
    panel.fill_between(episodes, scores.min(0), scores.max(0), color="#1d4ed8", alpha=0.15)
    styles = {"best-fixed": ("#b45309", "--"), "epsilon-greedy": ("#4b5563", ":")}
    for policy, (color, style) in styles.items():
        panel.axhline(others[scenario][policy], color=color, linestyle=style, label=policy)
    panel.set_title(f"{scenario} ({len(scores)} seed{'s' if len(scores) > 1 else ''})")
    panel.set_xlabel("episodes of 300 steps")
    panel.set_ylim(bottom=0)
panels[0][0].set_ylabel("mean score of a step")
panels[0][0].legend(loc="lower right", fontsize=8)
figure.tight_layout()
figure.savefig("learning-curves.png", dpi=110)
