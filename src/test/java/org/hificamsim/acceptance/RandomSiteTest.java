package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Deque;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the sites of {@code generate --lenses}. */
class RandomSiteTest {
  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4})
  void isValidWithoutWarnings(int seed) throws IOException {
    Path file = generated("--cameras", 8, "--lenses", "--walls", 40, "--seed", seed);
    Cli validated = Cli.run("validate", file, "--strict");
    assertEquals(0, validated.exit(), validated.err());
    Scenario site = read(file);
    assertEquals("covered:k=1", site.objective().text());
    assertEquals("oodpcvs-2025:level=discern", site.get(Scenario.DETECTION));
    assertEquals(300, site.get(Scenario.STEPS));
    assertEquals(8, site.cameras().size());
    assertEquals(12, site.targets().size());
    assertEquals(40, site.obstacles().size());
    assertTrue(site.everyCamera().allMatch(camera -> camera.optics().orElseThrow().takesTime()));
    assertEquals(
        "[bullet, dome]",
        site.everyCamera()
            .flatMap(camera -> camera.optics().stream())
            .map(OpticsSpec::name)
            .sorted()
            .distinct()
            .toList()
            .toString());
  }

  @ParameterizedTest
  @ValueSource(ints = {5, 6, 7})
  void wallsEncloseNoCameraOrTarget(int seed) throws IOException {
    Path file = generated("--cameras", 6, "--lenses", "--walls", 150, "--seed", seed);
    Scenario site = read(file);
    Walk walk = new Walk(site);
    site.cameras()
        .forEach(camera -> assertTrue(walk.reaches(camera.x(), camera.y()), camera.name()));
    site.targets()
        .forEach(target -> assertTrue(walk.reaches(target.x(), target.y()), target.name()));
  }

  @Test
  void runsWithOtherObjective() throws IOException {
    Path file = generated("--cameras", 4, "--lenses", "--objective", "sum:cap=2");
    assertEquals("sum:cap=2", read(file).objective().text());
    Cli run = Cli.run("run", file, "--steps", 5, "--out", folder.resolve("out"));
    assertEquals(0, run.exit(), run.err());
  }

  @Test
  void siteDependsOnlyOnSeed() throws IOException {
    String text = Files.readString(generated("--cameras", 5, "--lenses", "--walls", 9));
    assertEquals(text, Files.readString(generated("--cameras", 5, "--lenses", "--walls", 9)));
    Path other = generated("--cameras", 5, "--lenses", "--walls", 9, "--seed", 1);
    assertTrue(!text.equals(Files.readString(other)));
  }

  @Test
  void rejectsWallsWithoutRoomOrLenses() {
    assertRejected(
        "--walls is 2000, expected at most about", "--cameras", 2, "--lenses", "--walls", 2000);
    assertRejected("--walls is -1", "--cameras", 2, "--lenses", "--walls", -1);
    assertRejected("--walls is given without --lenses", "--walls", 3);
    assertRejected("unknown objective 'all'", "--lenses", "--objective", "all");
  }

  private static Scenario read(Path file) {
    return ScenarioReader.read(file, movement -> true, warning -> {});
  }

  private Path generated(Object... options) {
    Cli made = generate(options);
    assertEquals(0, made.exit(), made.err());
    return folder.resolve("site.xml");
  }

  private Cli generate(Object... options) {
    Object[] words = new Object[options.length + 3];
    words[0] = "generate";
    words[1] = folder.resolve("site.xml");
    words[2] = "--force";
    System.arraycopy(options, 0, words, 3, options.length);
    return Cli.run(words);
  }

  private void assertRejected(String expected, Object... options) {
    Cli run = generate(options);
    assertEquals(2, run.exit());
    assertTrue(run.err().startsWith("error: ") && run.err().contains(expected), run.err());
    assertEquals(1, run.err().lines().count(), run.err());
  }

  /** The points of a lattice of half a metre to which one can walk from the first camera. */
  private static final class Walk {
    private static final double WIDTH = 0.5;

    private final Obstacles obstacles;
    private final Field field;
    private final int columns;
    private final BitSet reached = new BitSet();

    Walk(Scenario site) {
      obstacles = new Obstacles(site.obstacles());
      field = site.field();
      columns = (int) (field.width() / WIDTH) + 1;
      Deque<Integer> next = new ArrayDeque<>();
      next.add(cell(site.cameras().get(0).x(), site.cameras().get(0).y()));
      while (!next.isEmpty()) {
        int from = next.remove();
        for (int to : new int[] {from - 1, from + 1, from - columns, from + columns}) {
          if (field.contains(x(to), y(to)) && !reached.get(to) && clear(from, to)) {
            reached.set(to);
            next.add(to);
          }
        }
      }
    }

    private boolean clear(int from, int to) {
      return Math.abs(x(from) - x(to)) <= WIDTH && obstacles.clear(x(from), y(from), x(to), y(to));
    }

    private double x(int cell) {
      return Math.floorMod(cell, columns) * WIDTH;
    }

    private double y(int cell) {
      return Math.floorDiv(cell, columns) * WIDTH;
    }

    private int cell(double x, double y) {
      return (int) (y / WIDTH) * columns + (int) (x / WIDTH);
    }

    /** Whether one of the four nearest points of the lattice is reached. */
    boolean reaches(double x, double y) {
      for (int row = 0; row <= 1; row++) {
        for (int column = 0; column <= 1; column++) {
          int cell = cell(x, y) + row * columns + column;
          if (reached.get(cell) && obstacles.clear(x, y, x(cell), y(cell))) {
            return true;
          }
        }
      }
      return false;
    }
  }
}
