package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.FilterWriter;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.cli.Main;
import org.hificamsim.core.file.OutputFolder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests commands that are interrupted, share a folder, or find foreign files and links in it. */
class OutputSafetyTest {
  private static final Path SCENARIO = Cli.scenario("ring-random");

  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "--help",
        "--version",
        "help run",
        "generate-completion",
        "list detections",
        "list policies",
        "list scenarios",
        "validate SCENARIO",
        "run SCENARIO --steps 5 --out DIR",
        "compare SCENARIO --steps 5 --repeat 1 --out DIR",
        "camsim SCENARIO -t 5 -o DIR/o.csv",
        "generate DIR/g.xml --cameras 2"
      })
  void unwritableOutputIsErrorInOneLine(String command) {
    String[] words =
        command.replace("SCENARIO", SCENARIO + "").replace("DIR", folder + "").split(" ");
    Writer full =
        new FilterWriter(Writer.nullWriter()) {
          @Override
          public void write(String text, int from, int length) throws IOException {
            throw new IOException("No space left on device");
          }
        };
    StringWriter err = new StringWriter();
    assertEquals(1, Main.execute(new PrintWriter(full, true), new PrintWriter(err, true), words));
    assertEquals(
        "error: standard output cannot be written, expected a place with room for it",
        err.toString().lines().filter(line -> line.startsWith("error")).findFirst().orElse(""));
  }

  @Test
  void fullDeviceIsError() throws Exception {
    Process process = separate("validate").redirectOutput(new File("/dev/full")).start();
    String err = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(1, process.waitFor(), err);
    assertEquals(1, err.lines().count(), err);
  }

  @Test
  void closedPipeIsNoError() throws Exception {
    Process process = separate("run", "--steps", "5", "--out", folder.toString()).start();
    process.getInputStream().close();
    String err = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), err);
    assertEquals("", err);
    assertTrue(Files.exists(folder.resolve("summary.json")));
  }

  private static ProcessBuilder separate(String... words) {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-Dhificamsim.root=" + Cli.ROOT, "-cp"));
    command.addAll(List.of(System.getProperty("java.class.path"), "org.hificamsim.cli.Main"));
    command.addAll(List.of(words));
    command.add(SCENARIO.toString());
    return new ProcessBuilder(command);
  }

  @ParameterizedTest
  @CsvSource({
    "run --record --steps 100000000 --out, ''",
    "compare --steps 10000000 --repeat 2 --out, .compare.journal",
    "camsim -t 100000000 -o, ''"
  })
  void interruptLeavesOnlyTheJournal(String command, String left) throws Exception {
    Path out = command.startsWith("camsim") ? folder.resolve("o.csv") : folder;
    List<Object> words = new ArrayList<>(List.of((Object[]) command.split(" ")));
    words.addAll(List.of(out, SCENARIO));
    Process process = Java.main(System.getProperty("java.class.path"), words.toArray());
    while (process.isAlive() && names().isEmpty()) {
      TimeUnit.MILLISECONDS.sleep(10);
    }
    TimeUnit.MILLISECONDS.sleep(200);
    new ProcessBuilder("kill", "-INT", Long.toString(process.pid())).start().waitFor();
    assertTrue(process.waitFor(60, TimeUnit.SECONDS));
    assertEquals(130, process.exitValue());
    assertEquals(left.isEmpty() ? List.of() : List.of(left), names());
  }

  @Test
  void concurrentRunsWriteWholeFolderOrFail() throws IOException {
    List<Cli> runs =
        atOnce(
            seed ->
                Cli.run(
                    "run", SCENARIO, "--record", "--seed", seed, "--steps", 2000, "--out", folder));
    for (Cli run : runs) {
      assertTrue(
          run.exit() == 0 || (run.exit() == 2 && run.err().contains("is in use by another run")),
          run.err());
    }
    assertTrue(runs.stream().anyMatch(run -> run.exit() == 0));
    Cli report = Cli.run("report", folder);
    assertEquals(0, report.exit(), report.err());
    assertEquals(
        List.of(
            "detection-hifi-orb-lin.json",
            "manifest.json",
            "replay.json",
            "report.html",
            "ro-crate-metadata.json",
            "scenario-ring-random.xml",
            "steps.csv",
            "summary.json",
            "targets.csv",
            "zooms.csv"),
        names());
  }

  @Test
  void concurrentWritersLeaveOneWholeFile() throws IOException {
    Path file = folder.resolve("o.csv");
    List<String> alone = new ArrayList<>();
    for (int seed = 0; seed < 4; seed++) {
      camsim(seed, file);
      alone.add(Files.readString(file));
    }
    atOnce(seed -> camsim(seed, file)).forEach(run -> assertEquals(0, run.exit(), run.err()));
    assertTrue(alone.contains(Files.readString(file)));
  }

  @ParameterizedTest
  @CsvSource({
    "run --steps 20 --out DIR, .steps.csv-PID.part",
    "run --steps 20 --out DIR, .hificamsim/steps.csv",
    "compare --steps 20 --repeat 1 --out DIR, .results.csv-PID.part",
    "compare --steps 20 --repeat 1 --out DIR, .compare.journal",
    "camsim -o DIR/o.csv, .o.csv-PID.part"
  })
  void followsNoPlantedLinks(String command, String link) throws IOException {
    Path target = Files.writeString(folder.resolve("target"), "mine");
    Path out = Files.createDirectory(folder.resolve("out"));
    Path planted = out.resolve(link.replace("PID", ProcessHandle.current().pid() + ""));
    Files.createDirectories(planted.getParent());
    Files.createSymbolicLink(planted, target);
    List<Object> words =
        new ArrayList<>(List.of((Object[]) command.replace("DIR", out.toString()).split(" ")));
    words.add(SCENARIO);
    Cli.run(words.toArray());
    assertEquals("mine", Files.readString(target));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "import DIR/street.xml --format fcd --out DIR | street.xml",
        "import DIR/t.csv --format csv --out DIR | t.xml",
        "import DIR/t.csv --format csv --out DIR --walls DIR/t.tracks | t.tracks",
        "import DIR/t.csv --format csv --out DIR --name plan --floorplan DIR/plan.png --scale 0.1 |"
            + " plan.png",
        "profile lab --scale 0.05 --objects 1 --out DIR | dataset.csv",
        "generate DIR/mine.xml | mine.xml",
        "run SCENARIO --steps 3 --out DIR | steps.csv",
        "run SCENARIO --steps 3 --out DIR | summary.json",
        "run SCENARIO --steps 3 --out DIR | scenario-ring-random.xml",
        "run SCENARIO --steps 3 --record --out DIR | report.html",
        "compare SCENARIO --steps 3 --repeat 1 --out DIR | results.csv",
        "compare SCENARIO --steps 3 --repeat 1 --out DIR | settings.json",
        "compare SCENARIO --steps 3 --repeat 1 --shard 1/2 --out DIR | runs.jsonl",
        "report RUN --out DIR/mine.html | mine.html",
        "report RUN --png DIR/mine.png | mine.png",
        "report RUN --gif DIR/mine.gif --out DIR/b.html | mine.gif",
        "camsim SCENARIO -t 3 -o DIR/o.csv --coverage-out DIR | summary.json",
        "camsim SCENARIO --for-camsim DIR/mine.xml | mine.xml"
      })
  void neverReplacesForeignFiles(String command, String mine) throws IOException {
    Path run = folder.resolve("run");
    if (command.contains("RUN")) {
      Cli.run("run", SCENARIO, "--steps", 3, "--record", "--out", run);
    }
    Path dir = Files.createDirectory(folder.resolve("dir"));
    Files.writeString(dir.resolve("t.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,1\n");
    Files.writeString(dir.resolve(mine), "mine");
    Map<String, String> before = contents(dir);
    Object[] words =
        Arrays.stream(command.split(" "))
            .map(word -> word.replace("DIR", dir.toString()))
            .map(word -> word.replace("SCENARIO", SCENARIO.toString()))
            .map(word -> word.replace("RUN", run.toString()))
            .toArray();
    Cli refused = Cli.run(words);
    assertEquals(2, refused.exit(), refused.err());
    List<String> errors = refused.err().lines().filter(line -> line.startsWith("error")).toList();
    assertEquals(1, errors.size(), refused.err());
    assertTrue(errors.get(0).contains(mine) && errors.get(0).contains("expected"), errors.get(0));
    Map<String, String> after = contents(dir);
    after.remove(".compare.journal"); // of finished runs: --resume has them
    assertEquals(before, after);
  }

  private static Map<String, String> contents(Path folder) throws IOException {
    Map<String, String> contents = new TreeMap<>();
    for (String name : Cli.names(folder)) {
      contents.put(name, Files.readString(folder.resolve(name)));
    }
    return contents;
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "generate DIR/mine.xml --force",
        "report RUN --out DIR/mine.html --force",
        "report RUN --png DIR/mine.png --force",
        "camsim CAMSIM -t 3 -o DIR/mine.csv",
        "camsim CAMSIM --for-camsim DIR/mine.xml --force"
      })
  void forceReplacesNamedFile(String command) throws IOException {
    Path run = folder.resolve("run");
    Cli.run("run", SCENARIO, "--steps", 3, "--record", "--out", run);
    Path mine = null;
    List<Object> words = new ArrayList<>();
    for (String word : command.split(" ")) {
      String path = word.replace("DIR", folder.toString()).replace("RUN", run.toString());
      words.add(path.replace("CAMSIM", Cli.scenario("tutorial-camsim").toString()));
      mine = word.contains("mine") ? Path.of(path) : mine;
    }
    Files.writeString(mine, "mine");
    Cli done = Cli.run(words.toArray());
    assertEquals(0, done.exit(), done.err());
    assertFalse(Arrays.equals("mine".getBytes(), Files.readAllBytes(mine)));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "report RUN --out RUN/steps.csv --force",
        "report RUN --svg RUN/steps.csv --force",
        "camsim DIR/in.xml -o DIR/in.xml",
        "camsim DIR/in.xml --for-camsim DIR/in.xml --force",
        "camsim DIR/in.xml --detection RUN/detection-hifi-orb-lin.json -o"
            + " RUN/detection-hifi-orb-lin.json",
        "run DIR/in.xml --steps 3 --detection RUN/detection-hifi-orb-lin.json --out RUN"
      })
  void neverReplacesInput(String command) throws IOException {
    Path run = folder.resolve("run");
    Cli.run("run", SCENARIO, "--steps", 3, "--record", "--out", run);
    Files.copy(Cli.scenario("tutorial-camsim"), folder.resolve("in.xml"));
    Map<String, String> before = contents(run);
    Object[] words =
        command.replace("DIR", folder.toString()).replace("RUN", run.toString()).split(" ");
    Cli refused = Cli.run(words);
    assertEquals(2, refused.exit(), refused.err());
    assertEquals(before, contents(run));
    assertEquals(-1, Files.mismatch(Cli.scenario("tutorial-camsim"), folder.resolve("in.xml")));
  }

  @Test
  void reportNamesChangedFiles() throws IOException {
    Cli.run("run", SCENARIO, "--steps", 3, "--record", "--out", folder);
    assertEquals("", Cli.run("report", folder).err());
    Files.writeString(folder.resolve("zooms.csv"), "\n", StandardOpenOption.APPEND);
    Cli report = Cli.run("report", folder);
    assertEquals(0, report.exit(), report.err());
    assertEquals(
        "warning: '" + folder + "': not as it was written: zooms.csv (.hificamsim.sha256)\n",
        report.err());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "<polygon points=''/><line x1='8' x2='9' y2='1'/> | 0",
        "<polygon points='1 1'/><line x1='8' x2='9' y2='1'/> | 0",
        "<polygon points=''/> | 2",
        "<polygon points='a b c'/> | 2",
        "<path d='M 1e5000 0 L 1 1'/> | 2",
        "<g transform='scale(1e9)'><line transform='scale(1e9)' x1='1' x2='5'/></g> | 2"
      })
  void readsOrRejectsOddDrawingsInOneLine(String shape, int exit) throws IOException {
    Path walls = folder.resolve("walls.svg");
    Files.writeString(walls, "<svg viewBox='0 0 9 9'>" + shape + "</svg>");
    Path tracks = Files.writeString(folder.resolve("t.csv"), "time,id,x,y\n0,1,0,0\n1,1,1,1\n");
    Cli done =
        Cli.run(
            "import",
            tracks,
            "--format",
            "csv",
            "--unit",
            "m",
            "--walls",
            walls,
            "--scale",
            1,
            "--out",
            folder.resolve("out"));
    assertEquals(exit, done.exit(), done.err());
    assertEquals(exit == 0 ? 0 : 1, done.err().lines().count(), done.err());
  }

  @Test
  void namesPlaceOfDamagedInput() throws IOException {
    Cli.run("run", SCENARIO, "--steps", 3, "--record", "--out", folder);
    Files.write(folder.resolve("steps.csv"), new byte[] {(byte) 255}, StandardOpenOption.APPEND);
    Cli.run("report", folder).assertRejected("steps.csv:5:1: ", folder.resolve("none"));
    Path street = folder.resolve("street.xml");
    String text = Files.readString(Cli.scenario("street"));
    Files.writeString(street, text.replaceFirst(" step=\"[0-9.]+\"", " step=\"1e-20\""));
    Files.copy(
        Cli.scenario("street").resolveSibling("street.tracks"), folder.resolve("street.tracks"));
    Cli far = Cli.run("run", street, "--out", folder.resolve("none"));
    far.assertRejected("expected one below 2147483647: a longer step", folder.resolve("none"));
  }

  @Test
  void keepsForeignHiddenFiles() throws IOException {
    Files.writeString(folder.resolve(".holiday-video-2147483647.part"), "mine");
    Cli run = Cli.run("run", SCENARIO, "--steps", 5, "--out", folder);
    assertEquals(0, run.exit(), run.err());
    assertEquals("mine", Files.readString(folder.resolve(".holiday-video-2147483647.part")));
  }

  @Test
  void rejectsComparisonInFolderOfRun() throws IOException {
    try (OutputFolder held = new OutputFolder(folder)) {
      Cli compare = Cli.run("compare", SCENARIO, "--steps", 5, "--repeat", 1, "--out", held.path());
      assertEquals(2, compare.exit());
      assertTrue(
          compare.err().contains("folder '" + folder + "' is in use by another run, expected"),
          compare.err());
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "--resume"})
  void journalIsSafeFromOtherProcesses(String resume) throws Exception {
    Path journal = folder.resolve(".compare.journal");
    try (OutputFolder held = new OutputFolder(folder)) {
      Files.writeString(journal, "runs of who holds the folder\n");
      List<Object> words = new ArrayList<>(List.of("compare", SCENARIO, "--steps", 5));
      words.addAll(List.of("--repeat", 1, "--out", held.path()));
      words.addAll(resume.isEmpty() ? List.of() : List.of(resume));
      Process other = Java.main(System.getProperty("java.class.path"), words.toArray());
      String output = new String(other.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      assertEquals(2, other.waitFor(), output);
      assertTrue(output.contains("is in use by another run"), output);
      assertEquals("runs of who holds the folder\n", Files.readString(journal));
    }
  }

  private static List<Cli> atOnce(IntFunction<Cli> command) {
    List<CompletableFuture<Cli>> all =
        IntStream.range(0, 4)
            .mapToObj(seed -> CompletableFuture.supplyAsync(() -> command.apply(seed)))
            .toList();
    return all.stream().map(CompletableFuture::join).toList();
  }

  private Cli camsim(int seed, Path file) {
    try {
      Path sums = Files.createTempDirectory(folder, "sums").resolve("summary.csv");
      return Cli.run(
          "camsim",
          Cli.scenario("tutorial-camsim"),
          "-s",
          seed,
          "-t",
          2000,
          "-o",
          file,
          "-f",
          sums);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> !name.startsWith("summary.csv") && !name.equals(".hificamsim.sha256"))
          .sorted()
          .toList();
    }
  }
}
