package org.hificamsim.runs.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.jar.JarOutputStream;
import java.util.zip.ZipEntry;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class UserCodeTest {
  @TempDir Path folder;

  @BeforeEach
  void writeClassAndResources() throws IOException {
    write("org/example/Fog.class", "fog");
    write("org/example/weights.txt", "1 2 3");
    write("META-INF/services/any", "org.example.Fog");
  }

  @Test
  void digestDependsOnEveryFileOfJar() throws IOException {
    assertNotEquals(RunKey.digest(jar("org/example/weights.txt")), RunKey.digest(jar("a.txt")));
    assertEquals(RunKey.digest(jar("a.txt")), RunKey.digest(jar("a.txt")));
  }

  private Path jar(String resource) throws IOException {
    Path jar = Files.createTempFile(folder, "packed", ".jar");
    try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar))) {
      out.putNextEntry(new ZipEntry(resource));
    }
    return jar;
  }

  @Test
  void digestDependsOnEveryFileOfFolder() throws IOException {
    String before = RunKey.digest(folder);
    write("org/example/Fog.class", "mist");
    assertNotEquals(before, RunKey.digest(folder));
    write("org/example/Fog.class", "fog");
    assertEquals(before, RunKey.digest(folder));
    write("org/example/weights.txt", "1 2 4");
    assertNotEquals(before, RunKey.digest(folder));
    write("org/example/weights.txt", "1 2 3");
    write("tables/far/haze.csv", "0.5");
    assertNotEquals(before, RunKey.digest(folder), "a resource in a package of its own");
  }

  @Test
  void digestIgnoresResultsAndHiddenFiles() throws IOException {
    String before = RunKey.digest(folder);
    write("out/compare/.hificamsim.sha256", "");
    write("out/compare/steps.csv", "1");
    write(".notes", "to do");
    assertEquals(before, RunKey.digest(folder));
  }

  private void write(String file, String content) throws IOException {
    Path path = folder.resolve(file);
    Files.createDirectories(path.getParent());
    Files.writeString(path, content);
  }
}
