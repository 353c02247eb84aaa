package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests the import of recordings that SUMO and JuPedSim make as for the shipped sites. The build
 * installs both in a virtual environment; HIFICAMSIM_PYTHON may name another Python that has them.
 */
class TrackToolsTest {
  private static final String PYTHON =
      Optional.ofNullable(System.getenv("HIFICAMSIM_PYTHON"))
          .orElse(Cli.ROOT.resolve("build/track-tools/bin/python").toString());

  @TempDir Path folder;

  @Test
  void importsRecordingOfSumo() throws Exception {
    assumeTrue(has("sumo"), missing("SUMO", "eclipse-sumo"));
    Cli imported = importRecording("street", "street-fcd.xml", "fcd", "--size", "1.5");
    assertTrue(imported.out().contains("of 135 targets "), imported::out);
    assertTrue(imported.out().contains("a sample every 0.5 s"), imported::out);
  }

  @Test
  void importsRecordingOfJuPedSim() throws Exception {
    assumeTrue(has("jupedsim"), missing("JuPedSim", "jupedsim"));
    Cli imported = importRecording("passage", "passage.txt", "petrack", "--size", "0.5x1.75");
    assertTrue(imported.out().contains("of 60 targets "), imported::out);
    assertTrue(imported.out().contains("a sample every 0.25 s"), imported::out);
  }

  /** Makes and imports a recording, and runs the shipped site with its tracks. */
  private Cli importRecording(String site, String file, String format, Object... size)
      throws Exception {
    Path recording = folder.resolve(file);
    Path script = Cli.ROOT.resolve("scenarios/make-tracks/" + site + ".py");
    assertEquals(0, run(script.toString(), recording.toString()));
    Cli imported =
        Cli.run(
            "import",
            recording,
            "--format",
            format,
            "--name",
            site,
            "--out",
            folder,
            size[0],
            size[1]);
    assertEquals(0, imported.exit(), imported.err());
    Path scenario = folder.resolve(site + ".xml");
    Files.copy(Cli.scenario(site), scenario, StandardCopyOption.REPLACE_EXISTING);
    Cli.assertValidAndRuns(scenario, folder.resolve("run"));
    return imported;
  }

  private static boolean has(String module) {
    try {
      return run("-c", "import " + module) == 0;
    } catch (IOException e) {
      return false;
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  private static String missing(String tool, String item) {
    return "'" + PYTHON + "' has no " + tool + " (" + item + " of PyPI)";
  }

  private static int run(String... words) throws IOException, InterruptedException {
    String[] command = new String[words.length + 1];
    command[0] = PYTHON;
    System.arraycopy(words, 0, command, 1, words.length);
    return new ProcessBuilder(command)
        .redirectErrorStream(true)
        .redirectOutput(Redirect.DISCARD)
        .start()
        .waitFor();
  }
}
