package org.hificamsim.agents.cooperative;

import org.hificamsim.core.registry.Options;

/**
 * The parameters of cooperative cameras; the defaults are the same for all sites.
 *
 * @param horizon number of steps, from the present one on, by which views are compared; 1 or more
 * @param discount weight of a step, compared with the step before
 * @param search weight of targets that no camera sees, compared with known ones
 * @param rounds number of times that cameras choose in turn at most, 1 or more
 * @param lead worth of a target that is covered by one camera fewer than it needs
 * @param further worth of each further camera on a target, as a part of the previous camera's, if
 *     the least k counts
 * @param hold gain that each move on a way must add, as a share of the known targets per camera; 0
 *     where all cameras move at once
 * @param decay weight of a track, compared with the step before, while no camera sees its target
 * @param memory number of steps after which a target that no camera sees is forgotten
 * @param cells approximate number of cells of the search map
 * @param relax part of the way that a cell's expected targets go to its learned occupancy in a step
 * @param prior number of looks that the mean occupancy counts as
 * @param learn the values that cameras learn if their model is wrong
 * @param identified whether reports identify targets
 */
record Parameters(
    int horizon,
    double discount,
    double search,
    int rounds,
    double lead,
    double further,
    double hold,
    double decay,
    int memory,
    int cells,
    double relax,
    double prior,
    Learn learn,
    boolean identified) {
  private static final int MAX_HORIZON = 1000;
  private static final int MAX_CELLS = 1_000_000;
  private static final double MAX_NUMBER = 1e9;

  /** Reads the parameters from the options of the policy. */
  static Parameters from(Options options) {
    return new Parameters(
        options.integer("horizon", 6, 1, MAX_HORIZON, "steps that views are compared by"),
        options.number("discount", 0.9, 0, 1, "weight of a step, compared with the one before"),
        options.number("search", 0.4, 0, MAX_NUMBER, "weight of targets that nobody sees"),
        options.integer("rounds", 2, 1, MAX_HORIZON, "how often cameras choose in turn at most"),
        options.number("lead", 0.1, 0, 1, "worth of a target with one camera less than it needs"),
        options.number("further", 0.2, 0, 1, "worth of one more camera where the least k counts"),
        options.number(
            "hold", 0.06, 0, MAX_NUMBER, "share of a camera's known targets that a move must add"),
        options.number("decay", 0.97, 0, 1, "weight of a target that was seen a step ago"),
        options.integer("memory", 30, 0, (int) MAX_NUMBER, "steps until a target is forgotten"),
        options.integer("cells", 2000, 1, MAX_CELLS, "cells of the search map, about"),
        options.number("relax", 0.15, 0, 1, "how fast the search map goes to the learned one"),
        options.number("prior", 50, 1e-6, MAX_NUMBER, "looks that the mean occupancy counts as"),
        options.choice(
            "learn",
            Learn.SIGHT,
            "where the model is wrong: sight (by place), bandit, sarsa (by view), none"),
        options.choice(
                "identity", Identity.KNOWN, "known: reports identify targets; none: they do not")
            == Identity.KNOWN);
  }

  /** The values that cameras learn, apart from where targets are. */
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
