package org.hificamsim.profiling.fit;

import io.jenetics.EliteSelector;
import io.jenetics.Genotype;
import io.jenetics.Mutator;
import io.jenetics.TournamentSelector;
import io.jenetics.engine.Codec;
import io.jenetics.engine.Engine;
import io.jenetics.engine.EvolutionResult;
import io.jenetics.ext.SingleNodeCrossover;
import io.jenetics.ext.util.Tree;
import io.jenetics.prog.ProgramChromosome;
import io.jenetics.prog.ProgramGene;
import io.jenetics.prog.op.EphemeralConst;
import io.jenetics.prog.op.MathOp;
import io.jenetics.prog.op.Op;
import io.jenetics.prog.op.Var;
import io.jenetics.util.ISeq;
import io.jenetics.util.RandomRegistry;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.LongStream;
import org.hificamsim.hifi.feature.Expression;
import org.hificamsim.hifi.feature.SymbolicAbstraction;
import org.hificamsim.profiling.fit.FitSettings.SymbolicSettings;
import org.hificamsim.profiling.measure.Measurement;

/**
 * Symbolic regression of {@code -log10(PIP)} by genetic programming (thesis 4.5.2), on Jenetics:
 * programs of + - * /, the predictors and constants in [-1, 1], selected by their mean squared
 * error plus a cost for every node.
 *
 * @param settings population, generations, parsimony and seed
 */
public record SymbolicRegression(SymbolicSettings settings) {
  private static final int FIRST_DEPTH = 3;
  private static final int MAX_NODES = 60;
  private static final int TOURNAMENT = 10;
  private static final double CROSSOVER = 0.9;
  private static final double MUTATION = 0.01;
  private static final int VALIDATION_FOLDS = 5;
  private static final long SEED_STRIDE = 1_000_003;

  private static final ISeq<Op<Double>> OPERATIONS =
      ISeq.of(MathOp.ADD, MathOp.SUB, MathOp.MUL, MathOp.DIV);
  private static final Map<Op<Double>, Character> SIGNS =
      Map.of(MathOp.ADD, '+', MathOp.SUB, '-', MathOp.MUL, '*', MathOp.DIV, '/');
  private static final List<String> VARIABLES = List.of("q", "d", "z");

  /** Fits photos; deterministic. */
  public FittedFeature fit(List<Measurement> photos) {
    String text = best(Measurement.predictors(photos), Measurement.responses(photos)).text();
    SymbolicAbstraction f = new SymbolicAbstraction(Expression.parse(text));
    return new FittedFeature(f, "-log10(PIP) = " + text, List.of());
  }

  /**
   * Returns the program of the only run, or the one of several runs with the least error on unseen
   * rows.
   */
  private Formula best(double[][] x, double[] y) {
    long[] seeds =
        LongStream.range(0, settings.restarts())
            .map(restart -> settings.seed() + restart * SEED_STRIDE)
            .toArray();
    if (seeds.length == 1) {
      return evolve(x, y, seeds[0]);
    }
    Groups folds = Groups.folds(y.length, VALIDATION_FOLDS, settings.seed());
    Formula best = null;
    double leastError = Double.POSITIVE_INFINITY;
    for (long seed : seeds) {
      int[] train = folds.others(0);
      Formula found = evolve(rows(train, x), Groups.select(train, y), seed);
      double error =
          error(found, rows(folds.rows().get(0), x), Groups.select(folds.rows().get(0), y));
      if (best == null || error < leastError) {
        best = found;
        leastError = error;
      }
    }
    return best;
  }

  private static double[][] rows(int[] rows, double[][] x) {
    return Groups.select(rows, List.of(x)).toArray(double[][]::new);
  }

  private Formula evolve(double[][] x, double[] y, long seed) {
    return RandomRegistry.with(
        new Random(seed),
        random -> {
          Genotype<ProgramGene<Double>> best =
              engine(x, y).stream()
                  .limit(settings.generations())
                  .collect(EvolutionResult.toBestGenotype());
          return formula(best.gene());
        });
  }

  private Engine<ProgramGene<Double>, Double> engine(double[][] x, double[] y) {
    Codec<ProgramGene<Double>, ProgramGene<Double>> codec =
        Codec.of(
            Genotype.of(
                ProgramChromosome.of(
                    FIRST_DEPTH,
                    program -> program.root().size() <= MAX_NODES,
                    OPERATIONS,
                    terminals())),
            Genotype::gene);
    return Engine.builder(program -> cost(program, x, y), codec)
        .minimizing()
        .populationSize(settings.population())
        .offspringSelector(new TournamentSelector<>(TOURNAMENT))
        .survivorsSelector(new EliteSelector<>())
        .offspringFraction(0.95)
        .alterers(new SingleNodeCrossover<>(CROSSOVER), new Mutator<>(MUTATION))
        .executor(Runnable::run)
        .build();
  }

  private static ISeq<Op<Double>> terminals() {
    return ISeq.of(
        Var.of("q", 0),
        Var.of("d", 1),
        Var.of("z", 2),
        EphemeralConst.of(() -> RandomRegistry.random().nextDouble() * 2 - 1));
  }

  /** Returns the mean squared error plus the cost of size; infinite if the program has no value. */
  private double cost(ProgramGene<Double> program, double[][] x, double[] y) {
    double cost = error(formula(program), x, y) + settings.parsimony() * program.size();
    return Double.isNaN(cost) ? Double.POSITIVE_INFINITY : cost;
  }

  private static double error(Formula formula, double[][] x, double[] y) {
    double sum = 0;
    for (int i = 0; i < y.length; i++) {
      double error = formula.evaluate(x[i]) - y[i];
      sum += error * error;
    }
    return sum / y.length;
  }

  private static Formula formula(Tree<? extends Op<Double>, ?> node) {
    Op<Double> op = node.value();
    if (op instanceof Var<Double> variable) {
      return new Formula.Variable(variable.name(), VARIABLES.indexOf(variable.name()));
    }
    if (op.arity() == 0) {
      return new Formula.Constant(op.apply(new Double[0]));
    }
    return Formula.Operation.of(SIGNS.get(op), formula(node.childAt(0)), formula(node.childAt(1)));
  }
}
