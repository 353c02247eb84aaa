package org.hificamsim.agents.search;

/**
 * The connected components of what is left of a problem: two unsatisfied targets belong to the same
 * one when some camera still has to decide about both, directly or through further targets.
 *
 * <p>What is chosen in one component has no influence on the others, so a search never goes back
 * from one to another.
 */
final class Components {
  /** The component of a target that is satisfied already. */
  static final int NONE = -1;

  private final CoverageProblem problem;
  private final Domains domains;
  private final int[] component;

  Components(CoverageProblem problem, Domains domains) {
    this.problem = problem;
    this.domains = domains;
    component = new int[problem.maxTargets()];
  }

  /** Finds the components; each is named by one of its targets. */
  void find() {
    for (int target = 0; target < problem.targets(); target++) {
      component[target] = domains.supply().lack(target) > 0 ? target : NONE;
    }
    for (int i = 0; i < domains.remaining().openCameras(); i++) {
      join(domains.remaining().openCamera(i));
    }
    for (int target = 0; target < problem.targets(); target++) {
      if (component[target] != NONE) {
        component[target] = root(target);
      }
    }
  }

  /** The component of a target. */
  int of(int target) {
    return component[target];
  }

  private void join(int camera) {
    int before = NONE;
    for (int word = 0; word < problem.words(); word++) {
      long bits = domains.supply().undecided(camera, word);
      for (; bits != 0; bits &= bits - 1) {
        int target = (word << 6) + Long.numberOfTrailingZeros(bits);
        if (component[target] != NONE) {
          if (before != NONE) {
            component[root(target)] = root(before);
          }
          before = target;
        }
      }
    }
  }

  private int root(int target) {
    int root = target;
    while (component[root] != root) {
      root = component[root];
    }
    return root;
  }
}
