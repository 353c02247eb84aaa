package org.hificamsim.agents.search;

/**
 * Depth-first search for a choice that meets the coverage required of {@link Domains}, part by part
 * ({@link Parts}): each node either gives a camera a set or takes it away.
 */
final class FeasibilitySearch {
  /** How a search ended. */
  enum Outcome {
    FOUND,
    IMPOSSIBLE,
    UNDECIDED
  }

  private final CoverageProblem problem;
  private final Domains domains;
  private final Branching branching;
  private final Parts parts;
  private long lastNode;
  private long nodes;

  FeasibilitySearch(CoverageProblem problem, Domains domains) {
    this.problem = problem;
    this.domains = domains;
    branching = new Branching(problem, domains);
    parts = new Parts(problem, domains);
  }

  /** Counts nodes from 0 again. */
  void reset() {
    nodes = 0;
  }

  /** The number of nodes visited. */
  long nodes() {
    return nodes;
  }

  /**
   * Looks for a choice among what the domains leave and copies it into {@code found}. The domains
   * are left as the search left them.
   *
   * @param mostNodes number of nodes after which the outcome is undecided
   */
  Outcome search(long mostNodes, Choice found) {
    lastNode = mostNodes > Long.MAX_VALUE - nodes ? Long.MAX_VALUE : nodes + mostNodes;
    parts.find();
    for (int part = 0; part < problem.targets(); part++) {
      if (parts.of(part) == part && !settle(part)) {
        return nodes >= lastNode ? Outcome.UNDECIDED : Outcome.IMPOSSIBLE;
      }
    }
    found.copy(domains.remaining());
    return Outcome.FOUND;
  }

  private boolean settle(int part) {
    int set = branching.next(parts, part);
    while (set >= 0) {
      if (nodes >= lastNode) {
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
      set = branching.next(parts, part);
    }
    return true;
  }
}
