package org.hificamsim.network.study;

import io.jenetics.Genotype;
import io.jenetics.IntegerChromosome;
import io.jenetics.IntegerGene;
import io.jenetics.Mutator;
import io.jenetics.Optimize;
import io.jenetics.Phenotype;
import io.jenetics.UniformCrossover;
import io.jenetics.engine.Engine;
import io.jenetics.ext.moea.NSGA2Selector;
import io.jenetics.ext.moea.UFTournamentSelector;
import io.jenetics.ext.moea.Vec;
import io.jenetics.util.ISeq;
import io.jenetics.util.RandomRegistry;
import io.jenetics.util.Seq;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.RunEngine;

/**
 * Searches for networks with high utility and few messages if there are too many to run them all.
 * Uses NSGA-II (Deb et al. 2002) of Jenetics, starting from the homogeneous networks. No network is
 * run twice.
 */
public final class NetworkSearch {
  private static final int POPULATION = 60;

  /**
   * The limit on generations, because a generation without new networks uses none of the budget.
   */
  private static final int GENERATIONS_PER_POPULATION = 20;

  private final NetworkChoice choice;
  private final RunPlan base;
  private final StudyResults results;
  private final RunEngine engine;
  private final Map<List<Integer>, Vec<double[]>> fitnessByGenes = new HashMap<>();
  private int budgetLeft;

  /**
   * @param results receives the results of the networks that are run
   */
  public NetworkSearch(NetworkChoice choice, RunPlan base, StudyResults results, RunEngine engine) {
    this.choice = choice;
    this.base = base;
    this.results = results;
    this.engine = engine;
  }

  /**
   * Runs up to {@code budget} networks in addition to the homogeneous ones; deterministic for a
   * seed.
   */
  public void run(int budget) throws IOException {
    budgetLeft = budget + choice.strategies().size();
    int genes = NetworkChoice.cameras(base);
    List<Genotype<IntegerGene>> first =
        IntStream.range(0, choice.strategies().size())
            .mapToObj(strategy -> Genotype.of(IntegerChromosome.of(uniformGenes(strategy, genes))))
            .toList();
    try {
      RandomRegistry.with(new Random(base.seed()), random -> evolve(genes, ISeq.of(first), budget));
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }

  private List<IntegerGene> uniformGenes(int strategy, int genes) {
    return IntStream.range(0, genes)
        .mapToObj(i -> IntegerGene.of(strategy, 0, choice.strategies().size()))
        .toList();
  }

  private long evolve(int genes, ISeq<Genotype<IntegerGene>> first, int budget) {
    Genotype<IntegerGene> pattern =
        Genotype.of(IntegerChromosome.of(0, choice.strategies().size(), genes));
    return new Engine.Builder<IntegerGene, Vec<double[]>>(this::evaluate, pattern)
            .optimize(Optimize.MAXIMUM)
            .populationSize(POPULATION)
            .alterers(new UniformCrossover<>(0.5), new Mutator<>(1.0 / genes))
            .offspringSelector(UFTournamentSelector.ofVec())
            .survivorsSelector(NSGA2Selector.ofVec())
            .executor(Runnable::run)
            .build()
            .stream(first)
            .takeWhile(generation -> budgetLeft > 0)
            .limit(
                GENERATIONS_PER_POPULATION
                    + (long) GENERATIONS_PER_POPULATION * budget / POPULATION)
            .count();
  }

  /** Runs the networks of a generation that were not run before, all in one call. */
  private ISeq<Phenotype<IntegerGene, Vec<double[]>>> evaluate(
      Seq<Phenotype<IntegerGene, Vec<double[]>>> generation) {
    Set<List<Integer>> asked = new LinkedHashSet<>();
    generation.forEach(network -> asked.add(genes(network)));
    List<List<Integer>> missing =
        asked.stream()
            .filter(genes -> !fitnessByGenes.containsKey(genes))
            .limit(budgetLeft)
            .toList();
    budgetLeft -= missing.size();
    try {
      if (!missing.isEmpty()) {
        results.run(missing.stream().map(this::plan).toList(), engine);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    missing.forEach(genes -> fitnessByGenes.put(genes, fitness(plan(genes))));
    Vec<double[]> beyondBudget = Vec.of(0, Double.NEGATIVE_INFINITY);
    return generation
        .map(
            network ->
                network.withFitness(fitnessByGenes.getOrDefault(genes(network), beyondBudget)))
        .asISeq();
  }

  private Vec<double[]> fitness(StudyPlan plan) {
    return Vec.of(results.mean(plan, Metric.UTILITY), -results.mean(plan, Metric.MESSAGES));
  }

  private StudyPlan plan(List<Integer> genes) {
    return choice.plan(base, genes.stream().map(choice.strategies()::get).toList());
  }

  private List<Integer> genes(Phenotype<IntegerGene, Vec<double[]>> network) {
    return network.genotype().chromosome().stream()
        .map(gene -> Math.min(gene.allele(), choice.strategies().size() - 1))
        .toList();
  }
}
