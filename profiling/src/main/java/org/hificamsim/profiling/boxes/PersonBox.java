package org.hificamsim.profiling.boxes;

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

  double hidden() {
    return parts.hidden();
  }
}
