package org.hificamsim.agents.search;

import org.hificamsim.agents.search.FeasibilitySearch.Outcome;

/**
 * Solves {@link CoverageProblem}s exactly: the largest k_min (Eq 7.1) that any choice of one set
 * per camera reaches, with proof, and the choice that the cameras' preferences single out.
 *
 * <p>An upper bound, lowered by target weights ({@link WeightTuning}) and by searches that prove a
 * coverage impossible ({@link FeasibilitySearch}), meets a choice found by {@link LocalSearch} or
 * by such a search; they take turns with growing effort. Where each camera has a set that holds all
 * its others, there is nothing to search ({@link WholeSets}). Of all choices that reach the
 * optimum, the result is the one that gives camera 0 its most preferred set, then camera 1, and so
 * on ({@link PreferredChoice}): it depends on the problem alone, not on how the search went, unless
 * that search itself is too hard. Nothing is allocated after construction.
 *
 * <p>The effort may be limited. Where the limit ends the search, the result is the best choice
 * found so far, {@link #bound} is what another one could reach at most, and {@link #proven} is
 * false. The limit counts search nodes, not time: the result stays reproducible.
 */
public final class CoverageSolver implements Solver {
  /** No limit: every result is proven. */
  public static final long UNLIMITED = Long.MAX_VALUE;

  private static final int ROUNDS = 12;
  private static final int PASSES = 4;
  private static final int NODES = 32;
  private static final int GROWTH = 4;
  private static final int MAX_HEURISTIC_EFFORT = 1 << 10;

  private final long maxNodes;
  private final Domains domains;
  private final Choice choice;
  private final WholeSets wholes;
  private final LocalSearch local;
  private final WeightTuning tuning;
  private final FeasibilitySearch search;
  private final PreferredChoice preferred;
  private int value;
  private int bound;

  /**
   * @param problem what each call of {@link #solve} reads
   * @param maxNodes number of search nodes after which a call gives up the proof; the search among
   *     equally good choices has a limit of its own
   */
  public CoverageSolver(CoverageProblem problem, long maxNodes) {
    this.maxNodes = maxNodes;
    domains = new Domains(problem);
    choice = new Choice(problem);
    wholes = new WholeSets(problem);
    local = new LocalSearch(problem, domains.remaining());
    tuning = new WeightTuning(problem);
    search = new FeasibilitySearch(problem, domains);
    preferred = new PreferredChoice(problem, domains, local, search);
  }

  @Override
  public void solve() {
    search.reset();
    if (wholes.give(choice)) {
      value = choice.least();
      bound = value;
      wholes.prefer(value, choice);
    } else {
      solveBySearch();
    }
  }

  private void solveBySearch() {
    choice.reset();
    value = choice.least();
    domains.reset();
    bound = domains.bound();
    if (value < bound) {
      closeGap();
      preferred.find(value, choice);
    }
  }

  private void closeGap() {
    tuning.reset();
    for (long effort = 1; value < bound && search.nodes() < maxNodes; effort *= GROWTH) {
      int heuristicEffort = (int) Math.min(effort, MAX_HEURISTIC_EFFORT);
      domains.weigh(tuning.tune(ROUNDS * heuristicEffort, value + 1));
      bound = Math.min(bound, domains.bound());
      if (value < bound) {
        local.reach(bound, PASSES * heuristicEffort, choice);
        value = choice.least();
      }
      if (value < bound) {
        decide(Math.min(NODES * effort, maxNodes - search.nodes()));
      }
    }
  }

  private void decide(long nodes) {
    Outcome outcome = domains.require(bound) ? search.search(nodes, choice) : Outcome.IMPOSSIBLE;
    domains.undo(0);
    switch (outcome) {
      case FOUND -> value = bound;
      case IMPOSSIBLE -> bound--;
      case UNDECIDED -> {}
    }
  }

  @Override
  public int chosen(int camera) {
    return choice.of(camera);
  }

  /** How many cameras cover the least covered target in the last solution. */
  public int value() {
    return value;
  }

  /** What no choice exceeds; equal to {@link #value} when the last solution is proven. */
  public int bound() {
    return bound;
  }

  @Override
  public boolean proven() {
    return value == bound;
  }

  @Override
  public double gap() {
    return bound - value;
  }

  /** The number of search nodes that the last call visited. */
  public long nodes() {
    return search.nodes();
  }
}
