package org.hificamsim.solver;

/**
 * Looks for prices with a low bound (Lagrangian relaxation). Where what one part of a problem does
 * limits another part, the limit is replaced by a price, so that each part can be solved on its
 * own. Any prices give a bound of the whole; this search changes them round by round, keeps the
 * best, and changes them less when that brings no lower bound.
 */
public final class PriceSearch {
  /** A problem in parts, with prices; it decides in which direction its prices move. */
  public interface Relaxation {
    /** Solves all parts at the present prices; returns the bound, or what is to be lowered. */
    double solveParts();

    /** Keeps the present prices as the best ones. */
    void keepPrices();

    /** Returns to the best prices. */
    void restorePrices();

    /** Makes a plan from the solved parts, if there is a way to. */
    default void improvePlan() {}

    /** Whether lower bounds are of no use any more. */
    boolean isDone();

    /** Changes the prices after a round, by its solved parts. */
    void changePrices();
  }

  /**
   * How the pace of changes follows the bounds.
   *
   * @param first the pace at first, at most 1
   * @param patience the number of rounds without a lower bound after which the pace falls
   * @param slowdown by what the pace is multiplied then
   * @param speedup by what the pace is multiplied at a lower bound; it stays at most 1
   * @param returnsToBest whether the search goes on from the best prices when the pace falls
   */
  public record Pace(
      double first, int patience, double slowdown, double speedup, boolean returnsToBest) {
    /** For relaxations that follow the number of the round alone. */
    public static final Pace STEADY = new Pace(1, Integer.MAX_VALUE, 1, 1, false);
  }

  private final Relaxation relaxation;
  private final Pace rule;
  private double pace;
  private double value;
  private double lowest;
  private int round;
  private int idleRounds;

  /** Creates a search; {@link #search} or {@link #begin} comes next. */
  public PriceSearch(Relaxation relaxation, Pace rule) {
    this.relaxation = relaxation;
    this.rule = rule;
  }

  /**
   * Searches from the present prices, and leaves the best ones.
   *
   * @param rounds the greatest number of rounds, 1 or more
   * @return the lowest bound
   */
  public double search(int rounds) {
    begin();
    while (round + 1 < rounds && !relaxation.isDone()) {
      step();
    }
    relaxation.restorePrices();
    return lowest;
  }

  /** Makes the first round, with the present prices. */
  public void begin() {
    lowest = Double.POSITIVE_INFINITY;
    pace = rule.first;
    round = 0;
    idleRounds = 0;
    solve();
  }

  /** Changes the prices and makes another round. */
  public void step() {
    relaxation.changePrices();
    round++;
    solve();
  }

  private void solve() {
    value = relaxation.solveParts();
    if (value < lowest) {
      lowest = value;
      idleRounds = 0;
      pace = Math.min(1, pace * rule.speedup);
      relaxation.keepPrices();
    } else if (++idleRounds % rule.patience == 0) {
      pace *= rule.slowdown;
      if (rule.returnsToBest) {
        relaxation.restorePrices();
      }
    }
    relaxation.improvePlan();
  }

  /** The number of the present round; the first one is 0. */
  public int round() {
    return round;
  }

  /** The pace at which prices are to be changed, above 0 and at most 1. */
  public double pace() {
    return pace;
  }

  /** The bound of the present round. */
  public double value() {
    return value;
  }

  /** The lowest bound so far. */
  public double lowest() {
    return lowest;
  }
}
