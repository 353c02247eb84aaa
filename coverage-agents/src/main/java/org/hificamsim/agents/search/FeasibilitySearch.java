package org.hificamsim.agents.search;

/**
 * Depth-first search for a choice that meets the coverage required of {@link Domains}, one of the
 * {@link Components} after the other: each node either gives a camera a set or takes it away.
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
  private final Components components;
  private long lastNode;
  private long nodes;

  FeasibilitySearch(CoverageProblem problem, Domains domains) {
    this.problem = problem;
    this.domains = domains;
    branching = new Branching(problem, domains);
    components = new Components(problem, domains);
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
   * @param maxNodes number of nodes after which the outcome is undecided
   */
  Outcome search(long maxNodes, Choice found) {
    lastNode = maxNodes > Long.MAX_VALUE - nodes ? Long.MAX_VALUE : nodes + maxNodes;
    components.find();
    for (int component = 0; component < problem.targets(); component++) {
      if (components.of(component) == component && !settle(component)) {
        return nodes >= lastNode ? Outcome.UNDECIDED : Outcome.IMPOSSIBLE;
      }
    }
    found.copy(domains.remaining());
    return Outcome.FOUND;
  }

  private boolean settle(int component) {
    int set = branching.next(components, component);
    while (set >= 0) {
      if (nodes >= lastNode) {
        return false;
      }
      nodes++;
      int mark = domains.mark();
      if (domains.choose(set) && settle(component)) {
        return true;
      }
      domains.undo(mark);
      if (!domains.removeWithLesser(set)) {
        return false;
      }
      set = branching.next(components, component);
    }
    return true;
  }
}
