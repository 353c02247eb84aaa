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
 * This process's class path as jars for executors: all but Spark's own, which they have. A folder
 * of classes becomes a jar until this is closed.
 */
final class ClassPathJars implements Closeable {
  private final List<String> jars = new ArrayList<>();
  private final List<TemporaryFile> packed = new ArrayList<>();

  /**
   * @param sparks the folder of Spark's jars
   */
  ClassPathJars(List<Path> classPath, Path sparks) throws IOException {
    for (Path one : classPath) {
      Path entry = one.toAbsolutePath().normalize();
      if (Files.isDirectory(entry)) {
        jars.add(pack(entry));
      } else if (Files.isRegularFile(entry) && !sparks.equals(entry.getParent())) {
        jars.add(entry.toString());
      }
    }
  }

  /** Their paths. */
  List<String> paths() {
    return List.copyOf(jars);
  }

  private String pack(Path folder) throws IOException {
    TemporaryFile jar = new TemporaryFile("classes-" + packed.size() + ".jar");
    packed.add(jar);
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
    for (TemporaryFile jar : packed) {
      Io.run(() -> jar.close());
    }
  }
}
