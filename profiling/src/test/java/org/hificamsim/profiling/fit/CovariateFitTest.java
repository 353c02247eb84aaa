package org.hificamsim.profiling.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Condition;
import org.hificamsim.core.detection.Conditions;
import org.hificamsim.hifi.CovariateTerm;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.model.ModelFiles;
import org.hificamsim.profiling.dataset.Covariate;
import org.hificamsim.profiling.measure.Measurement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What helps is told from what does not, on objects that were not seen, and is in the models. */
class CovariateFitTest {
  private static final double WEIGHT = 1.5;
  private static final FitSettings QUICK =
      new FitSettings(5, 0, new SymbolicSettings(50, 2, 0.001, 0), SupportVectorSettings.THESIS);

  @Test
  void lightThatCountsIsToldFromApertureThatDoesNot() {
    FitResult result = fit(List.of("none"));
    List<CovariateFit> fits = CovariateFit.all(result, "d");
    assertEquals(
        List.of(Covariate.APERTURE, Covariate.LIGHT),
        fits.stream().map(CovariateFit::covariate).toList());
    CovariateFit light = fits.get(1);
    assertTrue(light.helps());
    assertEquals(WEIGHT, light.weight().slope(), 0.15);
    assertTrue(light.weight().low() > 1 && light.weight().high() < 2, light.toString());
    assertTrue(light.weight().low() < light.weight().slope(), light.toString());
    assertTrue(light.weight().high() > light.weight().slope(), light.toString());
    assertTrue(light.with() > light.without() + 0.03, light.toString());
    CovariateFit aperture = fits.get(0);
    assertFalse(aperture.helps(), aperture.toString());
    assertEquals(0, aperture.weight().slope(), 0.3);
    FittedModel.all(result).forEach(m -> assertEquals(List.of(), m.detection("p").covariates()));
  }

  @ParameterizedTest
  @ValueSource(strings = {"best", "light"})
  void modelsHaveWhatHelpsOrWhatIsNamed(String names) {
    FitResult plain = fit(List.of("none"));
    FitResult result = fit(List.of(names));
    HiFiDetection model = FittedModel.of(result, "d").get(0).detection("p");
    assertEquals("p:d-pinhole", model.name());
    CovariateTerm term = model.covariates().get(0);
    assertEquals(1, model.covariates().size());
    assertEquals(Condition.LIGHT, term.condition());
    assertEquals(WEIGHT, term.weight(), 0.15);
    assertEquals(1, term.mean(), 0.05);
    assertEquals(0.5, term.photographed().least(), 0.02);
    assertEquals(model, ModelFiles.parse("m", ModelFiles.bytes(model)));
    assertTrue(unseen(result) > unseen(plain) + 0.03, unseen(result) + " " + unseen(plain));
    assertEquals(Math.exp(-WEIGHT / 4), model.factor(light(0.75)), 0.04);
  }

  @Test
  void whatDoesNotHelpIsSaid() {
    String light = fit(List.of("light")).shifts("d").sentence("d").orElseThrow();
    assertTrue(
        light.matches("d depends on light: R2 unseen 0\\.99\\d .*, 0\\.9\\d+ without"), light);
    Shifts worse = new Shifts(fit(List.of("light")).shifts("d").all(), List.of(), 0.2, 0.6);
    assertTrue(worse.sentence("d").orElseThrow().endsWith("0.600 without; that does not help"));
    assertEquals(Optional.empty(), fit(List.of("none")).shifts("d").sentence("d"));
  }

  @Test
  void severalAreFittedTogether() {
    FitResult result = fit(List.of("light", "aperture", "light"));
    Shift shift = result.shifts("d").all();
    assertEquals(
        List.of(Covariate.APERTURE, Covariate.LIGHT),
        shift.terms().stream().map(Shift.Term::covariate).toList());
    assertEquals(0, shift.terms().get(0).weight(), 0.1);
    assertEquals(WEIGHT, shift.terms().get(1).weight(), 0.15);
  }

  @Test
  void whatIsUnseenHasNoPartInItsOwnWeight() {
    FitResult result = fit(List.of("light"));
    List<Shift> unseen = result.shifts("d").unseen();
    assertEquals(8, unseen.size());
    for (Shift without : unseen) {
      assertNotEquals(result.shifts("d").all(), without);
      assertEquals(WEIGHT, without.terms().get(0).weight(), 0.3);
    }
    Groups objects = result.unseen();
    ShapeFit g = result.model("d", FitResult.GROUND_TRUTH).chosen();
    int row = objects.rows().get(3)[7];
    double share = result.measuredPip()[row] * unseen.get(3).factor(result.measurements().get(row));
    assertEquals(g.fits().get(3).confidence(share), g.predicted()[row]);
  }

  @Test
  void whatIsMissingSomewhereOrNeverVariesIsNotFitted() {
    List<Measurement> rows = new ArrayList<>();
    for (Measurement m : new Photos().detector("d", p -> 0.2 + 0.3 * p).take(3)) {
      Map<Covariate, Double> covariates =
          rows.isEmpty()
              ? Map.of(Covariate.APERTURE, 8.0)
              : Map.of(Covariate.APERTURE, 8.0, Covariate.LIGHT, rows.size() * 0.01);
      rows.add(Photos.with(m, m.confidence("d"), covariates));
    }
    FitResult result = new Fitting(QUICK).fit(Photos.CAMERA, rows, 2);
    assertEquals(List.of(), CovariateFit.all(result, "d"));
    for (String name : List.of("aperture", "light", "distortion")) {
      Fitting named = new Fitting(QUICK.with(CovariateChoice.of(List.of(name))));
      InputException told =
          assertThrows(InputException.class, () -> named.fit(Photos.CAMERA, rows, 2));
      assertTrue(told.getMessage().contains("'" + name + "' is not known"), told.getMessage());
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"distinctiveness", "weather", "", "none"})
  void anotherNameIsRefused(String name) {
    InputException told =
        assertThrows(InputException.class, () -> CovariateChoice.of(List.of("light", name)), name);
    assertTrue(told.getMessage().endsWith("some of aperture, distortion, light"), name);
  }

  private static double unseen(FitResult result) {
    return result.model("d", "pinhole").chosen().unseen().r2();
  }

  private static Conditions light(double light) {
    return new Conditions(Double.NaN, Double.NaN, light);
  }

  /** Light counts, from 0.5 to 1.5; aperture does not. */
  private static FitResult fit(List<String> covariates) {
    Random random = new Random(8);
    List<Measurement> rows = new ArrayList<>();
    for (Measurement m : new Photos().detector("d", p -> p).take(3)) {
      double light = 0.5 + random.nextDouble();
      double share = m.pip() * Math.exp(WEIGHT * (light - 1));
      double confidence = 0.05 + 0.7 * (1 - Math.exp(-share / 0.02));
      rows.add(
          Photos.with(
              m,
              confidence + 0.02 * random.nextGaussian(),
              Map.of(Covariate.LIGHT, light, Covariate.APERTURE, 2 + random.nextDouble())));
    }
    FitSettings settings = QUICK.with(CovariateChoice.of(covariates));
    return new Fitting(settings).fit(Photos.CAMERA, rows, 2);
  }
}
