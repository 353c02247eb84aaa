package org.hificamsim.placement.cover;

import java.util.Arrays;
import java.util.BitSet;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/**
 * Proves plans of a few cameras, where linear bounds say little, by going through all that could be
 * better: for samples that all alike count once, and candidates of one price. At each node, either
 * the candidate that adds most is one that adds its part of what is wanted, or, where that leaves
 * fewer, one is taken of those that see something of a group of samples, larger than may be missed
 * (as set covers are branched on a sample: Etcheberry 1977). First it excludes plans that are
 * better by 1 %, then any.
 */
final class Enumeration implements ExactMethod {
  private static final double[] SLACKS = {0.01, 0};
  private static final int MOST = 6; // cameras
  private static final int CAREFULLY = 20; // parts in which a group is chosen
  private static final int QUICKLY = 4;

  /** Whether it is for such a problem. */
  static boolean suits(CoverInstance instance, Goal goal) {
    return !goal.isAll()
        && goal.quantum(instance) > 0
        && Arrays.stream(instance.prices()).allMatch(one -> one == instance.prices()[0])
        && goal.budget() < (MOST + 1) * instance.prices()[0]
        && Arrays.stream(instance.needs()).allMatch(k -> k <= 1);
  }

  @Override
  public Found solve(
      CoverInstance instance, Goal goal, int[] start, double bound, BooleanSupplier stop) {
    Search search = new Search(instance, start, stop);
    int cameras = (int) (goal.budget() / instance.prices()[0] + 1e-9);
    double least = bound;
    for (double slack : SLACKS) {
      least = Math.min(least, goal.quantum(instance) * search.most(slack, cameras));
    }
    return new Found(search.best, least);
  }

  private static final class Search {
    private final BooleanSupplier stop;
    private final long[][] columns; // bits, by candidate
    private final long[][] seenBy; // bits, by sample
    private final int whole;
    private int[] best;
    private int reached; // by the best
    private int wanted; // in all
    private double slack;
    private int[] path;
    private boolean stopped;

    Search(CoverInstance instance, int[] start, BooleanSupplier stop) {
      this.stop = stop;
      this.best = start;
      int samples = instance.samples();
      columns = new long[instance.candidates()][words(samples)];
      seenBy = new long[samples][words(columns.length)];
      for (int j = 0; j < columns.length; j++) {
        for (int sample : instance.columns()[j]) {
          if (instance.needs()[sample] > 0) {
            set(columns[j], sample);
            set(seenBy[sample], j);
          }
        }
      }
      long[] all = unseen(new int[0]);
      long[] left = unseen(start);
      whole = count(all, all);
      reached = whole - count(left, left);
    }

    private long[] unseen(int[] plan) {
      long[] open = new long[words(seenBy.length)];
      for (int sample = 0; sample < seenBy.length; sample++) {
        if (Arrays.stream(seenBy[sample]).anyMatch(word -> word != 0)) {
          set(open, sample);
        }
      }
      for (int j : plan) {
        open = without(open, columns[j]);
      }
      return open;
    }

    /** Searches; no plan reaches more than this, which is not more than so much over the best. */
    double most(double share, int cameras) {
      slack = share;
      path = new int[cameras];
      want();
      long[] keys = IntStream.range(0, columns.length).mapToLong(j -> key(whole, j)).toArray();
      extend(unseen(new int[0]), keys, 0);
      return stopped ? Double.POSITIVE_INFINITY : wanted - 1;
    }

    private void want() {
      wanted = (int) Math.floor(reached * (1 + slack)) + 1;
    }

