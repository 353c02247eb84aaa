package org.hificamsim.agents.cooperative;

import org.hificamsim.core.registry.Options;

/**
 * The numbers that cooperative cameras work with: one set of defaults for all sites.
 *
 * @param horizon steps from now on that views are compared by, 1 or more
 * @param discount what a step counts, compared with the one before it
 * @param search weight of targets that nobody sees, compared with those that are known
 * @param rounds how often the cameras choose in turn at most, 1 or more
 * @param lead what a target is worth with one camera less than it needs
 * @param decay what a track counts, compared with the step before, while nobody sees its target
 * @param memory steps after which a target that nobody sees is forgotten
 * @param cells of the search map, about
 * @param relax part of the way from a cell's expectation to its learned occupancy in each step
 * @param prior number of looks that the mean occupancy counts as
 * @param learn what cameras learn where their model is wrong
 * @param named whether reports say which target is which
 */
record Parameters(
    int horizon,
    double discount,
    double search,
    int rounds,
    double lead,
    double decay,
    int memory,
    int cells,
    double relax,
    double prior,
    Learn learn,
    boolean named) {
  private static final int MAX_HORIZON = 1000;
  private static final int MAX_CELLS = 1_000_000;
  private static final double MANY = 1e9;

  static Parameters from(Options options) {
    return new Parameters(
        options.integer("horizon", 3, 1, MAX_HORIZON, "steps that views are compared by"),
        options.number("discount", 0.8, 0, 1, "weight of a step, compared with the one before"),
        options.number("search", 0.2, 0, MANY, "weight of targets that nobody sees"),
        options.integer("rounds", 5, 1, MAX_HORIZON, "how often cameras choose in turn at most"),
        options.number("lead", 0.2, 0, 1, "worth of a target with one camera less than it needs"),
        options.number("decay", 0.97, 0, 1, "weight of a target that was seen a step ago"),
        options.integer("memory", 30, 0, (int) MANY, "steps until a target is forgotten"),
        options.integer("cells", 2000, 1, MAX_CELLS, "cells of the search map, about"),
        options.number("relax", 0.15, 0, 1, "how fast the search map goes to the learned one"),
        options.number("prior", 50, 1e-6, MANY, "looks that the mean occupancy counts as"),
        options.choice(
            "learn",
            Learn.SIGHT,
            "where the model is wrong: sight (by place), bandit, sarsa (by view), none"),
        options.choice(
                "identity", Identity.KNOWN, "known: reports identify targets; none: they do not")
            == Identity.KNOWN);
  }

  /** What cameras learn beyond where targets are. */
  enum Learn {
    NONE,
    SIGHT,
    BANDIT,
    SARSA
  }

  private enum Identity {
    KNOWN,
    NONE
  }
}
