package org.hificamsim.experiments.compare;

import org.hificamsim.experiments.run.RunResult;

/** A finished run with its k_min, step by step. */
record Outcome(RunResult result, int[] kMin) {}
