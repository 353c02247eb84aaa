"""Draws the floor plan of the tutorial: shop.py FILE.png. 20 by 12 m, 40 pixels a metre."""

import sys

import matplotlib

matplotlib.use("agg")
from matplotlib import pyplot
from matplotlib.patches import Rectangle

figure = pyplot.figure(figsize=(8, 4.8), dpi=100)
axes = figure.add_axes((0, 0, 1, 1), xlim=(0, 20), ylim=(0, 12))
axes.axis("off")
axes.add_patch(Rectangle((0.05, 0.05), 19.9, 11.9, fill=False, linewidth=3))
for x in (5, 8, 11):
    axes.add_patch(Rectangle((x, 3.5), 0.8, 6, facecolor="0.8", edgecolor="0.2"))
    axes.text(x + 0.4, 6.5, "shelf", rotation=90, ha="center", va="center", fontsize=9)
axes.add_patch(Rectangle((14.5, 1.5), 2, 0.7, facecolor="0.8", edgecolor="0.2"))
axes.text(15.5, 1.85, "till", ha="center", va="center", fontsize=9)
axes.add_patch(Rectangle((18, 0), 1.6, 0.15, facecolor="white", edgecolor="white"))
axes.text(18.8, 0.45, "door", ha="center", fontsize=9)
figure.savefig(sys.argv[1])
