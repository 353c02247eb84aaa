package org.hificamsim.tracks.mate;

import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.scenario.TargetSpec;

/**
 * The freight of an episode: which cargoes wait in a warehouse for which other one, what targets
 * carry, and what they are paid. A cargo that is delivered pays {@value #WORTH}, less 1 for each
 * step in which a camera saw who carried it.
 */
final class Freight {
  static final int WAREHOUSES = 4;

  /** How many cargoes a target of capacity 1 carries at this speed. */
  private static final double SPEED = 20;

  private static final int WORTH = 100;
  private static final int CARGOES_EACH = 8;

  private final SplittableRandom random;
  private final int[][] waiting = new int[WAREHOUSES][WAREHOUSES];
  private final int[] capacity;
  private final int[] goal;
  private final int[] load;
  private final int[] pay;
  private final int cargoes;
  private int delivered;
  private int paid;

  /** All targets begin with a load, to a warehouse each. */
  Freight(List<TargetSpec> targets, SplittableRandom random) {
    this.random = random;
    capacity = targets.stream().mapToInt(one -> (int) (SPEED / one.speed())).toArray();
    cargoes = CARGOES_EACH * capacity.length;
    goal = new int[capacity.length];
    load = new int[capacity.length];
    pay = new int[capacity.length];
    int left = cargoes;
    for (int target = 0; target < capacity.length; target++) {
      goal[target] = random.nextInt(WAREHOUSES);
      carry(target, capacity[target]);
      left -= capacity[target];
    }
    for (int i = 0; i < left; i++) {
      int from = random.nextInt(WAREHOUSES);
      waiting[from][other(from)]++;
    }
  }

  /** One of the other warehouses. */
  private int other(int warehouse) {
    return (warehouse + 1 + random.nextInt(WAREHOUSES - 1)) % WAREHOUSES;
  }

  private void carry(int target, int cargo) {
    load[target] = cargo;
    pay[target] = WORTH * cargo;
  }

  /** The warehouse that a target is to go to. */
  int goal(int target) {
    return goal[target];
  }

  /** Takes what a target at its goal has, and gives it what is to go on from there. */
  void arrive(int target) {
    int here = goal[target];
    delivered += load[target];
    paid += load[target] > 0 ? pay[target] : 0;
    int there = drawn(waiting[here]);
    goal[target] = there < 0 ? supplied(here) : there;
    int cargo = there < 0 ? 0 : Math.min(capacity[target], waiting[here][there]);
    carry(target, cargo);
    if (there >= 0) {
      waiting[here][there] -= cargo;
    }
  }

  /** One of some numbers, as likely as it is large; -1 where all are 0. */
  private int drawn(int[] numbers) {
    int sum = 0;
    for (int number : numbers) {
      sum += number;
    }
    int left = sum == 0 ? -1 : random.nextInt(sum);
    int at = -1;
    while (left >= 0) {
      left -= numbers[++at];
    }
    return at;
  }

  /** Another warehouse that has cargoes; any other where none has. */
  private int supplied(int here) {
    int[] left = new int[WAREHOUSES];
    for (int from = 0; from < WAREHOUSES; from++) {
      for (int to = 0; to < WAREHOUSES; to++) {
        left[from] += waiting[from][to];
      }
    }
    int there = drawn(left);
    return there < 0 ? other(here) : there;
  }

  /** A step in which cameras saw some of the targets. */
  void charge(NetworkView network) {
    for (int target = 0; target < pay.length; target++) {
      if (network.coverage(target) > 0 && pay[target] > 0) {
        pay[target]--;
      }
    }
  }

  boolean delivered() {
    return delivered >= cargoes;
  }

  /** What has been paid, as a part of the most. */
  double paid() {
    return (double) paid / (WORTH * cargoes);
  }
}
