package org.hificamsim.runs.compare;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.TreeMap;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.core.world.Movement;
import org.hificamsim.hifi.FittedDetection;
import org.hificamsim.hifi.model.ModelFiles;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.PolicyFiles;

/**
 * Identifies everything that determines the result of a run except the seed: two runs with the same
 * key and seed have the same result.
 *
 * @param inputs the named inputs with their contents: this program, the users' classes on the class
 *     path, the scenario, the detection, the files that a policy reads
 * @param settings the values of settings by their names, without those that only select runs
 */
public record RunKey(List<Input> inputs, Map<String, String> settings) {
  /**
   * A named input.
   *
   * @param digest the digest of the input's content
   */
  public record Input(String kind, String name, String digest) {
    private boolean isChanged(Input other) {
      return kind.equals(other.kind) && name.equals(other.name) && !digest.equals(other.digest);
    }

    @Override
    public String toString() {
      return kind + " '" + name + "'";
    }
  }

  private static final ObjectMapper MAPPER = new ObjectMapper();

  /** Returns the key of a plan's repeats. */
  public static RunKey of(RunPlan plan) {
    return of(List.of(plan)).get(0);
  }

  /** Returns the keys of plans, in the order of the plans. */
  static List<RunKey> of(List<RunPlan> plans) {
    List<Input> program = new ArrayList<>(userCode());
    program.add(program(ManifestFile.version()));
    PolicyFiles files = new PolicyFiles();
    return plans.stream().map(plan -> of(program, plan, files)).toList();
  }

  private static RunKey of(List<Input> program, RunPlan plan, PolicyFiles files) {
    String scenario = ScenarioWriter.write(withoutSettings(plan.scenario()));
    List<Input> inputs = new ArrayList<>(program);
    inputs.add(new Input("scenario", plan.scenario().name(), Sha256.of(bytes(scenario))));
    inputs.add(new Input("detection", plan.detection().name(), digest(plan.detection().model())));
    for (Path file : files.of(plan.policy())) {
      inputs.add(
          new Input("file of policy", file.toString(), Sha256.of(PolicyFiles.content(file))));
    }
    return new RunKey(inputs, settings(plan));
  }

  /** Removes from a scenario what the key has among its settings. */
  private static Scenario withoutSettings(Scenario scenario) {
    return scenario.without(Scenario.DETECTION).without(Scenario.OBJECTIVE).without(Scenario.STEPS);
  }

  private static Map<String, String> settings(RunPlan plan) {
    Map<String, String> settings = new TreeMap<>();
    for (Setting setting : Setting.values()) {
      if (!setting.countsRuns()) {
        settings.put(setting.label(), plan.value(setting).orElse(""));
      }
    }
    return settings;
  }

  /** Reads a key; a text that is not a key becomes a key of an unknown version. */
  public static RunKey read(String text) {
    try {
      return MAPPER.readValue(text, RunKey.class);
    } catch (JsonProcessingException e) {
      return new RunKey(List.of(program("unknown")), Map.of());
    }
  }

  /** Writes the key as one line. */
  public String text() {
    try {
      return MAPPER.writeValueAsString(this);
    } catch (JsonProcessingException e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * Finds an input that has the same name but another content in another key; empty if results of
   * both keys may be in one table. Settings are not compared.
   */
  public Optional<String> changed(RunKey other) {
    return inputs.stream()
        .filter(input -> other.inputs.stream().anyMatch(input::isChanged))
        .findFirst()
        .map(Input::toString);
  }

  /** Returns the digest of a model: of its parameters if it was fitted, else of its class. */
  private static String digest(DetectionModel model) {
    return Sha256.of(
        model instanceof FittedDetection fitted
            ? ModelFiles.bytes(fitted)
            : bytes(model.getClass().getName()));
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private static Input program(String version) {
    return new Input("version of", "hificamsim", version);
  }

  /**
   * The users' own models, policies and movements on the class path, in the order of their classes'
   * names. Each is identified by the content of its jar or folder, but not of the libraries that it
   * calls.
   */
  private static List<Input> userCode() {
    return Stream.of(DetectionModel.class, ZoomPolicy.class, Movement.class)
        .flatMap(type -> ServiceLoader.load(type).stream())
        .map(ServiceLoader.Provider::type)
        .filter(type -> !isOurs(type))
        .sorted(Comparator.comparing(Class::getName))
        .map(type -> new Input("jar of class", type.getName(), digest(jarOrFolder(type))))
        .toList();
  }

  /** Whether a class is part of the simulator, and so identified by the simulator's version. */
  private static boolean isOurs(Class<?> type) {
    return type.getName().startsWith("org.hificamsim.");
  }

  private static Path jarOrFolder(Class<?> type) {
    try {
      return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * The digest of all files of a jar or folder except its manifest, hidden files and results. A
   * folder and the jar that is made of it for a cluster have the same digest.
   */
  static String digest(Path jarOrFolder) {
    if (Files.isDirectory(jarOrFolder)) {
      return Io.get(() -> digestOfFiles(jarOrFolder));
    }
    return Io.get(
        () -> {
          try (FileSystem jar = FileSystems.newFileSystem(jarOrFolder)) {
            return digestOfFiles(jar.getPath("/"));
          }
        });
  }

  private static String digestOfFiles(Path root) throws IOException {
    Map<String, String> digests = new TreeMap<>();
    Files.walkFileTree(
        root,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
            boolean isSkipped =
                !folder.equals(root) && (isHidden(folder) || OutputFolder.isOutputFolder(folder));
            return !isSkipped ? FileVisitResult.CONTINUE : FileVisitResult.SKIP_SUBTREE;
          }

          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes)
              throws IOException {
            if (attributes.isRegularFile() && !isHidden(file)) {
              digests.put(root.relativize(file).toString(), Sha256.of(file));
            }
            return FileVisitResult.CONTINUE;
          }
        });
    digests.remove(JarFile.MANIFEST_NAME);
    return Sha256.of(digests.toString().getBytes(StandardCharsets.UTF_8));
  }

  private static boolean isHidden(Path file) {
    return file.getFileName().toString().startsWith(".");
  }
}
