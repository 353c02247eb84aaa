package org.hificamsim.hifi;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.hificamsim.core.detection.DetectedDistances;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;
import org.junit.jupiter.api.DynamicContainer;
import org.junit.jupiter.api.DynamicTest;

/**
 * Tests that every {@link DetectionModel} must pass. Call it from a {@code @TestFactory} with a
 * supplier of the model.
 */
public final class DetectionModelContract {
  private static final double[] SIZES = {1e-3, 0.1, 0.66, 5};
  private static final double[] BEARINGS = {0, 0.3, Math.PI / 2, Math.PI, Double.NaN};
  private static final double[] HEIGHTS = {Double.NaN, 0.5, 10};
  private static final double[][] RADII = {{2.5, 3.75, 5, 6.25, 7.5}, {0, 2, 4}, {10}};

  private record Case(double size, double distance, ZoomLevel zoom) {
    double confidence(DetectionModel model, double offAxis) {
      return model.confidence(size, distance, offAxis, zoom);
    }
  }

  private final Supplier<? extends DetectionModel> maker;
  private final List<Case> cases = new ArrayList<>();

  private DetectionModelContract(Supplier<? extends DetectionModel> maker) {
    this.maker = maker;
    for (double[] radii : RADII) {
      for (double height : HEIGHTS) {
        for (double radius : radii) {
          addCases(new ZoomLevel(radius, radii[0], radii[radii.length - 1], height, 2 * Math.PI));
        }
      }
    }
  }

  /** Returns the tests of the contract for the model of this name. */
  public static DynamicContainer of(String name, Supplier<? extends DetectionModel> maker) {
    DetectionModelContract contract = new DetectionModelContract(maker);
    return DynamicContainer.dynamicContainer(name, contract.tests(name));
  }

  private Stream<DynamicTest> tests(String name) {
    return Stream.of(
        dynamicTest("hasTheNameOfItsRegistration", () -> assertEquals(name, maker.get().name())),
        dynamicTest("givesANumberForEveryLegalInput", this::givesANumber),
        dynamicTest("givesTheSameTwice", this::givesTheSameTwice),
        dynamicTest("ignoresBearingUnlessDeclared", this::ignoresBearing),
        dynamicTest("hasAUsableDefaultThreshold", this::hasUsableThreshold),
        dynamicTest("detectsOnlyWithinTheRadius", this::detectsWithinTheRadius));
  }

  private void givesANumber() {
    DetectionModel model = maker.get();
    for (Case c : cases) {
      double value = c.confidence(model, 0);
      assertTrue(Double.isFinite(value), () -> c + " gives " + value);
    }
  }

  private void givesTheSameTwice() {
    DetectionModel first = maker.get();
    DetectionModel second = maker.get();
    for (Case c : cases) {
      assertEquals(c.confidence(first, 0), c.confidence(first, 0), c::toString);
      assertEquals(c.confidence(first, 0), c.confidence(second, 0), c::toString);
    }
  }

  private void ignoresBearing() {
    DetectionModel model = maker.get();
    if (model.dependsOnBearing()) {
      return;
    }
    for (Case c : cases) {
      for (double bearing : BEARINGS) {
        assertEquals(c.confidence(model, 0), c.confidence(model, bearing), c::toString);
      }
    }
  }

  private void hasUsableThreshold() {
    assertTrue(Double.isFinite(maker.get().defaultThreshold()));
  }

  private void detectsWithinTheRadius() {
    DetectionModel model = maker.get();
    if (model.dependsOnBearing()) {
      return;
    }
    ZoomLevel zoom = new ZoomLevel(5, 2.5, 7.5, Double.NaN, 2 * Math.PI);
    DetectedDistances distances = DetectedDistances.of(model, 0.66, zoom, model.defaultThreshold());
    assertFalse(distances.contains(25.0001));
  }

  private void addCases(ZoomLevel zoom) {
    for (double size : SIZES) {
      for (double share : new double[] {0, 1e-12, 0.1, 0.5, 1}) {
        cases.add(new Case(size, share * zoom.radius(), zoom));
      }
    }
  }
}
