package org.hificamsim.agents.search;

/**
 * The independent parts of what is left of a problem: two unsatisfied targets belong to the same
 * part when some camera still has to decide about both, directly or through further targets.
 *
 * <p>Each part is satisfiable or not whatever is chosen in the others, so a search need not go back
 * from one part to another.
 */
final class Parts {
  /** The part of a target that is satisfied already. */
  static final int NONE = -1;

  private final CoverageProblem problem;
  private final Domains domains;
  private final int[] part;

  Parts(CoverageProblem problem, Domains domains) {
    this.problem = problem;
    this.domains = domains;
    part = new int[problem.mostTargets()];
  }

  /** Finds the parts; each is named by one of its targets. */
  void find() {
    for (int target = 0; target < problem.targets(); target++) {
      part[target] = domains.supply().lack(target) > 0 ? target : NONE;
    }
    for (int i = 0; i < domains.remaining().openCameras(); i++) {
      join(domains.remaining().openCamera(i));
    }
    for (int target = 0; target < problem.targets(); target++) {
      if (part[target] != NONE) {
        part[target] = root(target);
      }
    }
  }

  /** The part of a target. */
  int of(int target) {
    return part[target];
  }

  private void join(int camera) {
    int before = NONE;
    for (int word = 0; word < problem.words(); word++) {
      long bits = domains.supply().undecided(camera, word);
      for (; bits != 0; bits &= bits - 1) {
        int target = (word << 6) + Long.numberOfTrailingZeros(bits);
        if (part[target] != NONE) {
          if (before != NONE) {
            part[root(target)] = root(before);
          }
          before = target;
        }
      }
    }
  }

  private int root(int target) {
    int root = target;
    while (part[root] != root) {
      root = part[root];
    }
    return root;
  }
}
