package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.net.URL;
import java.net.URLClassLoader;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.stream.Stream;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the output and errors of {@code view}, without its page. */
class ViewCommandTest {
  @Test
  void printsAddressAndEndsWhenPageIsClosed() throws Exception {
    try (ViewProcess view = new ViewProcess(Cli.scenario("lattice-random"))) {
      assertTrue(
          view.address().matches("http://127\\.0\\.0\\.1:\\d+/[0-9a-f]{48}/"), view.address());
      try (InputStream events = URI.create(view.address() + "events").toURL().openStream()) {
        assertEquals('e', events.read()); // event: setup
      }
      assertEquals(0, view.exit(), view.err());
      assertEquals("", view.err());
    }
  }

  @Test
  void reportsErrorInSimulationInOneLine(@TempDir Path folder) throws Exception {
    ClassLoader before = Thread.currentThread().getContextClassLoader();
    try (URLClassLoader loader = withBreaking(folder)) {
      Thread.currentThread().setContextClassLoader(loader);
      try (ViewProcess view =
          new ViewProcess(Cli.scenario("lattice-random"), "--policy", "breaking")) {
        assertEquals(503, command(view, "{\"command\":\"step\",\"steps\":5}"));
        assertEquals(1, view.exit());
        assertEquals("error: AssertionError: broken in a test\n", view.err());
      }
    } finally {
      Thread.currentThread().setContextClassLoader(before);
    }
  }

  /** Returns a class loader that finds {@link Breaking} as a user's policy. */
  private static URLClassLoader withBreaking(Path folder) throws IOException {
    Path services = Files.createDirectories(folder.resolve("META-INF/services"));
    Files.writeString(services.resolve(ZoomPolicy.class.getName()), Breaking.class.getName());
    return new URLClassLoader(new URL[] {folder.toUri().toURL()}, Breaking.class.getClassLoader());
  }

  private static int command(ViewProcess view, String json) throws Exception {
    URI address = URI.create(view.address());
    HttpRequest request =
        HttpRequest.newBuilder(address.resolve("command"))
            .header("Content-Type", "application/json")
            .header("Origin", "http://127.0.0.1:" + address.getPort())
            .POST(HttpRequest.BodyPublishers.ofString(json))
            .timeout(Duration.ofSeconds(20))
            .build();
    return HttpClient.newHttpClient()
        .send(request, HttpResponse.BodyHandlers.discarding())
        .statusCode();
  }

  /** A user's policy that fails after the first step. */
  public static final class Breaking implements ZoomPolicy {
    @Override
    public String name() {
      return "breaking";
    }

    @Override
    public void decide(NetworkView network, int[] levels) {
      if (network.step() > 0) {
        throw new AssertionError("broken in a test");
      }
    }
  }

  @Test
  void reportsPortInUseInOneLine() {
    try (ViewProcess view = new ViewProcess(Cli.scenario("lattice-random"))) {
      int port = URI.create(view.address()).getPort();
      Cli second = Cli.run("view", Cli.scenario("lattice-random"), "--port", port, "--no-browser");
      assertEquals(2, second.exit());
      assertEquals(1, second.err().lines().count(), second.err());
      assertTrue(second.err().startsWith("error: --port is " + port), second.err());
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--port 70000 | --port is 70000, expected a whole number from 0 to 65535",
        "--threshold 2 | threshold is 2.0, expected a number from 0 to 1",
        "--policy grasping | unknown policy 'grasping'",
        "--policy best-fixed | cannot be viewed live",
        "--policy fixed:9 | level of camera",
        "--detection nothing.json | nothing.json",
        "--catalogue nothing.csv | nothing.csv",
        "--seed x | 'x'",
      })
  void rejectsWrongUsageInOneLine(String options, String expected) {
    Object[] words =
        Stream.concat(
                Stream.of("view", Cli.scenario("lattice-random"), "--no-browser"),
                Stream.of(options.strip().split(" ")))
            .toArray();
    Cli view = Cli.run(words);
    assertEquals(2, view.exit(), view.err());
    assertEquals(1, view.err().lines().count(), view.err());
    assertTrue(view.err().contains(expected), view.err());
    assertEquals("", view.out());
  }
}
