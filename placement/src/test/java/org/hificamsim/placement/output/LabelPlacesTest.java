package org.hificamsim.placement.output;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests the places of labels. */
class LabelPlacesTest {
  private static final Rectangle2D AREA = new Rectangle2D.Double(0, 0, 400, 300);

  @Test
  void labelsOfCloseCamerasDoNotCollide() {
    LabelPlaces places = new LabelPlaces(AREA);
    List<Rectangle2D> labels = new ArrayList<>();
    for (int number = 0; number < 8; number++) {
      Point2D camera = new Point2D.Double(396, 150 + 3 * number);
      places.avoid(camera, 5);
    }
    for (int number = 0; number < 8; number++) {
      labels.add(places.place(new Point2D.Double(396, 150 + 3 * number), 24, 15));
    }
    for (Rectangle2D label : labels) {
      assertTrue(AREA.contains(label), label::toString);
      for (Rectangle2D other : labels) {
        assertFalse(label != other && label.intersects(other), label + " and " + other);
      }
    }
  }
}
