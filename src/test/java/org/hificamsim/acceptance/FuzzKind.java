package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.FileRecord;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.profiling.dataset.DatasetReader;
import org.hificamsim.profiling.measure.MeasurementsFile;

/** A kind of user input, with valid files to break, and a reader of the broken ones. */
enum FuzzKind {
  SCENARIO {
    @Override
    Cli read(Path file) throws IOException {
      Cli validate = run("validate", file);
      return validate.exit() == 0 ? simulate(file, "hifi:orb-lin") : validate;
    }
  },
  MODEL {
    @Override
    Cli read(Path file) throws IOException {
      return simulate(Cli.scenario("tutorial-two-cameras"), file);
    }
  },
  MEASUREMENTS {
    @Override
    Cli read(Path file) {
      return answerTo(() -> MeasurementsFile.read(file));
    }
  },
  DATASET {
    @Override
    Cli read(Path file) throws IOException {
      Files.writeString(file.resolveSibling("camera.json"), CAMERA);
      Files.move(file, file.resolveSibling("dataset.csv"));
      return new Cli(0, "", errors(DatasetReader.read(file.getParent()).problems()));
    }
  },
  TRACKS {
    @Override
    Cli read(Path file) throws IOException {
      Files.move(file, file.resolveSibling("a.tracks"));
      return simulate(Files.writeString(file.resolveSibling("s.xml"), TRACKED), "geometric");
    }
  },
  /**
   * Recordings in all formats. The name of a file contains its format; half of the files are read
   * without it.
   */
  RECORDING {
    @Override
    Cli read(Path file) throws IOException {
      String name = file.getFileName().toString();
      String format = FORMATS.stream().filter(name::contains).findFirst().orElseThrow();
      List<Object> words = new ArrayList<>(List.of("import", file, "--out", OUT));
      words.addAll(Files.size(file) % 2 == 0 ? List.of() : List.of("--format", format));
      if (!Set.of("fcd", "gpx", "geojson", "trajnet").contains(format)) {
        words.addAll(List.of("--rate", 25));
      }
      if (Set.of("mot", "petrack", "csv").contains(format)) {
        words.addAll(List.of("--unit", "m"));
      }
      if (Set.of("sdd", "vsp").contains(format)) {
        Path matrix = Files.writeString(file.resolveSibling("matrix.txt"), "1 0 0\n0 1 0\n0 0 1\n");
        words.addAll(List.of("--homography", matrix));
      }
      words.addAll(name.startsWith("clock") ? List.of("--columns", "time=1,x=2,y=3") : List.of());
      return run(words.toArray());
    }
  },
  SQLITE {
    @Override
    Cli read(Path file) throws IOException {
      return run("import", file, "--out", OUT);
    }
  },
  WALLS {
    @Override
    Cli read(Path file) throws IOException {
      Path people = Files.writeString(file.resolveSibling("people.csv"), PEOPLE);
      List<Object> words = new ArrayList<>(List.of("import", people, "--format", "csv"));
      words.addAll(List.of("--unit", "m", "--scale", 0.1, "--walls", file, "--out", OUT));
      words.add("--force-reading"); // so that its readers see all
      return run(words.toArray());
    }
  },
  /** The journal of a killed comparison with one shard, which is resumed without pictures. */
  JOURNAL {
    @Override
    List<Path> made() throws IOException {
      return List.of(part().resolve("runs.jsonl"));
    }

    @Override
    Cli read(Path file) throws IOException {
      Files.createDirectories(OUT);
      for (String name : List.of("runs.jsonl", FileRecord.NAME)) {
        Files.copy(
            name.equals(file.getFileName().toString()) ? file : part().resolve(name),
            OUT.resolve(name));
      }
      Cli cli = comparison(OUT, "--shard", "1/1", "--resume");
      List<String> right = Files.readAllLines(part().resolve("runs.jsonl"));
      List<String> lines =
          Files.readAllLines(OUT.resolve("runs.jsonl"), StandardCharsets.ISO_8859_1);
      assertTrue(cli.exit() != 0 || lines.containsAll(right), "a damaged line was believed");
      return cli;
    }
  },
  SHARD {
    @Override
    List<Path> made() throws IOException {
      return List.of(part().resolve("runs.jsonl"));
    }

    @Override
    Cli read(Path file) throws IOException {
      Cli cli = comparison(OUT, "--merge", among(file, part()));
      if (cli.exit() == 0) {
        byte[] right = Files.readAllBytes(part().resolveSibling("whole/results.csv"));
        byte[] merged = Files.readAllBytes(OUT.resolve("results.csv"));
        assertArrayEquals(right, merged, "a damaged line was believed");
      }
      return cli;
    }
  },
  /** Files of a folder of results that its page is made of. */
  RESULTS {
    @Override
    List<Path> made() throws IOException {
      return in(
          results("run", "csv"),
          "summary.json",
          "steps.csv",
          "replay.json",
          "zooms.csv",
          "targets.csv");
    }

    @Override
    Cli read(Path file) throws IOException {
      return shown(among(file, results("run", "csv")));
    }
  },
  PHOTO {
    @Override
    List<Path> made() throws IOException {
      return files(lab()).stream().filter(file -> file.toString().endsWith("g")).toList();
    }

    @Override
    Cli read(Path file) throws IOException {
      return run("profile", "measure", among(file, lab()), "--detectors", "orb", "--threads", 1);
    }
  },
  ONNX {
    @Override
    List<Path> made() {
      return List.of(Cli.ROOT.resolve("onnx/src/test/resources/org/hificamsim/onnx/linear.onnx"));
    }

    @Override
    Cli read(Path file) throws IOException {
      List<Object> words = new ArrayList<>(List.of("run", Cli.scenario("corridor"), "--steps", 3));
      words.addAll(List.of("--detection", "dori-2014:level=recognise", "--out", OUT));
      words.addAll(List.of("--policy", "onnx:file=" + file));
      return run(words.toArray());
    }
  },
  COMMAND {
    @Override
    Cli read(Path file) throws IOException {
      return command(Files.readString(file, StandardCharsets.ISO_8859_1));
    }
  };

