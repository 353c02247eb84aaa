package org.hificamsim.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeSet;
import java.util.jar.JarFile;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that CamSim and the bridge do not see each other's libraries. */
class IsolationTest {
  private static final List<String> LIBRARIES =
      List.of(
          "com.fasterxml.jackson.core.JsonFactory",
          "com.fasterxml.jackson.dataformat.csv.CsvFactory",
          "net.bytebuddy.agent.builder.AgentBuilder",
          "org.apache.commons.math3.distribution.TDistribution",
          "org.hificamsim.core.engine.Simulation");

  @TempDir Path folder;

  @Test
  void otherVersionsOfLibrariesOnClassPathOfCamSimDoNotMatter() throws IOException {
    Path otherVersions = folder.resolve("other-versions");
    for (String name : LIBRARIES) {
      int dot = name.lastIndexOf('.');
      Variant.compile(
          otherVersions,
          name.replace('.', '/') + ".java",
          "package %s; public class %s { public static final int OLD = 1; }"
              .formatted(name.substring(0, dot), name.substring(dot + 1)));
    }
    Path classes = otherVersions.resolve("classes");
    Path services = Files.createDirectories(classes.resolve("META-INF/services"));
    Files.writeString(
        services.resolve("org.hificamsim.core.policy.ZoomPolicy"), "org.example.Missing");
    String options = "detection=hifi:orb-lin,policy=sarsa,out=results";
    CamSimRun with =
        CamSimRun.start(
            folder.resolve("with"),
            options,
            List.of(classes, CamSimRun.DOUBLES),
            "epics.camwin.Main",
            List.of("-t", "50", "-o", "output.csv", CamSimRun.CROSSING.toString()));
    assertEquals("", with.err());
    CamSimRun alone = CamSimRun.of(folder.resolve("alone"), options, CamSimRun.CROSSING, 50);
    assertEquals(alone.all(), with.all());
    assertEquals(alone.text("results/summary.json"), with.text("results/summary.json"));
  }

  @Test
  void camSimDoesNotSeeLibrariesOfBridge() throws IOException {
    Path classes =
        Variant.compile(
            folder,
            "Probe.java",
            """
public class Probe {
  public static void main(String[] names) {
    for (String name : names) {
      try {
        System.out.println(Class.forName(name));
      } catch (ClassNotFoundException e) {
        System.out.println(Probe.class.getResource("/" + name.replace('.', '/') + ".class"));
      }
    }
  }
}
""");
    CamSimRun probe =
        CamSimRun.start(
            folder.resolve("probe"),
            "policy=sarsa",
            List.of(classes, CamSimRun.DOUBLES),
            "Probe",
            LIBRARIES);
    assertEquals("null\n".repeat(LIBRARIES.size()), probe.out());
  }

  @Test
  void jarRootHoldsOnlyTheAgent() throws IOException {
    try (JarFile jar = new JarFile(CamSimRun.AGENT.toFile())) {
      List<String> classes =
          jar.stream()
              .map(entry -> entry.getName())
              .filter(name -> name.endsWith(".class") && !name.startsWith("isolated/"))
              .toList();
      assertTrue(classes.size() > 3);
      assertTrue(
          classes.stream().allMatch(name -> name.startsWith("org/hificamsim/bridge/agent/")),
          classes.toString());
      assertTrue(jar.stream().noneMatch(entry -> entry.getName().contains("META-INF/services")));
    }
  }

  @Test
  void jarContainsLicencesOfItsLibraries() throws IOException {
    try (JarFile jar = new JarFile(CamSimRun.AGENT.toFile())) {
      TreeSet<String> licensed =
          jar.stream()
              .map(entry -> entry.getName())
              .filter(name -> name.matches("META-INF/.+/LICENSE(\\.txt)?"))
              .map(name -> name.split("/")[1].replaceAll("-[0-9.]+$", ""))
              .collect(Collectors.toCollection(TreeSet::new));
      assertEquals(
          List.of(
              "byte-buddy",
              "commons-math3",
              "jackson-annotations",
              "jackson-core",
              "jackson-databind",
              "jackson-dataformat-csv"),
          List.copyOf(licensed));
      assertTrue(jar.getEntry("META-INF/LICENSE") != null);
    }
  }
}
