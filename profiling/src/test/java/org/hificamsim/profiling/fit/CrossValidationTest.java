package org.hificamsim.profiling.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.profiling.fit.FitSettings.SupportVectorSettings;
import org.hificamsim.profiling.fit.FitSettings.SymbolicSettings;
import org.hificamsim.profiling.measure.Measurement;
import org.junit.jupiter.api.Test;

class CrossValidationTest {
  private final List<Measurement> data = Synthetic.of((q, d, z) -> 0.2 * d + 3, 0.3, 9);

  private CrossValidation folds(FeatureRegression regression, List<Measurement> photos, long seed) {
    return FeatureResult.all(List.of(regression), photos, Groups.folds(photos.size(), 5, seed), 1)
        .get(0)
        .validation();
  }

  @Test
  void predictsEveryRowOnceByAFitWithoutThatRow() {
    List<Set<Measurement>> trained = new ArrayList<>();
    FeatureRegression spy =
        new FeatureRegression(
            "spy",
            photos -> {
              trained.add(new HashSet<>(photos));
              return new FittedFeature(
                  new LinearAbstraction(0, 0, 0, trained.size() - 1), "", List.of());
            });
    CrossValidation validation = folds(spy, data, 0);
    assertEquals(1 + 5 + Synthetic.LENGTHS.length, trained.size(), "all, folds and lenses");
    for (int i = 0; i < data.size(); i++) {
      int fold = (int) validation.predicted()[i];
      assertFalse(trained.get(fold).contains(data.get(i)));
      assertEquals(384, trained.get(fold).size());
    }
  }

  @Test
  void seedDeterminesTheFolds() {
    FeatureRegression line = FeatureRegression.linear();
    double[] first = folds(line, data, 1).predicted();
    assertArrayEquals(first, folds(line, data, 1).predicted());
    assertFalse(java.util.Arrays.equals(first, folds(line, data, 2).predicted()));
  }

  @Test
  void foldsMeasureHowWellLineFits() {
    CrossValidation validation = folds(FeatureRegression.linear(), data, 0);
    // Var(0.2 d) is 0.33, the noise's 0.09.
    assertEquals(0.33 / 0.42, validation.mean(), 0.05);
    assertTrue(validation.deviation() < 0.1);
  }

  @Test
  void rejectsTooFewRows() {
    FitSettings settings =
        new FitSettings(
            5,
            0,
            new SymbolicSettings(50, 1, 0.001, 0, 1),
            SupportVectorSettings.THESIS,
            Optional.empty(),
            Map.of());
    assertThrows(
        InputException.class,
        () -> new Fitting(settings).fit(Photos.CAMERA, data.subList(0, 9), 1));
  }
}
