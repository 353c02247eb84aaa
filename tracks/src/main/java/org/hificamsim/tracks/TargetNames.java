package org.hificamsim.tracks;

import java.util.List;
import java.util.regex.Pattern;

/**
 * The numbers by which a scenario knows the targets of a recording: their own names where all are
 * whole numbers, else 1, 2, 3 in the order of appearance.
 */
final class TargetNames {
  private static final Pattern WHOLE = Pattern.compile("-?(0|[1-9][0-9]{0,14})");

  private final boolean own;

  TargetNames(List<TargetRecord> targets) {
    own = targets.stream().allMatch(one -> WHOLE.matcher(one.name()).matches());
  }

  /** Whether targets are known by the names that the file has. */
  boolean own() {
    return own;
  }

  double number(TargetRecord target) {
    return own ? Double.parseDouble(target.name()) : target.number() + 1;
  }
}