  /** Commands that neither write where they like nor wait for anybody. */
  private static final Set<String> HARMLESS =
      Set.of("run", "compare", "validate", "list", "help", "generate-completion");

  private static final List<String> FORMATS =
      List.of(
          "obsmat", "ethucy", "trajnet", "mot", "sdd", "vsp", "petrack", "vadere", "fcd", "gpx",
          "geojson", "csv");
  private static final Path CORPUS = Cli.ROOT.resolve("src/test/resources/fuzz");
  private static final String CAMERA =
      "{\"sensorWidth\": 0.0224, \"sensorHeight\": 0.0149, \"width\": 600, \"height\": 400}";
  private static final String TRACKED =
      "<root><simulation min_x='-9' max_x='9' min_y='-9' max_y='9'><cameras><camera name='a' x='0'"
          + " y='0' heading='0' viewing_angle='90' range='5'/></cameras><objects><tracks"
          + " file='a.tracks'/></objects></simulation></root>";
  private static final String PEOPLE = "time,id,x,y\n0,1,0,0\n1,1,1,1\n2,1,5,4\n";

  private static final Path FOLDER = folder();
  private static final Path SEEDS = FOLDER.resolve("seeds");
  private static final Path IN = FOLDER.resolve("in");
  private static final Path OUT = FOLDER.resolve("out");

  private List<Path> seeds;

  /** Reads a file of this kind as a user would. */
  abstract Cli read(Path file) throws IOException;

  /** Returns valid files that commands produce. */
  List<Path> made() throws IOException {
    return List.of();
  }

  /** Reads a file with this name and content from a new folder. */
  final Cli read(String name, byte[] content) throws IOException {
    delete(IN);
    delete(OUT);
    return read(Files.write(Files.createDirectories(IN).resolve(name), content));
  }

