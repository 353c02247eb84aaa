package org.hificamsim.presentation.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Tests the server when clients block it, and when the simulation fails. */
@Timeout(60)
class BrokenViewTest {
  /** A time far below the one that an incomplete request may take. */
  private static final Duration SOON = Duration.ofSeconds(4);

  private static final int INCOMPLETE_REQUESTS = 100;

  private final HttpClient client = HttpClient.newHttpClient();
  private final List<Socket> sockets = new ArrayList<>();
  private LiveSession session;
  private ViewServer server;
  private URI address;

  @BeforeEach
  void start() throws IOException {
    Catalogue catalogue = Catalogue.load();
    catalogue.policies().register("exhausting", "no memory after step 3", Exhausting::new);
    catalogue.policies().register("unready", "cannot be created", () -> missing());
    LiveChoice choice = new LiveChoice("geometric", null, "exhausting");
    session =
        new LiveSession(
            new LiveRun(
                catalogue,
                new LiveRun.ShownScenario(Scenarios.read("cluster-random"), List.of()),
                choice,
                0,
                Optional.empty()));
    server = new ViewServer(session, "<p>the page</p>", 0, Duration.ofSeconds(1));
    address = URI.create(server.address());
  }

  private static ZoomPolicy missing() {
    throw new IllegalStateException("a part is missing");
  }

  @AfterEach
  void stop() throws IOException {
    for (Socket socket : sockets) {
      socket.close();
    }
    server.close();
    session.close();
  }

  @Test
  void incompleteRequestsAreClosedAndBlockNoOthers() throws Exception {
    for (int i = 0; i < INCOMPLETE_REQUESTS; i++) {
      sockets.add(incompleteRequest());
    }
    assertEquals(200, send(HttpRequest.newBuilder(address)).statusCode());
    assertEquals(204, command("pause").statusCode());
    sockets.get(0).setSoTimeout(15_000);
    InputStream answer = sockets.get(0).getInputStream();
    assertEquals(-1, answer.read());
  }

  private Socket incompleteRequest() throws IOException {
    Socket socket = new Socket(InetAddress.getLoopbackAddress(), address.getPort());
    socket.getOutputStream().write("GET /none HTTP/1.1\r\nHo".getBytes(StandardCharsets.UTF_8));
    return socket;
  }

  @Test
  void reportsFailedCommandAndContinuesSession() throws Exception {
    HttpResponse<String> answer =
        command(
            "choose\",\"side\":0,\"detection\":\"geometric\",\"threshold\":null,\"policy\":\"unready");
    assertEquals(500, answer.statusCode());
    assertTrue(answer.body().contains("a part is missing"), answer.body());
    assertEquals(1, answer.body().lines().count(), answer.body());
    assertEquals(204, command("pause").statusCode());
  }

  @Test
  void errorInStepEndsSession() throws Exception {
    HttpResponse<String> answer = steps(10);
    assertEquals(503, answer.statusCode());
    assertEquals("the session has ended: OutOfMemoryError: in a test\n", answer.body());
    assertEquals(503, steps(1).statusCode());
    OutOfMemoryError error = assertThrows(OutOfMemoryError.class, () -> server.awaitEnd());
    assertEquals("in a test", error.getMessage());
  }

  @Test
  void errorBetweenCommandsEndsSession() throws Exception {
    assertEquals(204, command("run").statusCode());
    assertThrows(OutOfMemoryError.class, () -> server.awaitEnd());
    assertEquals(503, command("pause").statusCode());
  }

  @Test
  void rejectsCommandsAfterSessionIsClosed() {
    session.close();
    assertThrows(
        ExecutionException.class,
        () -> session.submit(new Command.Pause()).get(SOON.toSeconds(), TimeUnit.SECONDS));
  }

  private HttpResponse<String> steps(int steps) throws Exception {
    return post("{\"command\":\"step\",\"steps\":" + steps + "}");
  }

  private HttpResponse<String> command(String name) throws Exception {
    return post("{\"command\":\"" + name + "\"}");
  }

  private HttpResponse<String> post(String body) throws Exception {
    return send(
        HttpRequest.newBuilder(address.resolve("command"))
            .header("Content-Type", "application/json")
            .header("Origin", "http://127.0.0.1:" + address.getPort())
            .POST(HttpRequest.BodyPublishers.ofString(body)));
  }

  private HttpResponse<String> send(HttpRequest.Builder request) throws Exception {
    return client.send(request.timeout(SOON).build(), HttpResponse.BodyHandlers.ofString());
  }

  /** A policy that runs out of memory. */
  private static final class Exhausting implements ZoomPolicy {
    @Override
    public String name() {
      return "exhausting";
    }

    @Override
    public void decide(NetworkView network, int[] levels) {
      if (network.step() > 3) {
        throw new OutOfMemoryError("in a test");
      }
    }
  }
}
