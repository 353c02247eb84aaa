package org.hificamsim.profiling.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.feature.PowerLawAbstraction;
import org.hificamsim.profiling.fit.FitSettings.SupportVectorSettings;
import org.hificamsim.profiling.measure.Measurement;
import org.junit.jupiter.api.Test;

class LeastSquaresRegressionsTest {
  private static final double NOISE = 0.2;

  @Test
  void linearRegressionRecoversItsCoefficientsWithinItsIntervals() {
    int covered = 0;
    double[] truth = {5, -2.0, 0.2, -18.82};
    for (int seed = 0; seed < 50; seed++) {
      List<Measurement> data =
          Synthetic.of((q, d, z) -> -18.82 * z - 2 * q + 0.2 * d + 5, NOISE, seed);
      FittedFeature fit = FeatureRegression.linear().fit(data);
      LinearAbstraction f = (LinearAbstraction) fit.f();
      assertEquals(-18.82, f.z(), 1.5);
      assertEquals(-2, f.q(), 0.25);
      assertEquals(0.2, f.d(), 0.015);
      for (int i = 0; i < truth.length; i++) {
        Coefficient c = fit.coefficients().get(i);
        covered += truth[i] >= c.low() && truth[i] <= c.high() ? 1 : 0;
      }
    }
    // 200 intervals of 95%: 190 expected, with a standard deviation of 3.
    assertTrue(covered >= 178 && covered <= 199, "covered " + covered);
  }

  @Test
  void standardErrorFollowsNoiseAndSpread() {
    List<Measurement> data = Synthetic.of((q, d, z) -> 0.2 * d + 5, NOISE, 1);
    Coefficient d = FeatureRegression.linear().fit(data).coefficients().get(2);
    // 480 distances 1 to 10: the sum of squares about their mean is 48 * 82.5.
    assertEquals(NOISE / Math.sqrt(48 * 82.5), d.error(), 0.0004);
  }

  @Test
  void powerRegressionRecoversExponents() {
    List<Measurement> data =
        Synthetic.of(
            (q, d, z) ->
                -(Math.log10(80) + 1.8 * Math.log10(z) + 1.9 * Math.log10(q)) + 2.1 * Math.log10(d),
            0.1,
            3);
    PowerLawAbstraction f = (PowerLawAbstraction) FeatureRegression.power().fit(data).f();
    assertEquals(1.8, f.a(), 0.05);
    assertEquals(1.9, f.b(), 0.05);
    assertEquals(2.1, f.e(), 0.05);
    assertEquals(Math.log10(80), Math.log10(f.c()), 0.1);
  }

  @Test
  void powerLawOfOneLensKeepsThePinholeExponent() {
    Synthetic.Law law =
        (q, d, z) ->
            -(Math.log10(3000) + 2 * Math.log10(z) + 2 * Math.log10(q)) + 1.9 * Math.log10(d);
    List<Measurement> all = Synthetic.of(law, 0.05, 3);
    List<Measurement> object = all.stream().filter(photo -> photo.size() == 0.3).toList();
    PowerLawAbstraction one = (PowerLawAbstraction) FeatureRegression.power().fit(object).f();
    assertEquals(2, one.b());
    assertEquals(2, one.a(), 0.1);
    assertEquals(1.9, one.e(), 0.1);
    List<Measurement> lens = all.stream().filter(photo -> photo.focalLength() == 0.05).toList();
    PowerLawAbstraction fixed = (PowerLawAbstraction) FeatureRegression.power().fit(lens).f();
    assertEquals(2, fixed.a());
    assertEquals(2, fixed.b(), 0.1);
    // At another size and another focal length both are right, which nobody measured.
    double truth = law.response(0.6, 5, 0.085);
    assertEquals(truth, -Math.log10(one.pip(0.6, 5, 0.085)), 0.1);
    assertEquals(truth, -Math.log10(fixed.pip(0.6, 5, 0.085)), 0.1);
  }

  @Test
  void everyRegressionFitsOneObjectAndOneLens() {
    List<Measurement> all = Synthetic.of((q, d, z) -> 4 - 2 * q + 0.2 * d - 15 * z, 0.05, 3);
    for (List<Measurement> rows :
        List.of(
            all.stream().filter(photo -> photo.size() == 0.3).toList(),
            all.stream().filter(photo -> photo.focalLength() == 0.05).toList())) {
      for (FeatureRegression regression :
          List.of(
              FeatureRegression.linear(),
              SupportVectors.linear(SupportVectorSettings.THESIS),
              SupportVectors.rbf(SupportVectorSettings.THESIS))) {
        FittedFeature fit = regression.fit(rows);
        double[] observed = rows.stream().mapToDouble(Measurement::response).toArray();
        double[] predicted = rows.stream().mapToDouble(fit::response).toArray();
        // svr-lin hardly uses z, whose values in metres are small, as in the thesis.
        double least = regression.name().equals("svr-lin") ? 0.5 : 0.9;
        assertTrue(FitScores.of(observed, predicted).r2() > least, regression.name());
      }
    }
  }

  @Test
  void recoversDetectorLineWithItsErrors() {
    double[] x = {0, 0.1, 0.2, 0.3, 0.4};
    double[] y = {0.03, 0.07, 0.14, 0.19, 0.24};
    LineFit fit = LineFit.of(x, y);
    // By hand: Sxx = 0.1, Sxy = 0.054, residuals 0.004 -0.010 0.006 0.002 -0.002.
    assertEquals(0.54, fit.slope().value(), 1e-12);
    assertEquals(0.026, fit.intercept().value(), 1e-12);
    assertEquals(0.00016, fit.sse(), 1e-12);
    assertEquals(Math.sqrt(0.00016 / 3), fit.rmse(), 1e-12);
    assertEquals(1 - 0.00016 / 0.02932, fit.r2(), 1e-12);
    assertEquals(Math.sqrt(0.00016 / 3 / 0.1), fit.slope().error(), 1e-12);
  }

  @Test
  void lineOnConstantPipIsTheMean() {
    LineFit fit = LineFit.of(new double[] {1, 1, 1}, new double[] {0.1, 0.2, 0.6});
    assertEquals(0, fit.slope().value());
    assertEquals(0.3, fit.intercept().value(), 1e-15);
    assertEquals(0, fit.r2(), 1e-15);
  }

  @Test
  void rejectsDataThatDetermineNoFit() {
    List<Measurement> same = java.util.Collections.nCopies(20, Synthetic.photo(0.3, 5, 0.05, 0.01));
    for (FeatureRegression regression :
        List.of(
            FeatureRegression.linear(),
            FeatureRegression.power(),
            SupportVectors.rbf(SupportVectorSettings.THESIS))) {
      InputException refused =
          assertThrows(InputException.class, () -> regression.fit(same), regression.name());
      assertTrue(refused.getMessage().contains("expected"), refused.getMessage());
    }
  }
}
