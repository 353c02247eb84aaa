package org.hificamsim.presentation.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.Socket;
import java.net.SocketException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests which requests the server answers and refuses, and when it ends. */
class ViewServerTest {
  private static final Duration GRACE = Duration.ofMillis(600);

  private final HttpClient client = HttpClient.newHttpClient();
  private final CountDownLatch ended = new CountDownLatch(1);
  private LiveSession session;
  private ViewServer server;
  private URI address;

  @BeforeEach
  void start() throws IOException {
    Catalogue catalogue = Catalogue.load();
    LiveRun run =
        new LiveRun(
            catalogue,
            new LiveRun.ShownScenario(Scenarios.read("cluster-random"), List.of()),
            new LiveChoice("hifi:orb-lin", null, "sarsa"),
            0,
            Optional.empty());
    session = new LiveSession(run);
    server = new ViewServer(session, "<p>the page</p>", 0, GRACE);
    address = URI.create(server.address());
    Thread waiting =
        new Thread(
            () -> {
              try {
                server.awaitEnd();
                ended.countDown();
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            });
    waiting.setDaemon(true);
    waiting.start();
  }

  @AfterEach
  void stop() {
    server.close();
    session.close();
  }

  @Test
  void servesPageAtAddressWithToken() throws Exception {
    HttpResponse<String> page = get(address);
    assertEquals(200, page.statusCode());
    assertEquals("<p>the page</p>", page.body());
    assertEquals("no-referrer", page.headers().firstValue("Referrer-Policy").orElseThrow());
    assertEquals("no-store", page.headers().firstValue("Cache-Control").orElseThrow());
    assertTrue(page.headers().firstValue("Access-Control-Allow-Origin").isEmpty());
  }

  @Test
  void tokensAreLongAndDiffer() {
    Set<String> tokens = new HashSet<>();
    for (int i = 0; i < 100; i++) {
      tokens.add(new Guard(80).token());
    }
    assertEquals(100, tokens.size());
    assertTrue(tokens.stream().allMatch(token -> token.matches("[0-9a-f]{32,}")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"/", "/events", "/command", "/0123/", "/%2e%2e/", "/favicon.ico"})
  void rejectsRequestsWithoutToken(String path) throws Exception {
    HttpResponse<String> answer = get(address.resolve(path));
    assertEquals(403, answer.statusCode());
    assertEquals("refused: no token\n", answer.body());
  }

  @Test
  void rejectsSimilarTokens() throws Exception {
    String token = address.getPath().substring(1, address.getPath().length() - 1);
    String last = token.endsWith("0") ? "1" : "0";
    String similar = token.substring(0, token.length() - 1) + last;
    for (String wrong :
        List.of(similar, token + "0", token.substring(1), "g" + token.substring(1))) {
      assertEquals(403, get(address.resolve("/" + wrong + "/")).statusCode());
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "evil.example:PORT",
        "127.0.0.1",
        "127.0.0.1:1",
        "127.0.0.1:PORT\r\nHost: a.b",
        ""
      })
  void rejectsRequestsToOtherHosts(String host) throws Exception {
    String ownHost = host.replace("PORT", Integer.toString(address.getPort()));
    String request = "GET " + address.getPath() + " HTTP/1.1\r\nHost: " + ownHost + "\r\n\r\n";
    String status = raw(request);
    assertTrue(status.contains(" 403 ") || status.contains(" 400 "), status);
  }

  @ParameterizedTest
  @CsvSource({
    "http://evil.example, 403",
    "null, 403",
    "http://127.0.0.1:1, 403",
    "https://127.0.0.1:PORT, 403",
    "http://localhost:PORT, 403",
    "http://127.0.0.1:PORT, 204",
  })
  void rejectsCommandsOfOtherOrigins(String origin, int status) throws Exception {
    String ownOrigin = origin.replace("PORT", Integer.toString(address.getPort()));
    HttpRequest.Builder request = post("{\"command\":\"pause\"}").setHeader("Origin", ownOrigin);
    assertEquals(status, send(request).statusCode());
  }

  @Test
  void rejectsCommandsWithoutOriginAndStreamsOfOtherSites() throws Exception {
    HttpRequest.Builder bare =
        HttpRequest.newBuilder(address.resolve("command"))
            .header("Content-Type", "application/json")
            .POST(HttpRequest.BodyPublishers.ofString("{\"command\":\"pause\"}"));
    assertEquals(403, send(bare).statusCode());
    HttpRequest.Builder stream =
        HttpRequest.newBuilder(address.resolve("events")).header("Origin", "http://evil.example");
    assertEquals(403, send(stream).statusCode());
    HttpRequest.Builder crossSite =
        HttpRequest.newBuilder(address.resolve("events")).header("Sec-Fetch-Site", "cross-site");
    assertEquals(403, send(crossSite).statusCode());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "not json | Unrecognized token",
        "{} | command",
        "[] | command",
        "null | null",
        "{\"command\":\"dance\"} | dance",
        "{\"command\":\"pause\",\"now\":1} | now",
        "{\"command\":\"pause\"} {} | Trailing token",
        "{\"command\":\"speed\"} | perSecond",
        "{\"command\":\"speed\",\"perSecond\":\"5\"} | Cannot coerce",
        "{\"command\":\"speed\",\"perSecond\":5.5} | 5.5",
        "{\"command\":\"speed\",\"perSecond\":0} | perSecond is 0, expected a whole number from 1",
        "{\"command\":\"speed\",\"perSecond\":1,\"perSecond\":2} | Duplicate",
        "{\"command\":\"step\",\"steps\":1001} | steps is 1001",
        "{\"command\":null} | command",
        "{\"command\":\"choose\",\"side\":0,\"detection\":null,\"threshold\":null,\"policy\":\"sarsa\"}"
            + " | detection is null",
        "{\"command\":\"choose\",\"side\":0,\"detection\":\"geometric\",\"threshold\":null,\"policy\":null}"
            + " | policy is null",
        "{\"command\":\"restart\",\"seed\":null,\"keepCameras\":true} | seed",
        "{\"command\":\"drag\",\"camera\":0,\"x\":NaN,\"y\":0} | NaN",
        "{\"command\":\"drag\",\"camera\":99,\"x\":0,\"y\":0} | camera is 99",
        "{\"command\":\"drag\",\"camera\":0,\"x\":1e300,\"y\":0} | expected a place in the field",
        "{\"command\":\"turn\",\"camera\":0,\"heading\":1e999} | heading is Infinity, expected"
            + " degrees",
        "{\"command\":\"add\",\"like\":99,\"x\":0,\"y\":0} | camera is 99",
        "{\"command\":\"add\",\"like\":0,\"x\":0,\"y\":1e9} | expected a place in the field",
        "{\"command\":\"compare\",\"on\":1} | on",
        "{\"command\":\"choose\",\"side\":3,\"detection\":\"geometric\",\"threshold\":null,\"policy\":\"zoom-out\"}"
            + " | side is 3",
        "{\"command\":\"choose\",\"side\":0,\"detection\":\"/etc/passwd\",\"threshold\":null,\"policy\":\"zoom-out\"}"
            + " | unknown detection '/etc/passwd'",
      })
  void reportsInvalidCommandInOneLine(String body, String expected) throws Exception {
    HttpResponse<String> answer = send(post(body));
    assertEquals(400, answer.statusCode(), answer.body());
    assertEquals(1, answer.body().lines().count(), answer.body());
    assertTrue(answer.body().contains(expected), answer.body());
    assertFalse(answer.body().contains("\tat "), answer.body());
    assertEquals(204, send(post("{\"command\":\"pause\"}")).statusCode());
  }

  @Test
  void rejectsLargeBodiesAndOtherTypes() throws Exception {
    assertEquals(413, send(post(" ".repeat(5000))).statusCode());
    HttpRequest.Builder form =
        post("{\"command\":\"pause\"}").setHeader("Content-Type", "text/plain");
    assertEquals(415, send(form).statusCode());
    String deep = "[".repeat(4000);
    assertEquals(400, send(post(deep)).statusCode());
  }

  @ParameterizedTest
  @CsvSource({"POST,''", "GET,command", "POST,events", "GET,other", "PUT,command", "GET,../../x"})
  void answersOtherRequestsWithNotFound(String method, String path) throws Exception {
    HttpRequest.Builder request =
        HttpRequest.newBuilder(URI.create(address + path))
            .header("Origin", origin())
            .method(method, HttpRequest.BodyPublishers.noBody());
    assertEquals(404, send(request).statusCode());
  }

  @ParameterizedTest
  @CsvSource({"'', 15", "events, 0", "scenario.xml,"})
  void headRequestsGetHeadersWithoutBody(String path, String length) throws Exception {
    HttpResponse<String> head =
        send(
            HttpRequest.newBuilder(URI.create(address + path))
                .method("HEAD", HttpRequest.BodyPublishers.noBody()));
    assertEquals(200, head.statusCode());
    assertEquals("", head.body());
    assertEquals("no-store", head.headers().firstValue("Cache-Control").orElseThrow());
    String sent = head.headers().firstValue("Content-Length").orElseThrow();
    assertTrue(length == null ? Integer.parseInt(sent) > 1000 : sent.equals(length), sent);
  }

  @Test
  void limitsNumberOfHalfOpenConnections() throws Exception {
    assertEquals(204, send(post("{\"command\":\"pause\"}")).statusCode());
    List<Socket> halfOpen = new ArrayList<>();
    for (int i = 0; i < 150; i++) {
      Socket socket = new Socket(InetAddress.getLoopbackAddress(), address.getPort());
      halfOpen.add(socket);
      try {
        socket.getOutputStream().write("POST / HTTP/1.1\r\n".getBytes(StandardCharsets.UTF_8));
      } catch (SocketException e) {
        // above the limit
      }
    }
    long start = System.nanoTime();
    assertEquals(204, send(post("{\"command\":\"pause\"}")).statusCode());
    assertTrue(System.nanoTime() - start < TimeUnit.SECONDS.toNanos(2));
    for (Socket socket : halfOpen) {
      socket.setSoTimeout(5000);
      try {
        assertEquals(-1, socket.getInputStream().read(), "closed after some time");
      } catch (SocketException e) {
        // reset
      }
      socket.close();
    }
  }

  @Test
  void serverListensOnLoopbackDeviceOnly() throws Exception {
    for (NetworkInterface device : Collections.list(NetworkInterface.getNetworkInterfaces())) {
      device
          .inetAddresses()
          .filter(inet -> !inet.isLoopbackAddress())
          .forEach(
              inet ->
                  assertThrows(
                      IOException.class,
                      () -> {
                        try (Socket socket = new Socket()) {
                          socket.connect(new InetSocketAddress(inet, address.getPort()), 500);
                        }
                      }));
    }
  }

  @Test
  void pageGetsSetupPastStepsAndNewSteps() throws Exception {
    send(post("{\"command\":\"step\",\"steps\":30}"));
    try (Page page = new Page()) {
      JsonNode setup = page.next("setup");
      assertEquals("sarsa", setup.at("/sides/0/setup/policy").asText());
      assertEquals("Q", setup.at("/sides/0/estimated").asText());
      assertEquals(30, page.stepsUntil(30));
      assertFalse(page.next("state").at("/running").asBoolean());
      send(post("{\"command\":\"step\",\"steps\":1}"));
      assertEquals(31, page.stepsUntil(31));
    }
  }

  @Test
  void downloadedScenarioHasChangedCameras() throws Exception {
    send(post("{\"command\":\"drag\",\"camera\":0,\"x\":0.5,\"y\":-0.25}"));
    assertEquals(
        204, send(post("{\"command\":\"turn\",\"camera\":0,\"heading\":12}")).statusCode());
    assertEquals(204, send(post("{\"command\":\"add\",\"like\":0,\"x\":1,\"y\":2}")).statusCode());
    HttpResponse<String> scenario = get(address.resolve("scenario.xml"));
    assertEquals(200, scenario.statusCode());
    assertEquals("attachment", scenario.headers().firstValue("Content-Disposition").orElseThrow());
    String body = scenario.body();
    assertTrue(body.contains("name=\"Cam_01\" x=\"0.5\" y=\"-0.25\" heading=\"12.0\""), body);
    assertTrue(body.contains("name=\"added-1\" x=\"1.0\" y=\"2.0\" heading=\"12.0\""), body);
  }

  @Test
  void everyOpenPageGetsSteps() throws Exception {
    try (Page first = new Page();
        Page second = new Page()) {
      send(post("{\"command\":\"speed\",\"perSecond\":500}"));
      send(post("{\"command\":\"run\"}"));
      assertTrue(first.stepsUntil(100) >= 100);
      assertTrue(second.stepsUntil(100) >= 100);
    }
  }

  @Test
  void limitsNumberOfOpenPages() throws Exception {
    Page[] pages = new Page[8];
    for (int i = 0; i < pages.length; i++) {
      pages[i] = new Page();
      pages[i].next("setup");
    }
    assertEquals(503, get(address.resolve("events")).statusCode());
    for (Page page : pages) {
      page.close();
    }
  }

  @Test
  void serverEndsAfterLastPageIsClosed() throws Exception {
    assertFalse(ended.await(2 * GRACE.toMillis(), TimeUnit.MILLISECONDS), "before any page");
    new Page().close();
    assertTrue(ended.await(10, TimeUnit.SECONDS));
  }

  @Test
  void serverContinuesWhenPageIsReloaded() throws Exception {
    Page first = new Page();
    first.next("setup");
    first.close();
    try (Page second = new Page()) {
      second.next("setup");
      assertFalse(ended.await(4 * GRACE.toMillis(), TimeUnit.MILLISECONDS));
    }
    assertTrue(ended.await(10, TimeUnit.SECONDS));
  }

  @Test
  void reportsPortInUse() {
    InputException error =
        assertThrows(
            InputException.class, () -> new ViewServer(session, "", address.getPort(), GRACE));
    assertTrue(error.getMessage().startsWith("port is " + address.getPort()), error.getMessage());
    assertNotEquals(0, address.getPort());
  }

  /** Reads the event stream like a page, by HTTP 1.0, which has no chunks. */
  private final class Page implements AutoCloseable {
    private final Socket socket;
    private final BufferedReader lines;
    private String name = "";

    Page() throws IOException {
      socket = new Socket(InetAddress.getLoopbackAddress(), address.getPort());
      socket.setSoTimeout(10_000);
      String request =
          "GET %sevents HTTP/1.0\r\nHost: 127.0.0.1:%s\r\n\r\n"
              .formatted(address.getPath(), address.getPort());
      socket.getOutputStream().write(request.getBytes(StandardCharsets.UTF_8));
      InputStream in = socket.getInputStream();
      lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8));
    }

