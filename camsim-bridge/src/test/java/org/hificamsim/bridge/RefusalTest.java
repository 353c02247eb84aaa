package org.hificamsim.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Tests that the agent prints one line if it cannot work, and either leaves CamSim unchanged or
 * stops it.
 */
class RefusalTest {
  private static final String UNCHANGED = "; CamSim runs on unchanged\n";
  private static final List<String> ARGUMENTS =
      List.of("-t", "30", "-o", "output.csv", CamSimRun.CROSSING.toString());

  @TempDir static Path plain;
  private static CamSimRun without;

  @TempDir Path folder;

  @BeforeAll
  static void runWithoutAgent() {
    without = CamSimRun.alone(plain, CamSimRun.WITHOUT_AGENT, CamSimRun.CROSSING, 30);
  }

  @Test
  void reportsInvalidOptionInOneLineAndLetsCamSimRunOn() {
    CamSimRun with =
        CamSimRun.alone(folder.resolve("with"), "policy=random,zooms=5;3", CamSimRun.CROSSING, 30);
    assertEquals(without.all(), with.all());
    assertEquals(
        "hificamsim-bridge: zooms has '3' after 5.0, expected rising radii, each once, such as"
            + " 2.5;5;7.5"
            + UNCHANGED,
        with.err());
  }

  @Test
  void reportsFileGivenAsFolder() {
    CamSimRun with = CamSimRun.alone(folder.resolve("with"), "out=stdout", CamSimRun.CROSSING, 30);
    assertEquals(without.all(), with.all());
    assertEquals(
        "hificamsim-bridge: folder 'stdout' is a file, expected a folder" + UNCHANGED, with.err());
  }

  @Test
  void reportsWhyFolderInsideFileCannotBeCreated() {
    CamSimRun with =
        CamSimRun.alone(folder.resolve("with"), "out=stdout/results", CamSimRun.CROSSING, 30);
    assertEquals(
        "hificamsim-bridge: folder 'stdout/results' cannot be made: Not a directory" + UNCHANGED,
        with.err());
  }

  @Test
  void strictStopsBeforeCamSimStarts() {
    CamSimRun with =
        CamSimRun.alone(
            folder.resolve("with"), "detection=none,strict=true", CamSimRun.CROSSING, 30);
    assertEquals(2, with.exit());
    assertEquals("", with.out());
    assertEquals(1, with.err().lines().count(), with.err());
    assertFalse(Files.exists(with.folder().resolve("output.csv")));
  }

  @Test
  void strictAloneDoesNothing() {
    CamSimRun with = CamSimRun.alone(folder.resolve("with"), "strict=true", CamSimRun.CROSSING, 30);
    assertEquals(without.all(), with.all());
    assertEquals("", with.err());
  }

  @ParameterizedTest
  @CsvSource({
    "'class ', SimCore, OtherCore",
    "'method ', CameraController.removeVisibleObject(TraceableObject), hide"
  })
  void reportsMissingClassOrMethodOfCamSim(String kind, String name, String replacement)
      throws IOException {
    String text = name.replaceAll(".*\\.|\\(.*", "");
    Path classes = Variant.of(folder, text, replacement);
    CamSimRun with = start("detection=geometric,policy=random,out=results", classes);
    assertEquals(without.all(), with.all());
    assertEquals(
        "hificamsim-bridge: not found in CamSim: " + kind + "epics.camsim.core." + name + UNCHANGED,
        with.err());
    assertFalse(Files.exists(with.folder().resolve("results")));
  }

  @Test
  void reportsClassPathWithoutCamSim() throws IOException {
    Path classes =
        Variant.compile(
            folder,
            "Hello.java",
            "class Hello { public static void main(String... a) { System.out.println(1 + 1); } }");
    CamSimRun with =
        CamSimRun.start(
            folder.resolve("hello"), "policy=random", List.of(classes), "Hello", List.of());
    assertEquals(0, with.exit());
    assertEquals("2\n", with.out());
    assertEquals(
        "hificamsim-bridge: not found in CamSim: class epics.camsim.core.SimCore, class"
            + " epics.camsim.core.CameraController, class epics.camsim.core.TraceableObject"
            + UNCHANGED,
        with.err());
  }

  @Test
  void acceptsCamSimWithoutMembersThatOptionsDoNotNeed() throws IOException {
    Path classes =
        Variant.of(
            folder,
            Map.of("change(", "alter(", "getFeatures", "identity", "close_files", "finish"));
    CamSimRun with = start("detection=camsim-visibility", classes);
    assertEquals(without.all(), with.all());
    assertEquals("", with.err());
  }

  @Test
  void failureLetsCamSimRunOnWithItsOwnRanges() throws IOException {
    CamSimRun with = start("policy=random,out=results", failingOnce());
    assertEquals(0, with.exit());
    assertEquals(
        "hificamsim-bridge: java.lang.IllegalStateException: CamSim's own method failed:"
            + " java.lang.IllegalStateException: stuck"
            + UNCHANGED,
        with.err());
    int steps = with.rows("results/steps.csv").size();
    assertTrue(steps > 1 && steps < 10, steps + " steps before the failure");
    assertEquals(without.rows("output.csv").size(), with.rows("output.csv").size());
    List<Look> looks = with.rows("looks.csv").stream().map(Look::parse).toList();
    assertTrue(looks.stream().anyMatch(look -> look.camera().equals("A") && look.range() == 4));
    assertTrue(
        looks.stream()
            .filter(look -> look.camera().equals("A") && look.step() >= steps)
            .allMatch(look -> look.range() == 12));
  }

  @Test
  void strictStopsAtFailureDuringRun() throws IOException {
    CamSimRun with = start("policy=random,out=results,strict=true", failingOnce());
    assertEquals(2, with.exit());
    assertEquals(1, with.err().lines().count(), with.err());
    assertFalse(Files.exists(with.folder().resolve("output.csv")));
    assertTrue(Files.exists(with.folder().resolve("results/steps.csv")));
  }

  /** Compiles a CamSim in which the eleventh change of a range fails. */
  private Path failingOnce() throws IOException {
    return Variant.of(
        folder,
        "    x = newX == -1 ? x : newX;",
        """
            if (Integer.getInteger("changes", 0) == 10) {
              System.setProperty("changes", "11");
              throw new IllegalStateException("stuck");
            }
            System.setProperty("changes", "" + (Integer.getInteger("changes", 0) + 1));
            x = newX == -1 ? x : newX;
        """);
  }

  private CamSimRun start(String options, Path classes) {
    return CamSimRun.start(
        folder.resolve("with"), options, List.of(classes), "epics.camwin.Main", ARGUMENTS);
  }
}
