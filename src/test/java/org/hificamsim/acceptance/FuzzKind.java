package org.hificamsim.acceptance;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.dataset.DatasetReader;
import org.hificamsim.profiling.measure.MeasurementsFile;

/** A kind of input that users write, with a folder of seeds in the corpus. */
enum FuzzKind {
  SCENARIO("scenario", "s.xml") {
    @Override
    Cli read(Path file) {
      Cli validate = Cli.run("validate", file);
      return validate.exit() == 0 ? simulate(file, "hifi:orb-lin") : validate;
    }
  },
  MODEL("model", "m.json") {
    @Override
    Cli read(Path file) {
      return simulate(Cli.scenario("tutorial-two-cameras"), file);
    }
  },
  MEASUREMENTS("measurements", "measurements.csv") {
    @Override
    Cli read(Path file) {
      return told(() -> MeasurementsFile.read(file));
    }
  },
  DATASET("dataset", "dataset.csv") {
    @Override
    Cli read(Path file) {
      return new Cli(0, "", errors(DatasetReader.read(file.getParent()).problems()));
    }
  },
  TRACKS("tracks", "a.tracks") {
    @Override
    Cli read(Path file) {
      try {
        Path scenario = Files.writeString(file.resolveSibling("tracked.xml"), TRACKED);
        return simulate(scenario, "geometric");
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  },
  RECORDING("recording", "recording") {
    @Override
    Cli read(Path file) {
      List<Object> words = new ArrayList<>(List.of("import", file, "--out", FOLDER.resolve("in")));
      words.addAll(format(text(file)));
      return Cli.run(words.toArray());
    }
  },
  COMMAND("command", "words.txt") {
    @Override
    Cli read(Path file) {
      return command(text(file));
    }
  };

  /** Commands that neither write where they like nor wait for anybody. */
  private static final Set<String> HARMLESS =
      Set.of("run", "compare", "validate", "list", "help", "generate-completion");

  private static final Path CORPUS = Cli.ROOT.resolve("src/test/resources/fuzz");
  private static final String CAMERA =
      "{\"sensorWidth\": 0.0224, \"sensorHeight\": 0.0149, \"width\": 600, \"height\": 400}";
  private static final String TRACKED =
      "<root><simulation min_x='-9' max_x='9' min_y='-9' max_y='9'><cameras><camera name='a' x='0'"
          + " y='0' heading='0' viewing_angle='90' range='5'/></cameras><objects><tracks"
          + " file='a.tracks'/></objects></simulation></root>";

  private static final Path FOLDER = folder();

  private final String label;
  private final String file;

  FuzzKind(String label, String file) {
    this.label = label;
    this.file = file;
  }

  /** What becomes of a file of this kind. */
  abstract Cli read(Path file);

  /** What becomes of such content. */
  final Cli read(byte[] content) {
    try {
      return read(Files.write(FOLDER.resolve(file), content));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The files of the corpus: right ones, and each that was once answered wrongly. */
  final List<Path> corpus() {
    try (Stream<Path> files = Files.list(CORPUS.resolve(label))) {
      return files.sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Whether an error must name line and column. */
  final boolean hasPlaces() {
    return this != COMMAND;
  }

  private static Cli simulate(Object scenario, Object detection) {
    return Cli.run(
        "run", scenario, "--detection", detection, "--steps", 3, "--out", FOLDER.resolve("out"));
  }

  private static String text(Path file) {
    try {
      return Files.readString(file, StandardCharsets.ISO_8859_1);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The options by which a recording is read that looks like this. */
  private static List<Object> format(String text) {
    if (text.startsWith("<")) {
      return List.of("--format", text.contains("gpx") ? "gpx" : "fcd");
    }
    if (text.startsWith("{")) {
      return List.of("--format", text.contains("features") ? "geojson" : "trajnet");
    }
    String name = text.startsWith("time") ? "csv" : text.startsWith("#") ? "petrack" : "mot";
    return text.startsWith(" ")
        ? List.of("--format", "obsmat", "--rate", 25)
        : List.of("--format", name, "--rate", 25, "--unit", "m");
  }

  private static Cli told(Runnable reading) {
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

  private static Cli command(String text) {
    List<Object> words = new ArrayList<>();
    for (String word : text.strip().split("[ \n]+")) {
      words.add(word.replace("SCENARIO", Cli.scenario("tutorial-two-cameras").toString()));
    }
    if (!HARMLESS.contains(words.get(0))) {
      words.set(0, "validate");
    }
    if (words.get(0).equals("run") || words.get(0).equals("compare")) {
      words.addAll(List.of("--steps", 3, "--repeat", 1, "--out", FOLDER.resolve("out")));
    }
    return Cli.run(words.toArray());
  }

  private static Path folder() {
    try {
      Path folder = Files.createTempDirectory("fuzz");
      Files.writeString(folder.resolve("camera.json"), CAMERA);
      return folder;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
