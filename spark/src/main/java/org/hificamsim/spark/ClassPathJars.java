package org.hificamsim.spark;

import java.io.Closeable;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.JarOutputStream;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import org.hificamsim.core.file.Io;

/**
 * The class path of this process as jars for executors, without Spark's own jars, which executors
 * have. A folder of classes is packed into a temporary jar, which is deleted when this object is
 * closed.
 */
final class ClassPathJars implements Closeable {
  private final List<String> jars = new ArrayList<>();
  private final List<TemporaryFile> temporaryJars = new ArrayList<>();

  /**
   * @param sparkJars the folder of Spark's jars
   */
  ClassPathJars(List<Path> classPath, Path sparkJars) throws IOException {
    for (Path path : classPath) {
      Path entry = path.toAbsolutePath().normalize();
      if (Files.isDirectory(entry)) {
        jars.add(pack(entry));
      } else if (Files.isRegularFile(entry) && !sparkJars.equals(entry.getParent())) {
        jars.add(entry.toString());
      }
    }
  }

  /** The paths of the jars. */
  List<String> paths() {
    return List.copyOf(jars);
  }

  private String pack(Path folder) throws IOException {
    TemporaryFile jar = new TemporaryFile("classes-" + temporaryJars.size() + ".jar");
    temporaryJars.add(jar);
    try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar.path()));
        Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.filter(Files::isRegularFile).sorted().toList()) {
        String name = folder.relativize(file).toString().replace(File.separatorChar, '/');
        out.putNextEntry(new ZipEntry(name));
        Files.copy(file, out);
      }
    }
    return jar.path().toString();
  }

  @Override
  public void close() {
    for (TemporaryFile jar : temporaryJars) {
      Io.run(() -> jar.close());
    }
  }
}
