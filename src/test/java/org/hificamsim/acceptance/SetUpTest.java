package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the output of {@code ./hificamsim} and {@code ./test} if programs are missing. */
class SetUpTest {
  private static final String MISSING = "hificamsim: missing: openjdk-17-jdk-headless gradle";
  private static final String LIBRARIES =
      "libraries from Maven Central (some 100 MB)"
          + " and OpenCV from Maven Central (101 MB; libopencv-java takes its place)";

  @TempDir Path folder;

  /** Creates an apt-get that logs its calls, and a sudo without password. */
  @BeforeEach
  void createFakePrograms() throws IOException {
    program(
        "apt-get",
        "echo \"$*\" >>calls",
        "echo 'Need to get 85.5 MB of archives.'",
        "[ ! -e broken ] || exit 100");
    program("sudo", "shift", "exec \"$@\"");
  }

  @Test
  void announcesPackagesAndDownloadSize() throws Exception {
    Output output = source("install_missing");
    assertEquals(0, output.exit(), output.text());
    assertEquals(
        List.of(MISSING + "; asking apt-get for it", "hificamsim: installing it, 85.5 MB to fetch"),
        output.lines());
    assertEquals(1, calls().stream().filter(call -> call.contains("--yes openjdk-17")).count());
  }

  @Test
  void printsOutputOfFailedAptGet() throws Exception {
    Files.createFile(folder.resolve("broken"));
    Output output = source("install_missing");
    assertEquals(1, output.exit());
    assertEquals(
        "hificamsim: could not install openjdk-17-jdk-headless gradle",
        output.lines().get(output.lines().size() - 1));
    assertEquals("Need to get 85.5 MB of archives.", output.lines().get(2));
  }

  @Test
  void listsMissingPackagesInOneLine() throws Exception {
    Output output = source("installing=no; install_missing");
    assertEquals(1, output.exit());
    assertEquals(
        List.of(MISSING + "; as root: apt-get install openjdk-17-jdk-headless gradle"),
        output.lines());
    assertFalse(Files.exists(folder.resolve("calls")));
  }

  @Test
  void continuesWithoutBrowser() throws Exception {
    Output output = source("installing=no; PATH=$PWD; install_browser");
    assertEquals(0, output.exit());
    assertEquals(
        List.of(
            "hificamsim: missing: chromium and chromedriver, so pages are not tested;"
                + " as root: apt-get install chromium chromium-driver"),
        output.lines());
  }

  @Test
  void announcesDownloadSizeOfGradle() throws Exception {
    assertEquals(List.of("hificamsim: fetching " + LIBRARIES), source("tell_libraries").lines());
    Output rejected = source("installing=no; tell_libraries");
    assertEquals(1, rejected.exit());
    assertEquals(List.of("hificamsim: missing: " + LIBRARIES), rejected.lines());
    Path cache = folder.resolve("gradle/caches/modules-2/files-2.1");
    Files.createDirectories(cache.resolve("com.google.errorprone"));
    Files.createDirectories(cache.resolve("org.openpnp"));
    assertEquals(List.of(), source("tell_libraries").lines());
  }

  @Test
  void announcesDownloadForOption() throws Exception {
    assertAnnounced(
        "onnx",
        "com.microsoft.onnxruntime",
        "ONNX Runtime from Maven Central (93 MB), for --policy onnx:FILE");
    assertAnnounced(
        "parquet",
        "org.apache.parquet",
        "Parquet from Maven Central (11 MB), for --format parquet");
    assertAnnounced(
        "ortools",
        "com.google.ortools",
        "OR-Tools from Maven Central (33 MB), for place --method exact");
  }

  private void assertAnnounced(String module, String group, String wanted) throws Exception {
    Path script = Cli.ROOT.resolve("tools/parts.sh").toRealPath();
    String words = "build_if_stale() { echo $2; }; libraries=lib; . " + script + "; part " + module;
    String built = ":" + module + ":libraries";
    assertEquals(List.of("hificamsim: fetching " + wanted, built), source(words).lines());
    Output rejected = source("installing=no; " + words);
    assertEquals(1, rejected.exit());
    assertEquals(List.of("hificamsim: missing: " + wanted), rejected.lines());
    Files.createDirectories(folder.resolve("gradle/caches/modules-2/files-2.1/" + group));
    assertEquals(List.of(built), source(words).lines());
  }

  /** The exit code of a script, and the text of both its outputs. */
  private record Output(int exit, String text) {
    List<String> lines() {
      return text.lines().toList();
    }
  }

  /** Runs a command within {@code tools/setup.sh} as if there were no JDK, Gradle or OpenCV. */
  private Output source(String words) throws Exception {
    Path script = Cli.ROOT.resolve("tools/setup.sh").toRealPath();
    String missing = "gradle=/none; build_home() { return 1; }; debian_opencv=/none;";
    ProcessBuilder shell =
        new ProcessBuilder("sh", "-euc", "root=$PWD; . " + script + "; " + missing + words)
            .directory(folder.toFile())
            .redirectErrorStream(true);
    shell.environment().merge("PATH", folder.toString(), (path, fake) -> fake + ":" + path);
    shell.environment().put("GRADLE_USER_HOME", folder.resolve("gradle").toString());
    Process process = shell.start();
    process.getOutputStream().close();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    return new Output(process.waitFor(), text);
  }

  private List<String> calls() throws IOException {
    return Files.readAllLines(folder.resolve("calls"));
  }

  private void program(String name, String... lines) throws IOException {
    Path program = folder.resolve(name);
    Files.writeString(program, "#!/bin/sh\n" + String.join("\n", lines) + "\n");
    program.toFile().setExecutable(true);
  }
}