    /** Returns the data of the next event of this name. */
    JsonNode next(String wantedName) throws IOException {
      while (true) {
        String line = lines.readLine();
        if (line.startsWith("event: ")) {
          name = line.substring("event: ".length());
        } else if (line.startsWith("data: ") && name.equals(wantedName)) {
          return new ObjectMapper().readTree(line.substring("data: ".length()));
        }
      }
    }

    /** Reads until this step has been sent, and returns the last step. */
    long stepsUntil(long step) throws IOException {
      long last = -1;
      while (last < step) {
        JsonNode steps = next("steps");
        last = steps.get(steps.size() - 1).at("/sides/0/frame/step").asLong();
      }
      return last;
    }

    @Override
    public void close() throws IOException {
      socket.close();
    }
  }

  private String origin() {
    return "http://127.0.0.1:" + address.getPort();
  }

  private HttpRequest.Builder post(String body) {
    return HttpRequest.newBuilder(address.resolve("command"))
        .header("Content-Type", "application/json")
        .header("Origin", origin())
        .POST(HttpRequest.BodyPublishers.ofString(body));
  }

  private HttpResponse<String> get(URI uri) throws Exception {
    return send(HttpRequest.newBuilder(uri));
  }

  private HttpResponse<String> send(HttpRequest.Builder request) throws Exception {
    return client.send(request.build(), HttpResponse.BodyHandlers.ofString());
  }

  /** Sends a text as it is, and returns the status line of the answer. */
  private String raw(String request) throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), address.getPort())) {
      socket.setSoTimeout(5000);
      socket.getOutputStream().write(request.getBytes(StandardCharsets.UTF_8));
      InputStream in = socket.getInputStream();
      return new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8)).readLine();
    }
  }
}
