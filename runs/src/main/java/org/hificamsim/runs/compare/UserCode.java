package org.hificamsim.runs.compare;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.world.Movement;

/**
 * The models, policies and movements that users' jars and folders on the class path bring, each
 * known by the content of its jar or folder: the class files, and what lies beside them. Libraries
 * that they call in turn are not looked at.
 */
final class UserCode {
  private static final String CLASS = ".class";

  private UserCode() {}

  /** All that are on this class path, by their classes' names. */
  static List<RunKey.Input> found() {
    return Stream.of(DetectionModel.class, ZoomPolicy.class, Movement.class)
        .flatMap(type -> ServiceLoader.load(type).stream())
        .map(ServiceLoader.Provider::type)
        .filter(type -> !isOurs(type))
        .sorted(Comparator.comparing(Class::getName))
        .map(type -> new RunKey.Input("jar of class", type.getName(), digest(place(type))))
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

  /** The same for a folder and for a jar of its files. */
  static String digest(Path place) {
    try {
      if (Files.isDirectory(place)) {
        return digestBelow(place);
      }
      try (FileSystem jar = FileSystems.newFileSystem(place)) {
        return digestBelow(jar.getPath("/"));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String digestBelow(Path root) throws IOException {
    try (Stream<Path> walk = Files.walk(root)) {
      List<Path> files = walk.filter(Files::isRegularFile).toList();
      Set<Path> packages =
          files.stream()
              .filter(file -> file.toString().endsWith(CLASS))
              .map(Path::getParent)
              .collect(Collectors.toSet());
      String content =
          files.stream()
              .filter(file -> packages.contains(file.getParent()))
              .map(file -> root.relativize(file) + " " + digestOf(file))
              .sorted()
              .collect(Collectors.joining("\n"));
      return Sha256.of(content.getBytes(StandardCharsets.UTF_8));
    }
  }

  private static String digestOf(Path file) {
    try {
      return Sha256.of(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
