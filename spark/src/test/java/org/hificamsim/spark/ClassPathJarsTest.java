package org.hificamsim.spark;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ClassPathJarsTest {
  @TempDir Path folder;

  @Test
  void sendsJarsAndPackedFoldersWithoutSpark() throws IOException {
    Path sparkFolder = Files.createDirectories(folder.resolve("spark"));
    Path sparkJar = Files.writeString(sparkFolder.resolve("spark-core.jar"), "");
    Path jar = Files.writeString(folder.resolve("own.jar"), "");
    Path classes = Files.createDirectories(folder.resolve("classes"));
    Files.writeString(Files.createDirectories(classes.resolve("a/b")).resolve("C.class"), "c");
    String packed;
    try (ClassPathJars jars =
        new ClassPathJars(
            List.of(sparkJar, jar, folder.resolve("missing.jar"), classes), sparkFolder)) {
      assertEquals(2, jars.paths().size(), jars.paths().toString());
      assertEquals(jar.toString(), jars.paths().get(0));
      packed = jars.paths().get(1);
      try (JarFile file = new JarFile(packed)) {
        assertEquals("a/b/C.class", file.stream().findFirst().orElseThrow().getName());
        assertEquals(1, file.size());
      }
    }
    assertFalse(Files.exists(Path.of(packed)));
    assertTrue(Files.exists(jar));
  }
}
