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
 * The freight of an episode: which cargoes wait in a warehouse for which other one, who carries
 * them, and what is paid. A cargo that is delivered pays {@value #WORTH}, less 1 for each step in
 * which a camera saw who carried it. All targets begin with a load.
 */
final class Freight {
  private static final int WAREHOUSES = 4;
  private static final int WORTH = 100;
  private static final int CARGOES_EACH = 8;

  private final ArenaLayout arena;
  private final SplittableRandom random;
  private final int[][] waiting = new int[WAREHOUSES][WAREHOUSES];
  private final Carrier[] carriers;
  private final int cargoes;
  private int left;
  private int paid;

  Freight(ArenaLayout arena, SplittableRandom random) {
    this.arena = arena;
    this.random = random;
    carriers = new Carrier[arena.drawn().targets().size()];
    cargoes = CARGOES_EACH * carriers.length;
    left = cargoes;
  }

  /** What has not been loaded at the start waits, each for another warehouse. */
  private void fill() {
    int loaded = Arrays.stream(carriers).mapToInt(carrier -> carrier.load).sum();
    for (int i = loaded; i < cargoes; i++) {
      int from = random.nextInt(WAREHOUSES);
      waiting[from][other(from)]++;
    }
  }

  private int other(int warehouse) {
    return (warehouse + 1 + random.nextInt(WAREHOUSES - 1)) % WAREHOUSES;
  }

  /** One of some numbers, as likely as it is large; another one than this where all are 0. */
  private int drawn(int[] numbers, int here) {
    int sum = IntStream.of(numbers).sum();
    if (sum == 0) {
      return other(here);
    }
    int at = 0;
    for (int rest = random.nextInt(sum) - numbers[0]; rest >= 0; rest -= numbers[at]) {
      at++;
    }
    return at;
  }

  /** A step in which cameras saw some of the targets. */
  void charge(NetworkView network) {
    for (int target = 0; target < carriers.length; target++) {
      carriers[target].pay -= network.coverage(target) > 0 && carriers[target].pay > 0 ? 1 : 0;
    }
  }

  boolean delivered() {
    return left == 0;
  }

  /** What has been paid, as a part of the most. */
  double paid() {
    return (double) paid / (WORTH * cargoes);
  }

  /**
   * A greedy target: straight to the warehouse that its freight is for, with a swerve of up to half
   * its speed in x and in y, another one every ten steps or so.
   */
  final class Carrier implements Movement {
    static final String NAME = "Carrier";

    private static final double FAST = 20;
    private static final double WAREHOUSE = 925;
    private static final double HALF_WIDTH = 75;
    private static final double CHANGE = 0.1;

    private int goal;
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
      capacity = (int) (FAST / spec.speed());
      goal = random.nextInt(WAREHOUSES);
      take(capacity);
      if (target == carriers.length - 1) {
        fill();
      }
    }

    private void take(int cargo) {
      load = cargo;
      pay = WORTH * cargo;
    }

    /** With nothing to carry it goes to a warehouse where something waits. */
    private void arrive() {
      int here = goal;
      left -= load;
      paid += pay;
      int[] supplies = Arrays.stream(waiting).mapToInt(to -> IntStream.of(to).sum()).toArray();
      goal = drawn(supplies[here] > 0 ? waiting[here] : supplies, here);
      take(Math.min(capacity, waiting[here][goal]));
      waiting[here][goal] -= load;
    }

    @Override
    public void move(int target, Targets targets, RandomStreams streams) {
      double dx = (goal % 2 == 0 ? -WAREHOUSE : WAREHOUSE) - targets.x(target);
      double dy = (goal < 2 ? -WAREHOUSE : WAREHOUSE) - targets.y(target);
      if (Math.max(Math.abs(dx), Math.abs(dy)) <= HALF_WIDTH) {
        arrive();
        move(target, targets, streams);
        return;
      }
      if (streams.move().nextDouble() < CHANGE) {
        swerveX = streams.move().nextDouble() - 0.5;
        swerveY = streams.move().nextDouble() - 0.5;
      }
      double way = Math.hypot(dx, dy);
      double x = dx / way + swerveX;
      double y = dy / way + swerveY;
      double speed = targets.speed(target) / Math.max(1, Math.hypot(x, y));
      arena.step(target, targets, speed * x, speed * y);
    }
  }
}
