package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.world.World;

/** The numbers of detections in the current step, by camera and by target. */
public final class Observation {
  private final Sight sight;
  private final LateDetections late;

  /** The processing budget; null if cameras process all that they see. */
  private final BudgetedSight budgeted;

  private final boolean hasPhantoms;
  private final int[] detected;
  private final int[] coverage;

  /** Scratch memory. */
  private final long[] found;

  /** The coverage in the order of the grid. */
  private final int[] gridCounts;

  Observation(World world, Sight sight, LateDetections late) {
    int cameras = world.cameras().count();
    int targets = world.targets().count();
    this.sight = sight;
    this.late = late;
    this.budgeted = late.isLimited() ? new BudgetedSight(world, sight, late) : null;
    this.hasPhantoms = sight.hasPhantoms();
    this.detected = new int[cameras];
    this.coverage = new int[targets];
    this.found = new long[targets + 1];
    this.gridCounts = new int[targets];
  }

  /** Lets every online camera look at the targets, each through the view that it sees through. */
  public void look() {
    if (budgeted != null) {
      budgeted.look(detected, coverage);
      return;
    }
    Arrays.fill(gridCounts, 0);
    sight.look(detected, gridCounts, found);
    Arrays.fill(coverage, 0);
    for (int i = 0; i < sight.grid().count(); i++) {
      coverage[sight.grid().point(i)] = gridCounts[i];
    }
  }

  /** The detections that come a step late; cameras that look by themselves add theirs. */
  public LateDetections late() {
    return late;
  }

  /** The part of the sight that cameras can process; null if they process all of it. */
  BudgetedSight budgeted() {
    return budgeted;
  }

  /** The number of targets that each camera detects, 0 while offline; one entry for each camera. */
  public int[] detected() {
    return detected;
  }

  /** The number of cameras that detect each target; one entry for each target. */
  public int[] coverage() {
    return coverage;
  }

  /** Adds the phantoms that a detection by chance reports; they cover no target. */
  void addPhantoms() {
    for (int camera = 0; hasPhantoms && camera < detected.length; camera++) {
      detected[camera] += sight.phantoms(camera);
    }
  }
}
