package org.hificamsim.agents.observation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the number, scale and bounds of the numbers of a layout. */
class ObservationLayoutTest {
  @Test
  void acceptsUpToAThousandTargetsAndNeighbours() {
    int own = new ObservationLayout(0, 0, false).size();
    assertEquals(own + 9000, new ObservationLayout(1000, 1000, false).size());
  }

  @ParameterizedTest
  @CsvSource({
    "-1, 0, observed targets is -1",
    "1001, 0, observed targets is 1001",
    "0, -1, observed neighbours is -1",
    "0, 1001, observed neighbours is 1001",
  })
  void rejectsNumbersOutOfRange(int targets, int neighbours, String message) {
    InputException error =
        assertThrows(InputException.class, () -> new ObservationLayout(targets, neighbours, false));
    assertEquals(message + ", expected 0 to 1000", error.getMessage());
  }

  @ParameterizedTest
  @CsvSource({"-2, -1, 0", "-1, -1, 0", "-0.5, -0.5, 0", "0.25, 0.25, 0.25", "1, 1, 1", "7, 1, 1"})
  void keepsNumbersWithinTheirBounds(double value, float signed, float share) {
    assertEquals(signed, Bounds.signed(value));
    assertEquals(share, Bounds.share(value));
  }

  @Test
  void nanBecomesZero() {
    assertEquals(0, Bounds.signed(Double.NaN));
    assertEquals(0, Bounds.share(Double.NaN));
  }

  @Test
  void centreOfCamerasIsZeroAndOutermostAreOne() {
    double[] x = {2, 4, 12};
    double[] y = {10, 11, 12};
    ToyNetwork network =
        new ToyNetwork(1, 1, 1, 1) {
          @Override
          public double cameraX(int camera) {
            return x[camera];
          }

          @Override
          public double cameraY(int camera) {
            return y[camera];
          }
        };
    ViewRows.Standpoints standpoints = new ViewRows.Standpoints(network);
    assertEquals(-1, standpoints.x(2));
    assertEquals(-0.6f, standpoints.x(4));
    assertEquals(1, standpoints.x(12));
    assertEquals(-0.2f, standpoints.y(10));
    assertEquals(0.2f, standpoints.y(12));
    assertEquals(0.5f, standpoints.difference(5));
  }
}
