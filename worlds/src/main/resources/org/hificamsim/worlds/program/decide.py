"""Asks the policy of a Python file: reads observations and masks, and writes an action for each camera."""

import json
import os
import sys

import numpy as np

into, out = sys.stdin.buffer, os.fdopen(os.dup(1), "wb")
os.dup2(2, 1)  # what the policy prints is no answer


def take(shape, kind):
    size = int(np.prod(shape)) * np.dtype(kind).itemsize
    data = into.read(size)
    if len(data) < size:
        sys.exit(0)
    return np.frombuffer(data, kind).reshape(shape).copy()


told = json.loads(into.readline())
copy, original, *weights = sys.argv[1:]
space = {"__name__": "policy", "__file__": original, "WEIGHTS": weights[0] if weights else None}
with open(copy, encoding="utf-8") as file:
    exec(compile(file.read(), original, "exec"), space)
if "policy" not in space:
    sys.exit("it has no 'policy', expected a function of observations and masks")
policy = space["policy"]
if hasattr(policy, "begin"):
    policy.begin()
while True:
    observations = take((told["cameras"], told["numbers"]), "<f4")
    masks = take((told["cameras"], told["choices"]), "u1")
    actions = np.asarray(policy(observations, masks))
    if actions.size != told["cameras"] * told["actions"] or actions.dtype.kind not in "iu":
        sys.exit(f"its actions are {actions.dtype} of shape {actions.shape}, expected a whole number for each camera")
    out.write(actions.astype("<i4").tobytes())
    out.flush()
