package org.hificamsim.tracks.mate;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.RandomStreams;
import org.hificamsim.core.world.Targets;

/**
 * The freight of an episode: the cargoes that wait in each warehouse, by destination, the targets
 * that carry them, and their pay. A delivered cargo pays {@value #CARGO_PAY}, less 1 for each step
 * in which a camera saw its carrier. All targets begin with a load.
 */
final class Freight {
  private static final int WAREHOUSES = 4;
  private static final int CARGO_PAY = 100;
  private static final int CARGOES_PER_TARGET = 8;

  private final ArenaLayout arena;
  private final SplittableRandom random;
  private final int[][] waiting = new int[WAREHOUSES][WAREHOUSES];
  private final Carrier[] carriers;
  private final int cargoes;
  private int undelivered;
  private int totalPay;

  Freight(ArenaLayout arena, SplittableRandom random) {
    this.arena = arena;
    this.random = random;
    carriers = new Carrier[arena.scenario().targets().size()];
    cargoes = CARGOES_PER_TARGET * carriers.length;
    undelivered = cargoes;
  }

  /** Distributes the cargoes that are not loaded at the start among the warehouses. */
  private void fillWarehouses() {
    int loaded = Arrays.stream(carriers).mapToInt(carrier -> carrier.load).sum();
    for (int i = loaded; i < cargoes; i++) {
      int from = random.nextInt(WAREHOUSES);
      waiting[from][otherWarehouse(from)]++;
    }
  }

  private int otherWarehouse(int warehouse) {
    return (warehouse + 1 + random.nextInt(WAREHOUSES - 1)) % WAREHOUSES;
  }

  /**
   * Draws an index with probabilities in proportion to numbers; any warehouse other than {@code
   * here} if all numbers are 0.
   */
  private int draw(int[] numbers, int here) {
    int sum = IntStream.of(numbers).sum();
    if (sum == 0) {
      return otherWarehouse(here);
    }
    int index = 0;
    for (int rest = random.nextInt(sum) - numbers[0]; rest >= 0; rest -= numbers[index]) {
      index++;
    }
    return index;
  }

  /** Reduces the pay of the targets that cameras see in a step. */
  void charge(NetworkView network) {
    for (int target = 0; target < carriers.length; target++) {
      carriers[target].pay -= network.coverage(target) > 0 && carriers[target].pay > 0 ? 1 : 0;
    }
  }

  boolean isDelivered() {
    return undelivered == 0;
  }

  /** The pay so far, as a share of the greatest possible pay. */
  double payShare() {
    return (double) totalPay / (CARGO_PAY * cargoes);
  }

  /**
   * A greedy target. It moves straight to the destination of its load, with a random swerve of up
   * to half its speed in x and in y, which changes about every ten steps.
   */
  final class Carrier implements Movement {
    static final String NAME = "Carrier";

    private static final double FAST_SPEED = 20;
    private static final double WAREHOUSE = 925;
    private static final double HALF_WIDTH = 75;
    private static final double SWERVE_CHANGE_PROBABILITY = 0.1;

    private int destination;
    private int load;
    private int pay;
    private int capacity;
    private double swerveX;
    private double swerveY;

    @Override
    public String name() {
      return NAME;
    }

    @Override
    public void start(int target, Targets targets, TargetSpec spec) {
      carriers[target] = this;
      capacity = (int) (FAST_SPEED / spec.speed());
      destination = random.nextInt(WAREHOUSES);
      load(capacity);
      if (target == carriers.length - 1) {
        fillWarehouses();
      }
    }

    private void load(int cargoes) {
      load = cargoes;
      pay = CARGO_PAY * cargoes;
    }

    /** Delivers the load and takes another one; if there is none, goes to where cargoes wait. */
    private void arrive() {
      int here = destination;
      undelivered -= load;
      totalPay += pay;
      int[] supplies =
          Arrays.stream(waiting).mapToInt(cargoesTo -> IntStream.of(cargoesTo).sum()).toArray();
      destination = draw(supplies[here] > 0 ? waiting[here] : supplies, here);
      load(Math.min(capacity, waiting[here][destination]));
      waiting[here][destination] -= load;
    }

    @Override
    public void move(int target, Targets targets, RandomStreams streams) {
      double dx = (destination % 2 == 0 ? -WAREHOUSE : WAREHOUSE) - targets.x(target);
      double dy = (destination < 2 ? -WAREHOUSE : WAREHOUSE) - targets.y(target);
      if (Math.max(Math.abs(dx), Math.abs(dy)) <= HALF_WIDTH) {
        arrive();
        move(target, targets, streams);
        return;
      }
      if (streams.move().nextDouble() < SWERVE_CHANGE_PROBABILITY) {
        swerveX = streams.move().nextDouble() - 0.5;
        swerveY = streams.move().nextDouble() - 0.5;
      }
      double distance = Math.hypot(dx, dy);
      double x = dx / distance + swerveX;
      double y = dy / distance + swerveY;
      double speed = targets.speed(target) / Math.max(1, Math.hypot(x, y));
      arena.step(target, targets, speed * x, speed * y);
    }
  }
}
