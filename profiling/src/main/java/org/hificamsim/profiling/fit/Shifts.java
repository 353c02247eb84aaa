package org.hificamsim.profiling.fit;

import java.util.Collections;
import java.util.List;

/**
 * What covariates do to the shares that one detector's g are asked at.
 *
 * @param all fitted to all photos
 * @param unseen fitted without each group
 */
public record Shifts(Shift all, List<Shift> unseen) {
  /** No covariates. */
  static Shifts none(Groups groups) {
    return new Shifts(Shift.NONE, Collections.nCopies(groups.count(), Shift.NONE));
  }
}
