package org.hificamsim.runs.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.function.Predicate;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.hificamsim.core.InputException;
import org.hificamsim.runs.RunPlan;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ShardTest {
  @Property(tries = 300)
  void distributesRunsEvenlyOverShards(
      @ForAll @IntRange(min = 1, max = 12) int cases,
      @ForAll @IntRange(min = 1, max = 40) int repeats,
      @ForAll @IntRange(min = 1, max = 600) int count) {
    List<List<RunTask>> shards = shards(cases, repeats, count);
    List<RunTask> all = shards.stream().flatMap(List::stream).toList();
    assertEquals(cases * repeats, all.size());
    assertEquals(cases * repeats, new HashSet<>(all).size());
    assertBalanced(shards, task -> true);
    for (int index = 0; index < cases; index++) {
      int plan = index;
      assertBalanced(shards, task -> task.plan() == plan);
    }
  }

  @Property(tries = 100)
  void distributesSeedsEvenlyOverShards(
      @ForAll @IntRange(min = 1, max = 12) int cases,
      @ForAll @IntRange(min = 1, max = 5) int times,
      @ForAll @IntRange(min = 1, max = 12) int count) {
    List<List<RunTask>> shards = shards(cases, times * count, count);
    for (int seed = 0; seed < times * count; seed++) {
      int repeat = seed;
      assertBalanced(shards, task -> task.repeat() == repeat);
    }
  }

  @Test
  void parsesItsOwnText() {
    assertEquals(new Shard(3, 8), Shard.parse("3/8"));
    assertEquals("3/8", new Shard(3, 8).toString());
    assertEquals(new Shard(1, 1), Shard.parse("1/1"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"", "3", "0/8", "9/8", "-1/8", "1/0", "a/b", "1/8/2", "1 / 8", "1/99999999"})
  void rejectsMalformedShards(String text) {
    InputException fault = assertThrows(InputException.class, () -> Shard.parse(text));
    assertTrue(fault.getMessage().startsWith("shard is '" + text + "', expected i/n"));
  }

  private static List<List<RunTask>> shards(int cases, int repeats, int count) {
    RunPlan plan = new RunPlan(null, null, "zoom-out", 1, 0, repeats);
    List<RunPlan> plans = Collections.nCopies(cases, plan);
    List<List<RunTask>> shards = new ArrayList<>();
    for (int number = 1; number <= count; number++) {
      shards.add(new Shard(number, count).tasks(plans));
    }
    return shards;
  }

  private static void assertBalanced(List<List<RunTask>> shards, Predicate<RunTask> counts) {
    List<Long> sizes = shards.stream().map(tasks -> tasks.stream().filter(counts).count()).toList();
    long spread = Collections.max(sizes) - Collections.min(sizes);
    assertTrue(spread <= 1, sizes.toString());
  }
}
