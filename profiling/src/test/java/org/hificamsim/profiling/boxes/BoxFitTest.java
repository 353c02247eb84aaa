package org.hificamsim.profiling.boxes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.boxes.BoxDetection;
import org.hificamsim.hifi.boxes.FoundCurve;
import org.hificamsim.hifi.boxes.WidthEffect;
import org.hificamsim.hifi.model.ModelFiles;
import org.junit.jupiter.api.Test;

/** Tests fits to boxes that are drawn by a known curve. */
class BoxFitTest {
  private static final FoundCurve TRUE = new FoundCurve(1.5, 2, 5, 0, 1);
  private static final FoundCurve LIMITED = new FoundCurve(2, 4, 8, 0.1, 0.85);
  private static final FoundCurve NOISE = new FoundCurve(0.5, 0, 0, 0, 1);

  private static final double SHAPE = 1 / 3.0;
  private static final FoundCurve BY_WIDTH =
      new FoundCurve(1.5, 3, 5, 0, 1, new WidthEffect(2, SHAPE));

  /** Draws people, each with a height, who are hidden by chance. */
  private static MeasuredBoxes drawn(FoundCurve curve, int people, int frames, long seed) {
    return drawn(curve, people, frames, seed, 0);
  }

  /**
   * Draws people, each with a height, who are hidden by chance.
   *
   * @param spread the standard deviation of the logarithm of the shape
   */
  private static MeasuredBoxes drawn(
      FoundCurve curve, int people, int frames, long seed, double spread) {
    Random random = new Random(seed);
    List<PersonBox> boxes = new ArrayList<>();
    for (int person = 0; person < people; person++) {
      double height = 30 * Math.exp(2 * random.nextDouble());
      for (int frame = 0; frame < frames; frame++) {
        double hidden = random.nextBoolean() ? 0 : random.nextDouble();
        double shape = spread == 0 ? 1 : Math.exp(spread * random.nextGaussian());
        double width = height * SHAPE * shape;
        double chance = curve.found(height, width, hidden);
        boxes.add(
            new PersonBox(
                "made",
                10L * person + frame,
                "made:" + person,
                new Box(0, 0, width, height),
                new HiddenParts(hidden, 0, hidden),
                random.nextDouble() < chance ? 1 : 0));
      }
    }
    return new MeasuredBoxes(
        boxes, List.of(new RecordingCounts("made", boxes.size(), people, 100, 0.5, 50, 0)));
  }

  @Test
  void recoversKnownCurve() {
    FoundCurve curve = BoxFit.of(drawn(TRUE, 200, 40, 1)).curve();
    assertEquals(TRUE.intercept(), curve.intercept(), 0.15);
    assertEquals(TRUE.height(), curve.height(), 0.2);
    assertEquals(TRUE.hidden(), curve.hidden(), 0.4);
    assertEquals(0, curve.floor(), "data without a floor get none");
    assertEquals(1, curve.ceiling(), "data without a ceiling get none");
  }

  @Test
  void includesWidthIfItImprovesFit() {
    BoxFit fit = BoxFit.of(drawn(BY_WIDTH, 200, 20, 8, 0.3));
    WidthEffect width = fit.curve().width();
    assertEquals(BY_WIDTH.width().slope(), width.slope(), 0.25);
    assertEquals(SHAPE, width.usualShape(), 0.01);
    assertEquals(BY_WIDTH.height(), fit.curve().height(), 0.3);
    assertTrue(fit.width().contains("width of the boxes: counts"), fit.width());
    BoxDetection detection = fit.detection("mine");
    assertEquals(detection, ModelFiles.parse("mine.json", ModelFiles.bytes(detection)));
  }

  @Test
  void omitsWidthIfItDoesNotImproveFit() {
    BoxFit fit = BoxFit.of(drawn(TRUE, 60, 20, 9, 0.3));
    assertEquals(WidthEffect.NONE, fit.curve().width());
    assertTrue(fit.width().contains("left out"), fit.width());
    String file = new String(ModelFiles.bytes(fit.detection("mine")), StandardCharsets.UTF_8);
    assertFalse(file.contains("\"width\": {"), file);
  }

  @Test
  void neverFallsWithWidth() {
    FoundCurve reversed = new FoundCurve(1.5, 2, 5, 0, 1, new WidthEffect(-3, SHAPE));
    FoundCurve curve = BoxFit.of(drawn(reversed, 30, 20, 10, 0.3)).curve();
    for (double width = 10; width < 100; width += 10) {
      assertTrue(curve.found(100, width + 10, 0.3) >= curve.found(100, width, 0.3));
      assertTrue(curve.found(110, width, 0.3) >= curve.found(100, width, 0.3));
    }
  }

  @Test
  void findsFloorAndCeilingThatDataHave() {
    FoundCurve curve = BoxFit.of(drawn(LIMITED, 200, 30, 2)).curve();
    assertEquals(LIMITED.floor(), curve.floor(), 0.03);
    assertEquals(LIMITED.ceiling(), curve.ceiling(), 0.03);
  }

  @Test
  void rejectsNoiseAndNamesTheDetector() {
    int refused = 0;
    for (int seed = 0; seed < 10; seed++) {
      BoxFit fit = BoxFit.of(drawn(NOISE, 30, 20, seed));
      refused += fit.rejected() ? 1 : 0;
      assertTrue(fit.refusal("mine").contains("mine is no detector"));
    }
    assertTrue(refused >= 8, "refused: " + refused);
    assertFalse(BoxFit.of(drawn(TRUE, 30, 20, 3)).rejected());
  }

  @Test
  void neverFallsWithHeightNorRisesWithHiding() {
    FoundCurve reversed = new FoundCurve(1, -3, -4, 0, 1);
    FoundCurve curve = BoxFit.of(drawn(reversed, 30, 20, 4)).curve();
    for (double pixels = 10; pixels < 500; pixels += 10) {
      assertTrue(curve.found(pixels + 10, 0.3) >= curve.found(pixels, 0.3));
      assertTrue(curve.found(pixels, 0.9) <= curve.found(pixels, 0.1));
    }
  }

  @Test
  void readsBackModelFile() {
    MeasuredBoxes measured = drawn(TRUE, 30, 20, 5);
    BoxDetection detection = BoxFit.of(measured).detection("mine");
    assertEquals(detection, ModelFiles.parse("mine.json", ModelFiles.bytes(detection)));
    assertEquals(0.5, detection.falseAlarms());
    assertEquals(30, detection.fitted().orElseThrow().people());
  }

  @Test
  void endsCurveWhereEverybodyIsFound() {
    MeasuredBoxes measured = drawn(new FoundCurve(60, 0, 0, 0, 1), 10, 10, 6);
    BoxFit fit = BoxFit.of(measured);
    assertTrue(Double.isFinite(fit.curve().intercept()));
    assertTrue(fit.rejected(), "a constant is as good");
  }

  @Test
  void rejectsSinglePerson() {
    MeasuredBoxes measured = drawn(TRUE, 1, 10, 7);
    InputException refused = assertThrows(InputException.class, () -> BoxFit.of(measured));
    assertTrue(refused.getMessage().contains("expected two"), refused.getMessage());
  }
}
