package org.hificamsim.profiling.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.hificamsim.profiling.dataset.Covariate;
import org.hificamsim.profiling.measure.Measurement;
import org.junit.jupiter.api.Test;

/** What helps is told from what does not, on objects that were not seen. */
class CovariateFitTest {
  private static final FitSettings QUICK =
      new FitSettings(5, 0, new SymbolicSettings(50, 2, 0.001, 0), SupportVectorSettings.THESIS);

  @Test
  void lightThatCountsIsToldFromApertureThatDoesNot() {
    Random random = new Random(8);
    List<Measurement> rows = new ArrayList<>();
    for (Measurement m : new Photos().detector("d", p -> 0.2 + 0.3 * p).scatter(0, 0.02).take(3)) {
      double light = random.nextDouble();
      Map<Covariate, Double> covariates =
          Map.of(Covariate.LIGHT, 0.5 + light, Covariate.APERTURE, 2 + random.nextDouble());
      rows.add(with(m, m.confidence("d") + 0.15 * (light - 0.5), covariates));
    }
    FitResult result = new Fitting(QUICK).fit(Photos.CAMERA, rows, 2);
    List<CovariateFit> fits = CovariateFit.all(result, "d");
    assertEquals(
        List.of(Covariate.APERTURE, Covariate.LIGHT),
        fits.stream().map(CovariateFit::covariate).toList());
    CovariateFit light = fits.get(1);
    assertTrue(light.helps());
    assertEquals(0.15, light.weight().slope(), 0.02);
    assertTrue(light.weight().low() > 0.1 && light.weight().high() < 0.2, light.toString());
    assertTrue(light.with() > light.without() + 0.2, light.toString());
    CovariateFit aperture = fits.get(0);
    assertFalse(aperture.helps(), aperture.toString());
    assertTrue(aperture.weight().low() < 0 && aperture.weight().high() > 0, aperture.toString());
  }

  @Test
  void whatIsMissingSomewhereOrNeverVariesIsNotFitted() {
    List<Measurement> rows = new ArrayList<>();
    for (Measurement m : new Photos().detector("d", p -> 0.2 + 0.3 * p).take(3)) {
      Map<Covariate, Double> covariates =
          rows.isEmpty()
              ? Map.of(Covariate.APERTURE, 8.0)
              : Map.of(Covariate.APERTURE, 8.0, Covariate.LIGHT, rows.size() * 0.01);
      rows.add(with(m, m.confidence("d"), covariates));
    }
    FitResult result = new Fitting(QUICK).fit(Photos.CAMERA, rows, 2);
    assertEquals(List.of(), CovariateFit.all(result, "d"));
  }

  private static Measurement with(
      Measurement m, double confidence, Map<Covariate, Double> covariates) {
    return new Measurement(
        m.image(),
        m.object(),
        m.size(),
        m.distance(),
        m.focalLength(),
        m.pip(),
        Map.of("d", confidence),
        covariates);
  }
}
