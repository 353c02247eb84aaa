"""Reads scores (scenario, policy, seed) as JSON and writes what rliable and SciPy make of them."""
import json
import sys

import numpy
import scipy.stats
from rliable import library, metrics

data = json.load(sys.stdin)
x, y = (numpy.array(data[name]).T for name in ("x", "y"))  # rliable wants runs in rows


def aggregates(scores):
    return numpy.array([metrics.aggregate_iqm(scores), metrics.aggregate_optimality_gap(scores),
                        metrics.aggregate_mean(scores), metrics.aggregate_median(scores)])


random = numpy.random.RandomState(1)
points, ends = library.get_interval_estimates({"x": x}, aggregates, reps=20000, random_state=random)
improvement, improvement_ends = library.get_interval_estimates(
    {"pair": [x, y]}, lambda one, other: numpy.array([metrics.probability_of_improvement(one, other)]), reps=2000, random_state=random)
profiles, profile_ends = library.create_performance_profile({"x": x}, numpy.array(data["taus"]), reps=2000)
few = (x - y)[:data["few"], 0]
test = lambda differences: scipy.stats.permutation_test(
    (differences,), numpy.mean, permutation_type="samples", n_resamples=200000, rng=1).pvalue
json.dump({
    "aggregates": points["x"].tolist(), "ends": ends["x"].tolist(),
    "improvement": improvement["pair"].tolist(), "improvementEnds": improvement_ends["pair"].ravel().tolist(),
    "profile": profiles["x"].tolist(), "profileEnds": profile_ends["x"].tolist(),
    "exact": test(few), "drawn": test((x - y)[:, 0]),
}, sys.stdout)
