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
import org.hificamsim.placement.cover.CoverInstance;
import org.hificamsim.placement.cover.CoverPlan;
import org.hificamsim.placement.cover.CoverSearch;
import org.hificamsim.placement.cover.Effort;
import org.hificamsim.placement.cover.ExactMethod;
import org.hificamsim.placement.cover.Goal;
import org.hificamsim.placement.cover.SmallInstances;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The exact method beside all plans of small instances, alone, and in the command. */
class ScipTest {
  private static final int CASES = 60;
  private static final Path SCENARIOS = Path.of(System.getProperty("hificamsim.root"), "scenarios");

  @TempDir private Path folder;

  private static Effort exact() {
    return new Effort(1, 0, Optional.of(new Scip()), () -> true, () -> false, () -> false);
  }

  private static CoverPlan solve(CoverInstance instance, Goal goal) {
    return CoverSearch.solve(instance, goal, exact(), (score, bound) -> {});
  }

  /** The method without search, bound or reduction before it. */
  private static double alone(CoverInstance instance, Goal goal) {
    int[] start = goal.isAll() ? IntStream.range(0, instance.candidates()).toArray() : new int[0];
    double bound = goal.isAll() ? 0 : instance.total();
    ExactMethod.Found found = new Scip().solve(instance, goal, start, bound, () -> false);
    assertEquals(goal.score(instance, found.chosen()), found.bound(), 1e-6);
    return goal.score(instance, found.chosen());
  }

  /** The best score by CP-SAT, of whole numbers. */
  private static double cpSat(CoverInstance instance, Goal goal) {
    CpModel model = new CpModel();
    BoolVar[] taken = new BoolVar[instance.candidates()];
    Arrays.setAll(taken, j -> model.newBoolVar("x"));
    LinearExprBuilder worth = LinearExpr.newBuilder();
    for (int s = 0; s < instance.samples(); s++) {
      int sample = s;
      IntVar times =
          model.newIntVar(goal.isAll() ? instance.needs()[s] : 0, instance.needs()[s], "y");
      LinearExprBuilder seen = LinearExpr.newBuilder();
      IntStream.range(0, taken.length)
          .filter(j -> Arrays.binarySearch(instance.columns()[j], sample) >= 0)
          .forEach(j -> seen.add(taken[j]));
      model.addLessOrEqual(times, seen);
      worth.addTerm(times, (long) instance.units()[s]);
    }
    LinearExprBuilder price = LinearExpr.newBuilder();
    IntStream.range(0, taken.length)
        .forEach(j -> price.addTerm(taken[j], (long) instance.prices()[j]));
    if (goal.isAll()) {
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
  void findsWhatCpSatFindsAlone() {
    SplittableRandom random = new SplittableRandom(5);
    for (int i = 0; i < 12; i++) {
      CoverInstance instance = SmallInstances.random(random, 60, 40, i % 2 == 0).coverable();
      Goal goal = i % 3 == 0 ? Goal.ALL : new Goal(3 + random.nextInt(6));
      CoverPlan plan = solve(instance, goal);
      assertTrue(plan.isProven(), "" + i);
      assertEquals(cpSat(instance, goal), plan.score(), 1e-6, "" + i);
    }
  }

  @Test
  void provesTheBestOfAllPlans() {
    SplittableRandom random = new SplittableRandom(11);
    for (int i = 0; i < CASES; i++) {
      CoverInstance instance = SmallInstances.random(random, 12, 9, i % 2 == 0).coverable();
      Goal goal = i % 3 == 0 ? Goal.ALL : new Goal(1 + random.nextInt(6));
      double best = SmallInstances.best(instance, goal);
      CoverPlan plan = solve(instance, goal);
      assertTrue(plan.isProven(), "" + i);
      assertEquals(best, plan.score(), 1e-6, "" + i);
      assertEquals(best, alone(instance, goal), 1e-6, "" + i);
    }
  }

  @Test
  void provesOddWeightsAndClosesWhatMultipliersLeave() {
    SplittableRandom random = new SplittableRandom(2);
    CoverInstance plain = SmallInstances.random(random, 60, 40, false).coverable();
    double[] odd = random.doubles(60).toArray();
    CoverInstance instance = new CoverInstance(odd, plain.needs(), plain.columns(), plain.prices());
    CoverPlan plan = solve(instance, new Goal(9));
    assertTrue(plan.isProven(), plan.bound() + " " + plan.score());
    assertTrue(plan.relaxed() > plan.bound() + 1e-6);
    assertArrayEquals(plan.chosen(), solve(instance, new Goal(9)).chosen());
  }

  @Test
  void stopsAtOnceWithThePlanItHad() {
    CoverInstance instance =
        SmallInstances.random(new SplittableRandom(3), 400, 300, false).coverable();
    Effort stopped = new Effort(1, 0, Optional.of(new Scip()), () -> true, () -> true, () -> true);
    CoverPlan plan = CoverSearch.solve(instance, Goal.ALL, stopped, (score, bound) -> {});
    int[] counts = instance.counts(plan.chosen());
    assertTrue(IntStream.range(0, 400).allMatch(s -> counts[s] >= instance.needs()[s]));
    assertTrue(plan.bound() <= plan.score());
    plan = CoverSearch.solve(instance, new Goal(9), stopped, (score, bound) -> {});
    assertTrue(plan.bound() >= plan.score() && plan.relaxed() >= plan.bound());
  }

  @Test
  void theCommandSaysThatAPlanIsProvenAndTheCheckProvesItAgain() throws IOException {
    Path plan = folder.resolve("plan");
    Path site = SCENARIOS.resolve("corridor.xml");
    String words = "--cameras 3 --catalogue site --cells 24 --candidates every=4 --method exact";
    String said = run("place " + site + " " + words + " --out " + plan);
    assertTrue(said.contains("proven: no plan of these candidates is better"), said);
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
