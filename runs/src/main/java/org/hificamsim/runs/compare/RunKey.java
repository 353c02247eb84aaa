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
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.model.ModelFiles;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.PolicyFiles;

/**
 * What a run's result depends on, but for its seed: two runs with the same key give the same
 * result.
 *
 * @param inputs what has a name and a content: this program, the users' classes on the class path,
 *     the scenario, the detection, the files that a policy decides by
 * @param settings each by its name, but for those that say which runs there are
 */
public record RunKey(List<Input> inputs, Map<String, String> settings) {
  /**
   * An input with a content.
   *
   * @param digest of the content
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

  /** The key of a plan's repeats. */
  public static RunKey of(RunPlan plan) {
    return of(List.of(plan)).get(0);
  }

  /** The keys of plans, in their order. */
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

  /** Without what is among the settings of the key, wherever it comes from. */
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

  /** The key of a text; one of an unknown version where it is none of ours. */
  public static RunKey read(String text) {
    try {
      return MAPPER.readValue(text, RunKey.class);
    } catch (JsonProcessingException e) {
      return new RunKey(List.of(program("unknown")), Map.of());
    }
  }

  /** The key in one line. */
  public String text() {
    try {
      return MAPPER.writeValueAsString(this);
    } catch (JsonProcessingException e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * The input that has another content under the same name in another key; empty where results of
   * both may stand side by side.
   */
  public Optional<String> changed(RunKey other) {
    return inputs.stream()
        .filter(input -> other.inputs.stream().anyMatch(input::isChanged))
        .findFirst()
        .map(Input::toString);
  }

  /** Of all parameters; of a model that is code, of its class, which users' code is known by. */
  private static String digest(DetectionModel model) {
    return Sha256.of(
        model instanceof HiFiDetection fitted
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
   * The models, policies and movements that users' jars and folders on the class path bring, by
   * their classes' names, each known by the content of its whole jar or folder. Libraries that they
   * call in turn are not looked at.
   */
  private static List<Input> userCode() {
    return Stream.of(DetectionModel.class, ZoomPolicy.class, Movement.class)
        .flatMap(type -> ServiceLoader.load(type).stream())
        .map(ServiceLoader.Provider::type)
        .filter(type -> !isOurs(type))
        .sorted(Comparator.comparing(Class::getName))
        .map(type -> new Input("jar of class", type.getName(), digest(place(type))))
        .toList();
  }

  /** Parts of the simulator's own are known by its version. */
  private static boolean isOurs(Class<?> type) {
    return type.getName().startsWith("org.hificamsim.");
  }

  private static Path place(Class<?> type) {
    try {
      return Path.of(type.getProtectionDomain().getCodeSource().getLocation().toURI());
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * Of all files of a jar or a folder but its manifest, results and what is hidden: a folder has
   * the same digest as a jar that was made of it, as for a cluster.
   */
  static String digest(Path place) {
    if (Files.isDirectory(place)) {
      return Io.get(() -> ofFiles(place));
    }
    return Io.get(
        () -> {
          try (FileSystem jar = FileSystems.newFileSystem(place)) {
            return ofFiles(jar.getPath("/"));
          }
        });
  }

  private static String ofFiles(Path root) throws IOException {
    Map<String, String> digests = new TreeMap<>();
    Files.walkFileTree(
        root,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
            boolean counts =
                folder.equals(root) || !(isHidden(folder) || OutputFolder.isOne(folder));
            return counts ? FileVisitResult.CONTINUE : FileVisitResult.SKIP_SUBTREE;
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
