package org.hificamsim.runs.compare;

import java.io.File;
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
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.ServiceLoader;
import java.util.jar.JarFile;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
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

  /**
   * Of all files of a jar or a folder but its manifest, results and what is hidden: a folder has
   * the same digest as a jar that was made of it, as for a cluster.
   */
  static String digest(Path place) {
    try {
      List<String> lines = Files.isDirectory(place) ? below(place) : inside(place);
      String content = lines.stream().sorted().collect(Collectors.joining());
      return Sha256.of(content.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static List<String> below(Path root) throws IOException {
    List<Path> files = new ArrayList<>();
    Files.walkFileTree(root, new Contents(root, files));
    List<String> lines = new ArrayList<>();
    for (Path file : files) {
      String name = root.relativize(file).toString().replace(File.separatorChar, '/');
      if (!name.equals(JarFile.MANIFEST_NAME)) {
        lines.add(line(name, Sha256.of(file)));
      }
    }
    return lines;
  }

  private static List<String> inside(Path jar) throws IOException {
    List<String> lines = new ArrayList<>();
    try (ZipFile file = new ZipFile(jar.toFile())) {
      for (ZipEntry entry : Collections.list(file.entries())) {
        if (!entry.isDirectory() && !entry.getName().equals(JarFile.MANIFEST_NAME)) {
          byte[] content = file.getInputStream(entry).readAllBytes();
          lines.add(line(entry.getName(), Sha256.of(content)));
        }
      }
    }
    return lines;
  }

  private static String line(String name, String digest) {
    return name + ' ' + digest + '\n';
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
}
