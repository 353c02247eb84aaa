package org.hificamsim.profiling.boxes;

import org.hificamsim.hifi.boxes.FoundCurve;

/**
 * A person in a frame, and whether the detector found this person.
 *
 * @param recording the name of the recording
 * @param person the person's id in all recordings; the frame's, if labels have no ids
 * @param found 1 or 0
 */
public record PersonBox(
    String recording, long frame, String person, Box box, HiddenParts parts, int found) {
  double height() {
    return box.height();
  }

  double width() {
    return box.width();
  }

  /** The probability by a curve that this person is found. */
  double chance(FoundCurve curve) {
    return curve.found(height(), width(), hidden());
  }

  double hidden() {
    return parts.hidden();
  }
}
