package org.hificamsim.agents.search;

/**
 * Solves {@link CoverageProblem}s exactly: the largest k_min (Eq 7.1) that any choice of one set
 * per camera reaches, with proof, and the choice that the cameras' preferences single out.
 *
 * <p>From an upper bound downwards, each coverage k is tested by a depth-first search with
 * constraint propagation ({@link Domains}); the first that can be met is the optimum. Of all
 * choices that meet it, the result is the one that gives camera 0 its most preferred set, then
 * camera 1, and so on: it depends on the problem alone, not on how the search went. Nothing is
 * allocated after construction.
 *
 * <p>The effort may be limited. Where the limit ends the search, the result is the best choice
 * found so far, {@link #bound} says how much better another one could be at most, and {@link
 * #proven} tells the two cases apart. The limit counts search nodes, not time: the result stays
 * reproducible.
 */
public final class CoverageSolver {
  /** No limit: every result is proven. */
  public static final long UNLIMITED = Long.MAX_VALUE;

  private final CoverageProblem problem;
  private final long mostNodes;
  private final Domains domains;
  private final FeasibilitySearch search;
  private final Choice choice;
  private int value;
  private int bound;

  /**
   * @param problem what each call of {@link #solve} reads
   * @param mostNodes number of search nodes after which a call gives up the proof
   */
  public CoverageSolver(CoverageProblem problem, long mostNodes) {
    this.problem = problem;
    this.mostNodes = mostNodes;
    domains = new Domains(problem);
    search = new FeasibilitySearch(problem, domains);
    choice = new Choice(problem);
  }

  /** Solves the problem as it is filled now. */
  public void solve() {
    domains.reset();
    choice.preferred();
    search.begin(mostNodes);
    value = choice.least();
    bound = domains.bound();
    while (bound > value && !reach(bound) && !search.exhausted()) {
      bound--;
    }
    value = choice.least();
    improve();
  }

  private boolean reach(int coverage) {
    domains.undo(0);
    return domains.require(coverage) && search.satisfy(choice);
  }

  private void improve() {
    domains.undo(0);
    domains.require(value);
    for (int i = 0; i < domains.openCameras(); i++) {
      settle(domains.openCamera(i));
    }
  }

  private void settle(int camera) {
    for (int set = problem.firstSet(camera); set < problem.endSet(camera); set++) {
      if (domains.alive(set)) {
        if (set == choice.of(camera) || choice.replace(camera, set, value) || canChoose(set)) {
          domains.choose(set);
          return;
        }
        domains.remove(set);
      }
    }
  }

  private boolean canChoose(int set) {
    int mark = domains.mark();
    boolean possible = domains.choose(set) && search.satisfy(choice);
    domains.undo(mark);
    return possible;
  }

  /** The number of the set that the camera chooses in the last solution. */
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

  /** Whether the last solution is proven to be the best. */
  public boolean proven() {
    return value == bound;
  }

  /** The number of search nodes that the last call visited. */
  public long nodes() {
    return search.nodes();
  }
}
