package org.hificamsim.profiling.boxes;

import java.util.List;
import java.util.Optional;
import org.hificamsim.core.silhouette.CoveredShare;
import org.hificamsim.profiling.check.Calibration.Size;

/**
 * The hidden shares of a labelled box, computed from exact unions of rectangles.
 *
 * @param byPeople the share that people in front of it cover: those whose feet are lower in the
 *     picture
 * @param byBorder the share that is outside the picture
 * @param hidden the share that the labels call invisible; without visibilities, the share that
 *     people or the border hide
 */
record HiddenParts(double byPeople, double byBorder, double hidden) {
  /** Returns the shares for one of the labels of a frame. */
  static HiddenParts of(List<LabelledBox> labels, int label, Optional<Size> picture) {
    LabelledBox person = labels.get(label);
    CoveredShare people = new CoveredShare();
    CoveredShare border = new CoveredShare();
    CoveredShare both = new CoveredShare();
    for (LabelledBox other : labels) {
      if (other.counted() && other.box().bottom() > person.box().bottom()) {
        cover(people, person.box(), other.box());
        cover(both, person.box(), other.box());
      }
    }
    Size size = picture.orElse(new Size(Double.MAX_VALUE, Double.MAX_VALUE));
    for (Box outside : outside(person.box(), size)) {
      cover(border, person.box(), outside);
      cover(both, person.box(), outside);
    }
    double visible = person.visibility();
    return new HiddenParts(
        people.share(), border.share(), Double.isNaN(visible) ? both.share() : 1 - visible);
  }

  /** Returns the four parts of a box that are outside the picture; their sizes may be below 0. */
  private static List<Box> outside(Box box, Size picture) {
    double right = Math.max(picture.width(), box.left());
    double bottom = Math.max(picture.height(), box.top());
    return List.of(
        new Box(box.left(), box.top(), -box.left(), box.height()),
        new Box(box.left(), box.top(), box.width(), -box.top()),
        new Box(right, box.top(), box.right() - right, box.height()),
        new Box(box.left(), bottom, box.width(), box.bottom() - bottom));
  }

  private static void cover(CoveredShare covered, Box box, Box front) {
    covered.add(
        (front.left() - box.left()) / box.width(),
        (front.top() - box.top()) / box.height(),
        (front.right() - box.left()) / box.width(),
        (front.bottom() - box.top()) / box.height());
  }
}
