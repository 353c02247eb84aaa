package org.hificamsim.presentation.view;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.OutputStream;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;

/**
 * The page of a session, its steps as server-sent events, and its commands, on the loopback device
 * alone. It ends when no page has been open for some seconds after one was.
 */
public final class ViewServer implements AutoCloseable {
  private static final int MAX_BODY = 4096;
  private static final int MAX_PAGES = 8;
  private static final int THREADS = 2 * MAX_PAGES + 4;
  private static final int WAITING_CONNECTIONS = 32;
  private static final long MAX_COMMAND = 60;

  /** At most so many events a second, each with the steps since the one before. */
  private static final long BETWEEN_EVENTS = 25;

  private static final Map<String, String> HEADERS =
      Map.of(
          "Cache-Control", "no-store",
          "Referrer-Policy", "no-referrer",
          "X-Content-Type-Options", "nosniff",
          "Cross-Origin-Resource-Policy", "same-origin",
          "Cross-Origin-Opener-Policy", "same-origin",
          "Content-Security-Policy", "frame-ancestors 'none'");

  static {
    System.setProperty("sun.net.httpserver.maxReqTime", "20"); // seconds, for a whole request
    System.setProperty("sun.net.httpserver.nodelay", "true");
  }

  private final Session session;
  private final byte[] page;
  private final HttpServer server;
  private final ExecutorService threads = Executors.newFixedThreadPool(THREADS, ViewServer::daemon);
  private final Guard guard;
  private final OpenPages pages;
  private final CountDownLatch ended = new CountDownLatch(1);

  /**
   * Opens the port.
   *
   * @param html the page
   * @param port 0 for any that is free
   * @param grace how long after the last page was closed the server ends
   * @throws InputException when the port is in use
   */
  public ViewServer(Session session, String html, int port, Duration grace) throws IOException {
    this.session = session;
    this.page = html.getBytes(StandardCharsets.UTF_8);
    this.server = open(port);
    this.guard = new Guard(server.getAddress().getPort());
    this.pages = new OpenPages(MAX_PAGES, grace, ended::countDown);
    server.setExecutor(threads);
    server.createContext("/", this::handle);
    server.start();
  }

  private static HttpServer open(int port) throws IOException {
    InetAddress loopback = InetAddress.getByAddress("localhost", new byte[] {127, 0, 0, 1});
    try {
      return HttpServer.create(new InetSocketAddress(loopback, port), WAITING_CONNECTIONS);
    } catch (BindException e) {
      throw new InputException(
          "--port is %s, which cannot be used (%s), expected one that is free; maybe 0"
              .formatted(port, e.getMessage()),
          e);
    }
  }

  /** Where the page is. */
  public String address() {
    return "http://127.0.0.1:" + server.getAddress().getPort() + "/" + guard.token() + "/";
  }

  /** Waits until the page has been closed. */
  public void awaitEnd() throws InterruptedException {
    ended.await();
  }

  private void handle(HttpExchange exchange) {
    try (exchange) {
      String objection = guard.objection(exchange);
      if (objection != null) {
        answer(exchange, 403, "text/plain", "refused: " + objection);
      } else {
        answer(exchange);
      }
    } catch (IOException e) {
      // whoever asked has gone
    } catch (InterruptedException | RejectedExecutionException e) {
      Thread.currentThread().interrupt();
    } catch (RuntimeException e) {
      quietly(exchange, 500, "internal error");
    }
  }

  private void answer(HttpExchange exchange) throws IOException, InterruptedException {
    String path = exchange.getRequestURI().getRawPath().substring(guard.token().length() + 1);
    String request = exchange.getRequestMethod() + " " + path;
    switch (request) {
      case "GET /" -> {
        exchange.getResponseHeaders().set("Content-Type", "text/html; charset=utf-8");
        send(exchange, 200, page);
      }
      case "GET /events" -> events(exchange);
      case "POST /command" -> command(exchange);
      default -> answer(exchange, 404, "text/plain", "nothing here");
    }
  }

  private void command(HttpExchange exchange) throws IOException, InterruptedException {
    byte[] body = exchange.getRequestBody().readNBytes(MAX_BODY + 1);
    String type = exchange.getRequestHeaders().getFirst("Content-Type");
    if (body.length > MAX_BODY) {
      answer(exchange, 413, "text/plain", "more than " + MAX_BODY + " bytes");
    } else if (!"application/json".equals(type)) {
      answer(exchange, 415, "text/plain", "expected application/json");
    } else {
      try {
        obey(Command.read(body));
        exchange.sendResponseHeaders(204, -1);
      } catch (InputException e) {
        answer(exchange, 400, "text/plain", Place.printable(e.getMessage()));
      }
    }
  }

  private void obey(Command command) throws InterruptedException {
    try {
      session.submit(command).get(MAX_COMMAND, TimeUnit.SECONDS);
    } catch (ExecutionException | CompletionException e) {
      if (e.getCause() instanceof InputException wrong) {
        throw wrong;
      }
      throw new IllegalStateException(e);
    } catch (TimeoutException e) {
      throw new InputException("the step before takes longer than a minute", e);
    }
  }

  private void events(HttpExchange exchange) throws IOException, InterruptedException {
    EventStream stream = new EventStream(session.kept());
    if (!pages.opened(stream)) {
      answer(exchange, 503, "text/plain", "too many pages are open");
      return;
    }
    try {
      session.watch(stream);
      exchange.getResponseHeaders().set("Content-Type", "text/event-stream");
      harden(exchange.getResponseHeaders());
      exchange.sendResponseHeaders(200, 0);
      OutputStream out = exchange.getResponseBody();
      for (String text = stream.take(); text != null; text = stream.take()) {
        out.write(text.getBytes(StandardCharsets.UTF_8));
        out.flush();
        TimeUnit.MILLISECONDS.sleep(BETWEEN_EVENTS);
      }
    } finally {
      session.unwatch(stream);
      pages.closed(stream);
    }
  }

  private static void answer(HttpExchange exchange, int status, String type, String text)
      throws IOException {
    exchange.getResponseHeaders().set("Content-Type", type + "; charset=utf-8");
    send(exchange, status, (text + "\n").getBytes(StandardCharsets.UTF_8));
  }

  private static void send(HttpExchange exchange, int status, byte[] body) throws IOException {
    harden(exchange.getResponseHeaders());
    exchange.sendResponseHeaders(status, body.length);
    exchange.getResponseBody().write(body);
  }

  private static void quietly(HttpExchange exchange, int status, String text) {
    try {
      answer(exchange, status, "text/plain", text);
    } catch (IOException e) {
      // the answer was under way already, or nobody waits for it
    }
  }

  private static void harden(Headers headers) {
    HEADERS.forEach(headers::set);
  }

  private static Thread daemon(Runnable task) {
    Thread thread = new Thread(task, "view");
    thread.setDaemon(true);
    return thread;
  }

  /** Ends the streams and closes the port. */
  @Override
  public void close() {
    pages.close();
    server.stop(0);
    threads.shutdownNow();
    ended.countDown();
  }
}
