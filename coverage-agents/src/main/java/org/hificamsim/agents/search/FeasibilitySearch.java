package org.hificamsim.agents.search;

/**
 * Depth-first search for a choice that meets the coverage required of {@link Domains}, part by part
 * ({@link Parts}): each node either gives a camera a set or takes it away.
 */
final class FeasibilitySearch {
  private final Domains domains;
  private final Branching branching;
  private final Parts parts;
  private final CoverageProblem problem;
  private long mostNodes;
  private long nodes;

  FeasibilitySearch(CoverageProblem problem, Domains domains) {
    this.problem = problem;
    this.domains = domains;
    branching = new Branching(problem, domains);
    parts = new Parts(problem, domains);
  }

  /** Starts counting nodes. */
  void begin(long limit) {
    mostNodes = limit;
    nodes = 0;
  }

  /**
   * Looks for a choice within what the domains leave, and copies it.
   *
   * @return whether one was found; if not, none exists unless the search is {@link #exhausted}
   */
  boolean satisfy(Choice found) {
    parts.find();
    for (int part = 0; part < problem.targets(); part++) {
      if (parts.of()[part] == part && !settle(part)) {
        return false;
      }
    }
    found.copy(domains);
    return true;
  }

  private boolean settle(int part) {
    int set = branching.next(parts.of(), part);
    while (set >= 0) {
      if (exhausted()) {
        return false;
      }
      nodes++;
      int mark = domains.mark();
      if (domains.choose(set) && settle(part)) {
        return true;
      }
      domains.undo(mark);
      if (!domains.removeWithLesser(set)) {
        return false;
      }
      set = branching.next(parts.of(), part);
    }
    return true;
  }

  /** Whether the limit on nodes has been reached. */
  boolean exhausted() {
    return nodes >= mostNodes;
  }

  long nodes() {
    return nodes;
  }
}
