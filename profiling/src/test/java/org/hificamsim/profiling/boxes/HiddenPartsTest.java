package org.hificamsim.profiling.boxes;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.hificamsim.profiling.check.Calibration.Size;
import org.junit.jupiter.api.Test;

/** Compares hidden shares of random boxes with a raster count. */
class HiddenPartsTest {
  private static final int RASTER = 200;
  private static final Size PICTURE = new Size(100, 100);

  private final Random random = new Random(56);

  @Test
  void agreesWithRasterCount() {
    for (int scene = 0; scene < 50; scene++) {
      List<LabelledBox> labels = new ArrayList<>();
      for (int i = 0; i < 2 + random.nextInt(8); i++) {
        Box box =
            new Box(
                -10 + 100 * random.nextDouble(),
                -10 + 100 * random.nextDouble(),
                5 + 40 * random.nextDouble(),
                5 + 60 * random.nextDouble());
        labels.add(new LabelledBox("" + i, box, Double.NaN, random.nextInt(5) > 0));
      }
      for (int label = 0; label < labels.size(); label++) {
        HiddenParts parts = HiddenParts.of(labels, label, Optional.of(PICTURE));
        assertEquals(raster(labels, label, true, false), parts.byPeople(), 0.01);
        assertEquals(raster(labels, label, false, true), parts.byBorder(), 0.01);
        assertEquals(raster(labels, label, true, true), parts.hidden(), 0.01);
      }
    }
  }

  private static double raster(
      List<LabelledBox> labels, int label, boolean people, boolean border) {
    Box box = labels.get(label).box();
    List<Box> lower =
        labels.stream()
            .filter(LabelledBox::counted)
            .map(LabelledBox::box)
            .filter(other -> other.bottom() > box.bottom())
            .toList();
    int hidden = 0;
    for (int i = 0; i < RASTER * RASTER; i++) {
      double x = box.left() + box.width() * (i % RASTER + 0.5) / RASTER;
      double y = box.top() + box.height() * (i / RASTER + 0.5) / RASTER;
      boolean outside = x < 0 || y < 0 || x > PICTURE.width() || y > PICTURE.height();
      boolean covered =
          lower.stream()
              .anyMatch(
                  other ->
                      x > other.left()
                          && x < other.right()
                          && y > other.top()
                          && y < other.bottom());
      hidden += (people && covered) || (border && outside) ? 1 : 0;
    }
    return hidden / (double) (RASTER * RASTER);
  }

  @Test
  void takesVisibilityOfLabels() {
    List<LabelledBox> labels = List.of(new LabelledBox("1", new Box(-5, 0, 10, 10), 0.4, true));
    assertEquals(0.6, HiddenParts.of(labels, 0, Optional.empty()).hidden());
    assertEquals(0.5, HiddenParts.of(labels, 0, Optional.empty()).byBorder());
  }
}
