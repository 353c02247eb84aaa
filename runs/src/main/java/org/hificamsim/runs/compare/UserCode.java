package org.hificamsim.runs.compare;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.ServiceLoader;
import java.util.stream.Stream;
import org.hificamsim.core.detection.DetectionModel;
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

  /** Of a whole jar, or of all files of a folder but results and what is hidden. */
  static String digest(Path place) {
    return Files.isDirectory(place) ? digestBelow(place) : digestOf(place);
  }

  private static String digestBelow(Path root) {
    StringBuilder content = new StringBuilder();
    List<Path> files = new ArrayList<>();
    try {
      Files.walkFileTree(root, new Contents(root, files));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    for (Path file : files.stream().sorted().toList()) {
      content.append(root.relativize(file)).append(' ').append(digestOf(file)).append('\n');
    }
    return Sha256.of(content.toString().getBytes(StandardCharsets.UTF_8));
  }

  /** Collects files, without those of folders that commands write into. */
  private static final class Contents extends SimpleFileVisitor<Path> {
    private final Path root;
    private final List<Path> files;

    Contents(Path root, List<Path> files) {
      this.root = root;
      this.files = files;
    }

    @Override
    public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
      boolean skipped = !folder.equals(root) && (isHidden(folder) || OutputFolder.isOne(folder));
      return skipped ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
      if (attributes.isRegularFile() && !isHidden(file)) {
        files.add(file);
      }
      return FileVisitResult.CONTINUE;
    }

    private static boolean isHidden(Path file) {
      return file.getFileName().toString().startsWith(".");
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
