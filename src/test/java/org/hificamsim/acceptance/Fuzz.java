package org.hificamsim.acceptance;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/**
 * Breaks valid files of a kind and checks the answers. As a program, {@code Fuzz MUTANTS [SEED
 * [KIND...]]}, it does so for all kinds and prints a row for each.
 */
final class Fuzz {
  private static final int SHOWN = 10;
  private static final long LIMIT = 10_000_000_000L; // nanoseconds of the processors

  private final FuzzKind kind;
  private final int mutants;
  private final Random random;
  private final List<String> wrong = new ArrayList<>();
  private int refused;
  private long longest; // nanoseconds

  Fuzz(FuzzKind kind, int mutants, long seed) {
    this.kind = kind;
    this.mutants = mutants;
    this.random = new Random(seed);
  }

  void run() {
    for (int i = 0; i < mutants; i++) {
      FuzzCase broken = FuzzCase.of(kind, random);
      long start = processorTime();
      try {
        refused += broken.check() == 0 ? 0 : 1;
      } catch (AssertionError e) {
        wrong.add(e.getMessage());
      }
      long took = processorTime() - start;
      longest = Math.max(longest, took);
      if (took > LIMIT) {
        wrong.add(String.format(Locale.ROOT, "%.1f s for %s", took / 1e9, broken));
      }
    }
  }

  private static long processorTime() {
    return ((OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
        .getProcessCpuTime();
  }

  /** Returns the wrong answers, in one or more lines each. */
  List<String> wrong() {
    return wrong;
  }

  @Override
  public String toString() {
    String words = "%-12s %d mutants: %d taken, %d refused, %d wrong; the longest took %.1f s";
    int taken = mutants - refused - wrong.size();
    return words.formatted(kind, mutants, taken, refused, wrong.size(), longest / 1e9)
        + String.join("", wrong.stream().limit(SHOWN).map(line -> "\n  " + line).toList());
  }

  public static void main(String[] args) {
    int mutants = Integer.parseInt(args[0]);
    long seed = args.length > 1 ? Long.parseLong(args[1]) : new Random().nextLong();
    List<FuzzKind> kinds =
        args.length > 2
            ? Arrays.stream(args).skip(2).map(FuzzKind::valueOf).toList()
            : List.of(FuzzKind.values());
    System.out.println("seed " + seed);
    Locale.setDefault(Locale.ROOT);
    int wrong = 0;
    for (FuzzKind kind : kinds) {
      Fuzz fuzz = new Fuzz(kind, mutants, seed);
      fuzz.run();
      System.out.println(fuzz);
      wrong += fuzz.wrong.size();
    }
    System.exit(wrong == 0 ? 0 : 1);
  }
}
