"""Writes svr-reference.csv: what LIBSVM, through scikit-learn, predicts for data that this script makes.

Run it where scikit-learn is installed, in this folder: python3 svr_reference.py
Checked in with the table it wrote (scikit-learn 1.9.1), so that tests need no Python.
"""
import csv
import math

from sklearn.svm import SVR

SIZES = [0.10, 0.12, 0.16, 0.22, 0.30, 0.40, 0.52, 0.66]
LENGTHS = [0.010, 0.015, 0.024, 0.050, 0.070, 0.085]
DISTANCES = [1, 3, 5, 8, 10]

rows = [(q, float(d), z) for q in SIZES for z in LENGTHS for d in DISTANCES]
truth = [
    -2 * math.log10(z * q / d) + math.log10(0.0224 * 0.015) + 0.15 * math.sin(12.9898 * i)
    for i, (q, d, z) in enumerate(rows)
]
low = [min(column) for column in zip(*rows)]
high = [max(column) for column in zip(*rows)]
scaled = [[(v - a) / (b - a) for v, a, b in zip(row, low, high)] for row in rows]

linear = SVR(kernel="linear", C=1, epsilon=0.1, tol=1e-6).fit(rows, truth)
rbf = SVR(kernel="rbf", C=1, epsilon=0.1, gamma=1 / 3, tol=1e-6).fit(scaled, truth)

with open("svr-reference.csv", "w", newline="") as file:
    table = csv.writer(file, lineterminator="\n")
    table.writerow(["q", "d", "z", "y", "linear", "rbf"])
    for row, y, a, b in zip(rows, truth, linear.predict(rows), rbf.predict(scaled)):
        table.writerow([*row, repr(float(y)), f"{a:.9f}", f"{b:.9f}"])