  /** Returns valid files, and files that once caused a wrong answer. */
  final List<Path> corpus() {
    try {
      if (seeds == null) {
        Path own = CORPUS.resolve(name().toLowerCase(Locale.ROOT));
        seeds = new ArrayList<>(Files.exists(own) ? files(own) : List.of());
        seeds.addAll(made());
      }
      return seeds;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Whether messages must name line and column. */
  final boolean hasPlaces() {
    return !Set.of(COMMAND, JOURNAL, SHARD, RESULTS, PHOTO, ONNX, SQLITE).contains(this);
  }

  /** Whether its files are binary: most changes other than flipped bits make them unreadable. */
  final boolean isBinary() {
    return Set.of(PHOTO, ONNX, SQLITE).contains(this);
  }

  /** Whether the answer comes from the command line, which limits the length of lines. */
  final boolean isCommand() {
    return this != MEASUREMENTS && this != DATASET;
  }

  /** Runs a command, which must not change its inputs. */
  private static Cli run(Object... words) throws IOException {
    Map<Path, String> before = hashes();
    Cli cli = Cli.run(words);
    Map<Path, String> after = hashes();
    after.keySet().retainAll(before.keySet());
    assertEquals(before, after, "an input was changed");
    return cli;
  }

  private static Map<Path, String> hashes() throws IOException {
    Map<Path, String> hashes = new TreeMap<>();
    for (Path file : files(IN)) {
      if (!file.endsWith(FileRecord.NAME)) {
        hashes.put(file, Sha256.of(file));
      }
    }
    return hashes;
  }

  private static Cli simulate(Object scenario, Object detection) throws IOException {
    return run("run", scenario, "--detection", detection, "--steps", 3, "--out", OUT);
  }

  private static Cli answerTo(Runnable reading) {
    try {
      reading.run();
      return new Cli(0, "", "");
    } catch (InputException e) {
      return new Cli(2, "", errors(List.of(e.getMessage())));
    }
  }

  private static String errors(List<String> messages) {
    return String.join("", messages.stream().map(line -> "error: " + line + "\n").toList());
  }

  private static Cli command(String text) throws IOException {
    List<Object> words = new ArrayList<>();
    for (String word : text.strip().split("[ \n]+")) {
      words.add(word.replace("SCENARIO", Cli.scenario("tutorial-two-cameras").toString()));
    }
    if (!HARMLESS.contains(words.get(0))) {
      words.set(0, "validate");
    }
    if (words.get(0).equals("run") || words.get(0).equals("compare")) {
      words.addAll(List.of("--steps", 3, "--repeat", 1, "--out", OUT));
    }
    return run(words.toArray());
  }

  /** The page and a picture of a folder of results. */
  private static Cli shown(Path folder) throws IOException {
    Files.createDirectories(OUT);
    Cli report = run("report", folder, "--out", OUT.resolve("a.html"));
    return report.exit() == 0 ? run("report", folder, "--svg", OUT.resolve("a.svg")) : report;
  }

  private static Cli comparison(Path out, Object... more) throws IOException {
    List<Object> words = new ArrayList<>(List.of("compare", Cli.scenario("ring-random")));
    words.addAll(List.of("--detections", "hifi:orb-lin", "--policies", "zoom-out"));
    words.addAll(List.of("--yardsticks", "none", "--steps", 3, "--repeat", 3, "--threads", 1));
    words.addAll(List.of("--out", out));
    words.addAll(Arrays.asList(more));
    return run(words.toArray());
  }

  /** Returns the only shard of a comparison, next to the whole comparison. */
  private static Path part() throws IOException {
    Path part = SEEDS.resolve("part");
    if (!Files.exists(part)) {
      assertEquals(0, comparison(SEEDS.resolve("whole")).exit());
      assertEquals(0, comparison(part, "--shard", "1/1").exit());
    }
    return part;
  }

  private static Path results(String name, String format) throws IOException {
    Path folder = SEEDS.resolve(name);
    if (!Files.exists(folder)) {
      Path scenario = Cli.scenario("tutorial-two-cameras");
      Cli run = run("run", scenario, "--steps", 9, "--record", "--format", format, "--out", folder);
      assertEquals(0, run.exit(), run.err());
    }
    return folder;
  }

  private static List<Path> in(Path folder, String... names) {
    return Stream.of(names).map(folder::resolve).toList();
  }

  private static Path lab() {
    Path lab = SEEDS.resolve("lab");
    return Files.exists(lab)
        ? lab
        : Cli.lab(SEEDS, "--objects 1 --distances 1,2 --focal-lengths 0.05,0.085 --scale 0.05");
  }

  /** Copies a folder, and replaces the file that has the same name as the given one. */
  private static Path among(Path file, Path folder) throws IOException {
    Path copy = IN.resolve("folder");
    for (Path original : files(folder)) {
      Path to = copy.resolve(folder.relativize(original));
      Files.createDirectories(to.getParent());
      boolean broken = original.getFileName().equals(file.getFileName());
      Files.copy(broken ? file : original, to, StandardCopyOption.REPLACE_EXISTING);
    }
    return copy;
  }

  private static List<Path> files(Path folder) throws IOException {
    if (!Files.exists(folder)) {
      return List.of();
    }
    try (Stream<Path> files = Files.walk(folder)) {
      return files.filter(Files::isRegularFile).sorted().toList();
    }
  }

  /**
   * Removes a folder. If a case that took too long still writes there, waits until it has ended.
   */
  private static void delete(Path folder) throws IOException {
    try {
      deleteAll(folder);
    } catch (DirectoryNotEmptyException | NoSuchFileException e) {
      LockSupport.parkNanos(Duration.ofSeconds(20).toNanos());
      deleteAll(folder);
    }
  }

  private static void deleteAll(Path folder) throws IOException {
    if (Files.exists(folder)) {
      try (Stream<Path> files = Files.walk(folder)) {
        for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
  }

  private static Path folder() {
    try {
      Path folder = Files.createTempDirectory("fuzz");
      Files.createDirectories(folder.resolve("seeds"));
      return folder;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
