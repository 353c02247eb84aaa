package org.hificamsim.profiling.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.hifi.feature.Expression;
import org.hificamsim.profiling.fit.FitSettings.SymbolicSettings;
import org.hificamsim.profiling.measure.Measurement;
import org.junit.jupiter.api.Test;

class SymbolicRegressionTest {
  private static final SymbolicSettings SMALL = new SymbolicSettings(500, 25, 0.001, 4, 1);

  @Test
  void findsALawFromItsOperations() {
    List<Measurement> data = Synthetic.of((q, d, z) -> d * q + d / 2, 0.02, 2);
    FittedFeature fit = new SymbolicRegression(SMALL).fit(data);
    double[] observed = data.stream().mapToDouble(Measurement::response).toArray();
    double[] predicted = data.stream().mapToDouble(fit::response).toArray();
    assertTrue(FitScores.of(observed, predicted).r2() > 0.99, fit.equation());
    assertTrue(fit.equation().length() < 200, fit.equation());
  }

  @Test
  void onlyEqualSeedsGiveEqualFormulas() {
    List<Measurement> data = Synthetic.of((q, d, z) -> d * 0.2 - 10 * z, 0.1, 2);
    SymbolicSettings seed4 = new SymbolicSettings(100, 5, 0.001, 4, 1);
    SymbolicSettings seed5 = new SymbolicSettings(100, 5, 0.001, 5, 1);
    String first = new SymbolicRegression(seed4).fit(data).equation();
    assertEquals(first, new SymbolicRegression(seed4).fit(data).equation());
    assertTrue(!first.equals(new SymbolicRegression(seed5).fit(data).equation()));
  }

  /** Fits the law of a pinhole camera, which no short formula of + - * / equals. */
  @Test
  void restartsMakeSeedsMatterLess() {
    List<Measurement> data =
        Synthetic.of(
            (q, d, z) -> 2 * (Math.log10(d) - Math.log10(z) - Math.log10(q)) - 3.5, 0.05, 2);
    double[] once = new double[6];
    double[] often = new double[6];
    for (int seed = 0; seed < 6; seed++) {
      once[seed] = r2(data, new SymbolicSettings(100, 10, 0.001, seed, 1));
      often[seed] = r2(data, new SymbolicSettings(100, 10, 0.001, seed, 8));
    }
    double gained = min(often) - min(once);
    assertTrue(gained > 0.03, Arrays.toString(once) + " " + Arrays.toString(often));
    assertTrue(
        max(often) - min(often) < max(once) - min(once),
        Arrays.toString(once) + " " + Arrays.toString(often));
  }

  private static double r2(List<Measurement> data, SymbolicSettings settings) {
    FittedFeature fit = new SymbolicRegression(settings).fit(data);
    double[] observed = data.stream().mapToDouble(Measurement::response).toArray();
    return FitScores.of(observed, data.stream().mapToDouble(fit::response).toArray()).r2();
  }

  private static double min(double[] values) {
    return Arrays.stream(values).min().orElseThrow();
  }

  private static double max(double[] values) {
    return Arrays.stream(values).max().orElseThrow();
  }

  @Test
  void highParsimonyGivesShortFormulas() {
    List<Measurement> data = Synthetic.of((q, d, z) -> d * 0.2 - 10 * z - 2 * q, 0.1, 2);
    int free = length(data, 0);
    int costly = length(data, 0.1);
    assertTrue(costly < free, costly + " against " + free);
  }

  @Test
  void printedFormulaHasTheSameValues() {
    Formula q = new Formula.Variable("q", 0);
    Formula d = new Formula.Variable("d", 1);
    Formula z = new Formula.Variable("z", 2);
    Formula minus = Formula.Operation.of('-', q, Formula.Operation.of('-', d, z));
    Formula quotient = Formula.Operation.of('/', q, Formula.Operation.of('*', d, z));
    Formula negative = Formula.Operation.of('*', minus, new Formula.Constant(-0.5));
    Formula tiny = Formula.Operation.of('-', new Formula.Constant(-1.25e-7), quotient);
    assertEquals("q - (d - z)", minus.text());
    assertEquals("q/(d*z)", quotient.text());
    assertEquals("(q - (d - z))*(-0.5)", negative.text());
    double[] row = {0.3, 4, 0.05};
    for (Formula formula : List.of(minus, quotient, negative, tiny)) {
      assertEquals(
          formula.evaluate(row),
          Expression.parse(formula.text()).value(row[0], row[1], row[2]),
          1e-12,
          formula.text());
    }
  }

  @Test
  void foldsConstantsExceptDivisionByZero() {
    Formula one = new Formula.Constant(1);
    assertEquals("2", Formula.Operation.of('+', one, one).text());
    assertEquals("1/0", Formula.Operation.of('/', one, new Formula.Constant(0)).text());
  }

  private static int length(List<Measurement> data, double parsimony) {
    SymbolicSettings settings = new SymbolicSettings(300, 15, parsimony, 4, 1);
    return new SymbolicRegression(settings).fit(data).equation().length();
  }
}
