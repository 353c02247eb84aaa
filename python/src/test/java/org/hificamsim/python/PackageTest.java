package org.hificamsim.python;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.abort;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/**
 * Tests the Python package as a user gets it: its wheel is built and installed into a virtual
 * environment, where pytest runs {@code python/tests}. Each test of pytest is a test here.
 */
class PackageTest {
  private static final Path PYTHON = Path.of(System.getProperty("hificamsim.root"), "python");
  private static final Path VENV = Path.of(System.getProperty("python.venv"));

  @TempDir private Path folder;

  @TestFactory
  Stream<DynamicTest> pythonTestsPass() throws Exception {
    assumeTrue(Files.exists(VENV.resolve("locked")), "no virtual environment");
    String installed =
        run(
            "-m",
            "pip",
            "install",
            "--disable-pip-version-check",
            "--no-index",
            "--no-deps",
            "--no-build-isolation",
            "--force-reinstall",
            "--no-compile",
            PYTHON.toString());
    assertTrue(installed.contains("Successfully installed hificamsim"), installed);
    Path report = folder.resolve("pytest.xml");
    String output =
        run(
            "-m",
            "pytest",
            "-q",
            "--rootdir",
            PYTHON.toString(),
            "-c",
            PYTHON.resolve("pyproject.toml").toString(),
            "-p",
            "no:cacheprovider",
            "--junit-xml",
            report.toString(),
            PYTHON.resolve("tests").toString());
    assertTrue(Files.exists(report), output);
    List<Element> cases = cases(report);
    assertTrue(cases.size() > 50, cases.size() + " tests");
    return cases.stream().map(PackageTest::test);
  }

  private static DynamicTest test(Element testCase) {
    String name = testCase.getAttribute("classname") + "." + testCase.getAttribute("name");
    return DynamicTest.dynamicTest(name, () -> judge(testCase));
  }

  private static void judge(Element testCase) {
    for (String kind : List.of("failure", "error")) {
      NodeList faults = testCase.getElementsByTagName(kind);
      if (faults.getLength() > 0) {
        fail(faults.item(0).getTextContent());
      }
    }
    NodeList skipped = testCase.getElementsByTagName("skipped");
    if (skipped.getLength() > 0) {
      abort(((Element) skipped.item(0)).getAttribute("message"));
    }
  }

  private static List<Element> cases(Path report) throws Exception {
    NodeList found =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(report.toFile())
            .getElementsByTagName("testcase");
    return IntStream.range(0, found.getLength()).mapToObj(i -> (Element) found.item(i)).toList();
  }

  /**
   * Runs Python in an empty directory, so that it finds the installed package; returns its output.
   */
  private String run(String... words) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(VENV.resolve("bin/python").toString()));
    command.addAll(List.of(words));
    Path outputFile = Files.createTempFile(folder, "said", ".txt");
    ProcessBuilder builder =
        new ProcessBuilder(command)
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectOutput(outputFile.toFile());
    builder.environment().put("PYTHONPYCACHEPREFIX", VENV.resolve("pycache").toString());
    // The tests are short, and small matrices are faster on one thread.
    builder.environment().put("HIFICAMSIM_OPTS", "-XX:TieredStopAtLevel=1");
    builder.environment().put("OPENBLAS_NUM_THREADS", "1");
    builder.environment().remove("PYTHONPATH");
    if (words[1].equals("pip")) {
      builder.environment().put("HIFICAMSIM_JARS", System.getProperty("python.jars"));
    }
    Process python = builder.start();
    try {
      assertTrue(python.waitFor(30, TimeUnit.MINUTES), "no end after 30 minutes");
    } finally {
      python.destroyForcibly();
    }
    String text = Files.readString(outputFile, StandardCharsets.UTF_8);
    return python.exitValue() == 0 ? text : text + "\nexit code " + python.exitValue();
  }
}
