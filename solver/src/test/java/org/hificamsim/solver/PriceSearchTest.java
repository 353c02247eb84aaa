package org.hificamsim.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class PriceSearchTest {
  private static final double OPTIMUM = 3;

  /** A problem whose bound is 1 + the distance of its only price from {@link #OPTIMUM}. */
  private static final class OnePrice implements PriceSearch.Relaxation {
    private final PriceSearch search;
    private final List<Double> prices = new ArrayList<>();
    private final List<Double> paces = new ArrayList<>();
    private double price;
    private double bestPrice;
    private double enough;
    private int plans;

    private OnePrice(PriceSearch.Pace pace) {
      search = new PriceSearch(this, pace);
    }

    @Override
    public double solveParts() {
      prices.add(price);
      return 1 + Math.abs(price - OPTIMUM);
    }

    @Override
    public void keepPrices() {
      bestPrice = price;
    }

    @Override
    public void restorePrices() {
      price = bestPrice;
    }

    @Override
    public void improvePlan() {
      plans++;
    }

    @Override
    public boolean isDone() {
      return search.lowest() <= enough;
    }

    @Override
    public void changePrices() {
      paces.add(search.pace());
      price += 4 * search.pace() * Math.signum(OPTIMUM - price);
    }
  }

  @Test
  void returnsLowestBoundAndLeavesItsPrices() {
    OnePrice problem = new OnePrice(new PriceSearch.Pace(1, 1, 0.5, 1, false));
    double bound = problem.search.search(6);
    assertEquals(6, problem.prices.size());
    assertEquals(6, problem.plans);
    assertEquals(1 + Math.abs(problem.price - OPTIMUM), bound);
    assertEquals(bound, problem.search.lowest());
    assertTrue(bound < 1.5, problem.prices.toString());
  }

  @Test
  void paceFallsAfterRoundsWithoutLowerBound() {
    OnePrice problem = new OnePrice(new PriceSearch.Pace(1, 2, 0.5, 1, false));
    problem.search.search(8);
    assertEquals(List.of(0.0, 4.0, 0.0, 4.0, 2.0, 4.0), problem.prices.subList(0, 6));
    assertEquals(List.of(1.0, 1.0, 1.0, 0.5, 0.5, 0.25), problem.paces.subList(0, 6));
  }

  @Test
  void paceRisesAtLowerBoundToAtMostOne() {
    OnePrice problem = new OnePrice(new PriceSearch.Pace(0.125, 9, 0.5, 2, false));
    problem.price = -20;
    problem.search.search(5);
    assertEquals(List.of(0.25, 0.5, 1.0, 1.0), problem.paces);
  }

  @Test
  void goesOnFromBestPricesWhenPaceFalls() {
    OnePrice problem = new OnePrice(new PriceSearch.Pace(1, 2, 0.5, 1, true));
    problem.price = 4;
    problem.search.search(5);
    assertEquals(List.of(4.0, 0.0, 4.0, 2.0, 4.0), problem.prices);
  }

  @Test
  void endsWhenBoundIsLowEnough() {
    OnePrice problem = new OnePrice(new PriceSearch.Pace(1, 1, 0.5, 1, false));
    problem.enough = 2;
    assertEquals(2, problem.search.search(100));
    assertEquals(2, problem.prices.size());
    assertEquals(1, problem.search.round());
  }

  @Test
  void beginsAnewWithFirstPace() {
    OnePrice problem = new OnePrice(new PriceSearch.Pace(1, 1, 0.5, 1, false));
    problem.search.search(6);
    List<Double> paces = List.copyOf(problem.paces);
    problem.price = 0;
    problem.paces.clear();
    problem.search.search(6);
    assertEquals(paces, problem.paces);
  }
}
