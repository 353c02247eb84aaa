package org.hificamsim.runs.compare;

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
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.TreeMap;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.world.Movement;

/**
 * The models, policies and movements that users' jars and folders on the class path bring, each
 * known by the content of its whole jar or folder. Libraries that they call in turn are not looked
 * at.
 */
final class UserCode {
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
