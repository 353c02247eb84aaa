package org.hificamsim.ortools;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.ortools.sat.BoolVar;
import com.google.ortools.sat.CpModel;
import com.google.ortools.sat.CpSolver;
import com.google.ortools.sat.CpSolverStatus;
import com.google.ortools.sat.IntVar;
import com.google.ortools.sat.LinearExpr;
import com.google.ortools.sat.LinearExprBuilder;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hificamsim.cli.Main;
import org.hificamsim.solver.cover.CoverInstance;
import org.hificamsim.solver.cover.CoverPlan;
import org.hificamsim.solver.cover.CoverSearch;
import org.hificamsim.solver.cover.Effort;
import org.hificamsim.solver.cover.ExactMethod;
import org.hificamsim.solver.cover.Goal;
import org.hificamsim.solver.cover.SmallInstances;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Compares SCIP with all plans of small instances and with CP-SAT, and tests it in the command. */
class ScipTest {
  private static final int CASES = 60;
  private static final Path SCENARIOS = Path.of(System.getProperty("hificamsim.root"), "scenarios");

  @TempDir private Path folder;

  private static Effort exact() {
    return new Effort(
        1,
        0,
        Optional.of(new Scip()),
        new Effort.Limits(() -> true, () -> false, () -> false, () -> false));
  }

  private static CoverPlan solve(CoverInstance instance, Goal goal) {
    return CoverSearch.solve(instance, goal, exact(), (score, bound) -> {});
  }

  /** The score that SCIP finds without a search, bound or reduction before it. */
  private static double scoreAlone(CoverInstance instance, Goal goal) {
    int[] start =
        goal.isFullCover() ? IntStream.range(0, instance.candidates()).toArray() : new int[0];
    double bound = goal.isFullCover() ? 0 : instance.totalWorth();
    ExactMethod.Result found = new Scip().solve(instance, goal, start, bound, () -> false);
    assertEquals(goal.score(instance, found.chosen()), found.bound(), 1e-6);
    return goal.score(instance, found.chosen());
  }

  /** The best score that CP-SAT finds, for whole numbers. */
  private static double scoreOfCpSat(CoverInstance instance, Goal goal) {
    CpModel model = new CpModel();
    BoolVar[] chosen = new BoolVar[instance.candidates()];
    Arrays.setAll(chosen, candidate -> model.newBoolVar("x"));
    LinearExprBuilder worth = LinearExpr.newBuilder();
    for (int i = 0; i < instance.points(); i++) {
      int point = i;
      int needs = instance.needs()[point];
      IntVar times = model.newIntVar(goal.isFullCover() ? needs : 0, needs, "y");
      LinearExprBuilder covered = LinearExpr.newBuilder();
      IntStream.range(0, chosen.length)
          .filter(candidate -> Arrays.binarySearch(instance.covered()[candidate], point) >= 0)
          .forEach(candidate -> covered.add(chosen[candidate]));
      model.addLessOrEqual(times, covered);
      worth.addTerm(times, (long) instance.unitWorths()[point]);
    }
    LinearExprBuilder price = LinearExpr.newBuilder();
    IntStream.range(0, chosen.length)
        .forEach(
            candidate -> price.addTerm(chosen[candidate], (long) instance.prices()[candidate]));
    if (goal.isFullCover()) {
      model.minimize(price);
    } else {
      model.addLessOrEqual(price, (long) goal.budget());
      model.maximize(worth);
    }
    CpSolver solver = new CpSolver();
    solver.getParameters().setNumWorkers(1);
    assertEquals(CpSolverStatus.OPTIMAL, solver.solve(model));
    return solver.objectiveValue();
  }

  @Test
  void findsSameScoreAsCpSat() {
    SplittableRandom random = new SplittableRandom(5);
    for (int i = 0; i < 12; i++) {
      CoverInstance instance = SmallInstances.random(random, 60, 40, i % 2 == 0).coverable();
      Goal goal = i % 3 == 0 ? Goal.FULL_COVER : new Goal(3 + random.nextInt(6));
      CoverPlan plan = solve(instance, goal);
      assertTrue(plan.isProven(), "" + i);
      assertEquals(scoreOfCpSat(instance, goal), plan.score(), 1e-6, "" + i);
    }
  }

  @Test
  void provesBestOfAllPlans() {
    SplittableRandom random = new SplittableRandom(11);
    for (int i = 0; i < CASES; i++) {
      CoverInstance instance = SmallInstances.random(random, 12, 9, i % 2 == 0).coverable();
      Goal goal = i % 3 == 0 ? Goal.FULL_COVER : new Goal(1 + random.nextInt(6));
      double best = SmallInstances.best(instance, goal);
      CoverPlan plan = solve(instance, goal);
      assertTrue(plan.isProven(), "" + i);
      assertEquals(best, plan.score(), 1e-6, "" + i);
      assertEquals(best, scoreAlone(instance, goal), 1e-6, "" + i);
    }
  }

  @Test
  void provesPlanOfFractionalWorthsThatMultipliersDoNotProve() {
    SplittableRandom random = new SplittableRandom(2);
    CoverInstance plain = SmallInstances.random(random, 60, 40, false).coverable();
    double[] fractional = random.doubles(60).toArray();
    CoverInstance instance =
        new CoverInstance(fractional, plain.needs(), plain.covered(), plain.prices());
    CoverPlan plan = solve(instance, new Goal(9));
    assertTrue(plan.isProven(), plan.bound() + " " + plan.score());
    assertTrue(plan.multiplierBound().value() > plan.bound() + 1e-6);
    assertArrayEquals(plan.chosen(), solve(instance, new Goal(9)).chosen());
  }

  @Test
  void keepsPlanOfStartWhenStoppedAtOnce() {
    CoverInstance instance =
        SmallInstances.random(new SplittableRandom(3), 400, 300, false).coverable();
    Effort.Limits noTime = new Effort.Limits(() -> true, () -> true, () -> true, () -> true);
    Effort stopped = new Effort(1, 0, Optional.of(new Scip()), noTime);
    CoverPlan plan = CoverSearch.solve(instance, Goal.FULL_COVER, stopped, (score, bound) -> {});
    int[] counts = instance.counts(plan.chosen());
    assertTrue(IntStream.range(0, 400).allMatch(point -> counts[point] >= instance.needs()[point]));
    assertTrue(plan.bound() <= plan.score());
    plan = CoverSearch.solve(instance, new Goal(9), stopped, (score, bound) -> {});
    assertTrue(plan.bound() >= plan.score() && plan.multiplierBound().value() >= plan.bound());
  }

  @Test
  void commandProvesPlanAndVerifiesIt() throws IOException {
    Path plan = folder.resolve("plan");
    Path site = SCENARIOS.resolve("corridor.xml");
    String words =
        "--cameras 3 --catalogue site --cells 24 --candidates every=4 --method exact"
            + " --write-candidates";
    String output = run("place " + site + " " + words + " --out " + plan);
    assertTrue(output.contains("no plan of these is better"), output);
    Path summary = plan.resolve("summary.json");
    String text = Files.readString(summary);
    assertTrue(text.contains("\"proven\" : true"), text);
    assertTrue(run("place --verify " + plan + " --method exact").contains("holds"));
    Files.writeString(summary, text.replace("\"bound\" : ", "\"bound\" : 0.5, \"x\" : "));
    assertTrue(run("place --verify " + plan + " --method exact").contains("error: "));
  }

  private static String run(String words) {
    StringWriter out = new StringWriter();
    try (PrintWriter writer = new PrintWriter(out)) {
      Main.execute(writer, writer, words.split(" "));
    }
    return out.toString();
  }
}
