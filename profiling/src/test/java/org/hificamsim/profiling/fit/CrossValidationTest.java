package org.hificamsim.profiling.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.feature.LinearAbstraction;
import org.junit.jupiter.api.Test;

class CrossValidationTest {
  private final List<Observation> data = Synthetic.of((q, d, z) -> 0.2 * d + 3, 0.3, 9);

  /** Keeps what it was trained with, and predicts a constant. */
  private static final class Spy implements FeatureRegression {
    private final List<Set<Observation>> trained = new ArrayList<>();

    @Override
    public String name() {
      return "spy";
    }

    @Override
    public FittedFeature fit(List<Observation> observations) {
      trained.add(new HashSet<>(observations));
      return new FittedFeature(new LinearAbstraction(0, 0, 0, trained.size()), "", List.of());
    }
  }

  @Test
  void everyRowIsPredictedOnceByAFitThatHasNotSeenIt() {
    Spy spy = new Spy();
    CrossValidation validation = CrossValidation.of(spy, data, 5, 0);
    assertEquals(5, spy.trained.size());
    for (int i = 0; i < data.size(); i++) {
      int fold = (int) validation.predicted()[i] - 1;
      assertFalse(spy.trained.get(fold).contains(data.get(i)));
    }
    spy.trained.forEach(rows -> assertEquals(384, rows.size()));
  }

  @Test
  void theSeedDealsTheFolds() {
    double[] first = CrossValidation.of(new LinearRegression(), data, 5, 1).predicted();
    assertArrayEquals(first, CrossValidation.of(new LinearRegression(), data, 5, 1).predicted());
    double[] other = CrossValidation.of(new LinearRegression(), data, 5, 2).predicted();
    assertFalse(java.util.Arrays.equals(first, other));
  }

  @Test
  void foldsTellHowMuchALineCaptures() {
    CrossValidation validation = CrossValidation.of(new LinearRegression(), data, 5, 0);
    // Var(0.2 d) is 0.33, the noise's 0.09.
    assertEquals(0.33 / 0.42, validation.mean(), 0.05);
    assertTrue(validation.deviation() < 0.1);
  }

  @Test
  void tooFewRowsAreRefused() {
    assertThrows(
        InputException.class,
        () -> CrossValidation.of(new LinearRegression(), data.subList(0, 9), 5, 0));
  }
}