    /**
     * Tries what can be added.
     *
     * @param open the samples that none sees yet
     * @param before the candidates that are allowed, with what they added before, the most first
     */
    private void extend(long[] open, long[] before, int depth) {
      int left = path.length - depth;
      int seen = whole - count(open, open);
      if (seen >= wanted) {
        reached = seen;
        best = Arrays.stream(path, 0, depth).sorted().toArray();
        want();
      }
      stopped = stopped || stop.getAsBoolean();
      if (stopped || left == 0) {
        return;
      }
      long[] keys = gains(open, before, left, wanted - seen);
      boolean[] tried = new boolean[keys.length];
      int parts = (wanted - seen + left - 1) / left;
      int large = 0;
      while (large < keys.length && gain(keys[large]) >= parts) {
        large++;
      }
      long[] group = left > 2 ? group(open, keys, left) : new long[0];
      boolean grouped = left > 2 && count(group, group) < large;
      for (int i = 0; i < (grouped ? keys.length : large); i++) {
        int j = (int) keys[i];
        if (!grouped || has(group, j)) {
          tried[i] = true;
          long[] rest =
              grouped ? untried(keys, tried) : Arrays.copyOfRange(keys, i + 1, keys.length);
          if (gain(keys[i]) + sum(rest, left - 1) < wanted - seen) {
            return; // nor do the following, which add less
          }
          path[depth] = j;
          extend(without(open, columns[j]), rest, depth + 1);
        }
      }
    }

    private static long[] untried(long[] keys, boolean[] tried) {
      return IntStream.range(0, keys.length)
          .filter(one -> !tried[one])
          .mapToLong(one -> keys[one])
          .toArray();
    }

    /** The candidates that a plan can have that adds so much, the most first. */
    private long[] gains(long[] open, long[] before, int left, int missing) {
      long[] keys = new long[before.length];
      int count = 0;
      int most = 0;
      for (long key : before) {
        if (gain(key) + (left - 1) * Math.max(most, gain(key)) < missing) {
          break; // gains only shrink
        }
        int gain = count(columns[(int) key], open);
        most = Math.max(most, gain);
        keys[count++] = key(gain, (int) key);
      }
      Arrays.sort(keys, 0, count);
      int others = sum(Arrays.copyOf(keys, Math.min(count, left - 1)), left - 1);
      while (count > 0 && gain(keys[count - 1]) < Math.max(1, missing - others)) {
        count--;
      }
      return Arrays.copyOf(keys, count);
    }

    /** The candidates that see something of samples of which a better plan sees some. */
    private long[] group(long[] open, long[] keys, int left) {
      long[] allowed = new long[words(columns.length)];
      Arrays.stream(keys).forEach(key -> set(allowed, (int) key));
      int missable = whole - wanted + 1;
      int[] samples = BitSet.valueOf(open).stream().toArray();
      long[] group = new long[allowed.length];
      int parts = left > 3 ? CAREFULLY : QUICKLY;
      for (int taken = 0; taken < missable; ) {
        long[] free = without(allowed, group);
        long[] order = new long[samples.length];
        Arrays.setAll(order, i -> ((long) count(seenBy[samples[i]], free) << 32) + samples[i]);
        Arrays.sort(order);
        int now = taken == 0 ? 1 : Math.min(missable, taken + Math.max(1, missable / parts));
        for (int i = 0; i < Math.min(now, order.length); i++) {
          long[] sees = seenBy[(int) order[i]];
          Arrays.setAll(group, w -> group[w] | (sees[w] & allowed[w]));
        }
        taken = now;
      }
      return group;
    }

    private static int sum(long[] keys, int first) {
      int sum = 0;
      for (int i = 0; i < Math.min(first, keys.length); i++) {
        sum += gain(keys[i]);
      }
      return sum;
    }

    /** Sorts by gain, the most first, then by candidate. */
    private static long key(int gain, int candidate) {
      return ((long) -gain << 32) + candidate;
    }

    private static int gain(long key) {
      return (int) -(key >> 32);
    }

    private static int words(int bits) {
      return (bits + Long.SIZE - 1) / Long.SIZE;
    }

    private static void set(long[] bits, int i) {
      bits[i / Long.SIZE] |= 1L << i;
    }

    private static boolean has(long[] bits, int i) {
      return (bits[i / Long.SIZE] >>> i & 1) != 0;
    }

    private static int count(long[] some, long[] others) {
      int count = 0;
      for (int w = 0; w < some.length; w++) {
        count += Long.bitCount(some[w] & others[w]);
      }
      return count;
    }

    private static long[] without(long[] some, long[] others) {
      long[] left = some.clone();
      for (int w = 0; w < left.length; w++) {
        left[w] &= ~others[w];
      }
      return left;
    }
  }
}
