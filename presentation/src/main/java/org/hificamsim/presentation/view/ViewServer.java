package org.hificamsim.presentation.view;

import static org.hificamsim.core.NamedSetting.setting;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.OutputStream;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Future;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.runs.RunFault;

/**
 * Serves the page of a session, its steps as server-sent events, and its commands, on the loopback
 * device only. It ends some seconds after the last page was closed.
 */
public final class ViewServer implements AutoCloseable {
  private static final String EVENT_STREAM = "text/event-stream";
  private static final int MAX_BODY_BYTES = 4096;
  private static final int MAX_PAGES = 8;

  /** The greatest number of connections; further ones are closed at once. */
  private static final int MAX_CONNECTIONS = 128;

  /** The greatest number of threads, so many that requests which never end do not block others. */
  private static final int MAX_THREADS = 2 * MAX_CONNECTIONS;

  private static final long IDLE_THREAD_SECONDS = 10;
  private static final int WAITING_CONNECTIONS = 32;
  private static final long MAX_COMMAND_SECONDS = 60;

  /** The time for unfinished answers when the server closes. */
  private static final long CLOSING_MILLIS = 500;

  /** The time between two events, each of which has the steps since the last one. */
  private static final long EVENT_MILLIS = 25;

  static {
    System.setProperty("sun.net.httpserver.maxReqTime", "2"); // seconds, for a whole request
    System.setProperty("sun.net.httpserver.timerMillis", "200"); // how often that is checked
    System.setProperty("jdk.httpserver.maxConnections", Integer.toString(MAX_CONNECTIONS));
    System.setProperty("sun.net.httpserver.nodelay", "true");
  }

  private final LiveSession session;
  private final byte[] page;
  private final HttpServer server;
  private final ExecutorService threads =
      new ThreadPoolExecutor(
          0,
          MAX_THREADS,
          IDLE_THREAD_SECONDS,
          TimeUnit.SECONDS,
          new SynchronousQueue<>(), // no further request waits
          Parallel.daemons("view"));
  private final Guard guard;
  private final Executor afterGrace;
  private final CompletableFuture<Object> closed = new CompletableFuture<>();
  private int openPages;
  private int pagesEverOpened;

  /**
   * Opens the port.
   *
   * @param html the page
   * @param port 0 for any free port
   * @param grace the time from closing the last page to the end of the server
   * @throws InputException if the port is in use
   */
  public ViewServer(LiveSession session, String html, int port, Duration grace) throws IOException {
    this.session = session;
    this.page = html.getBytes(StandardCharsets.UTF_8);
    this.server = open(port);
    this.guard = new Guard(server.getAddress().getPort());
    this.afterGrace = CompletableFuture.delayedExecutor(grace.toMillis(), TimeUnit.MILLISECONDS);
    server.setExecutor(threads);
    server.createContext("/", this::handle);
    server.start();
  }

  private static HttpServer open(int port) throws IOException {
    InetAddress loopback = InetAddress.getByAddress("localhost", new byte[] {127, 0, 0, 1});
    try {
      return HttpServer.create(new InetSocketAddress(loopback, port), WAITING_CONNECTIONS);
    } catch (BindException e) {
      throw InputException.of(
              "%s is %s, which cannot be used (%s), expected one that is free; maybe 0",
              setting("port"), port, e.getMessage())
          .because(e);
    }
  }

  /** The address of the page. */
  public String address() {
    return "http://127.0.0.1:" + server.getAddress().getPort() + "/" + guard.token() + "/";
  }

  /**
   * Waits until the page has been closed.
   *
   * @throws Error if the simulation was ended by this error
   */
  public void awaitEnd() throws InterruptedException {
    try {
      CompletableFuture.anyOf(closed, session.end()).get();
    } catch (ExecutionException e) {
      if (e.getCause().getCause() instanceof Error error) {
        throw error;
      }
    }
  }

  /** Answers a request, and closes the exchange after any answer to an exception has been sent. */
  private void handle(HttpExchange exchange) {
    try (exchange) {
      answerOrReport(exchange);
    } catch (IOException e) {
      // the page was closed
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void answerOrReport(HttpExchange exchange) throws IOException, InterruptedException {
    try {
      String objection = guard.objection(exchange);
      if (objection != null) {
        Reply.line(exchange, 403, "refused: " + objection);
      } else {
        answer(exchange);
      }
    } catch (InputException e) {
      Reply.lineIfPossible(exchange, 400, Place.printable(e.getMessage()));
    } catch (LiveSession.SessionEnded e) {
      Reply.lineIfPossible(exchange, 503, Place.printable(e.getMessage()));
    } catch (RuntimeException | Error e) {
      Reply.lineIfPossible(exchange, 500, Place.printable(RunFault.describe(e)));
    }
  }

  private void answer(HttpExchange exchange) throws IOException, InterruptedException {
    String path = exchange.getRequestURI().getRawPath().substring(guard.token().length() + 1);
    String request = exchange.getRequestMethod() + " " + path;
    switch (request) {
      case "GET /", "HEAD /" -> Reply.send(exchange, 200, "text/html", page);
      case "HEAD /events" -> Reply.send(exchange, 200, EVENT_STREAM, new byte[0]);
      case "GET /events" -> sendEvents(exchange);
      case "GET /scenario.xml", "HEAD /scenario.xml" -> sendScenario(exchange);
      case "POST /command" -> submitCommand(exchange);
      default -> Reply.line(exchange, 404, "nothing here");
    }
  }

  private void submitCommand(HttpExchange exchange) throws IOException, InterruptedException {
    byte[] body = exchange.getRequestBody().readNBytes(MAX_BODY_BYTES + 1);
    String type = exchange.getRequestHeaders().getFirst("Content-Type");
    if (body.length > MAX_BODY_BYTES) {
      Reply.line(exchange, 413, "more than " + MAX_BODY_BYTES + " bytes");
    } else if (!"application/json".equals(type)) {
      Reply.line(exchange, 415, "expected application/json");
    } else {
      await(session.submit(Command.read(body)));
      exchange.sendResponseHeaders(204, -1);
    }
  }

  private void sendScenario(HttpExchange exchange) throws IOException, InterruptedException {
    String xml = (String) await(session.scenario());
    exchange.getResponseHeaders().set("Content-Disposition", "attachment");
    Reply.send(exchange, 200, "application/xml", xml.getBytes(StandardCharsets.UTF_8));
  }

  private static Object await(Future<Object> answer) throws InterruptedException {
    try {
      return answer.get(MAX_COMMAND_SECONDS, TimeUnit.SECONDS);
    } catch (TimeoutException e) {
      throw new InputException("the last step takes longer than a minute", e);
    } catch (ExecutionException e) {
      if (e.getCause() instanceof Error error) {
        throw error;
      }
      throw (RuntimeException) e.getCause();
    }
  }

  private void sendEvents(HttpExchange exchange) throws IOException, InterruptedException {
    if (!openPage()) {
      Reply.line(exchange, 503, "too many pages are open");
      return;
    }
    try {
      LiveFeed.Reader reader = session.feed().new Reader();
      Reply.begin(exchange, 200, EVENT_STREAM, 0);
      OutputStream out = exchange.getResponseBody();
      while (!closed.isDone()) {
        out.write(reader.take().getBytes(StandardCharsets.UTF_8));
        out.flush();
        TimeUnit.MILLISECONDS.sleep(EVENT_MILLIS);
      }
    } finally {
      closePage();
    }
  }

  private synchronized boolean openPage() {
    if (openPages == MAX_PAGES) {
      return false;
    }
    openPages++;
    pagesEverOpened++;
    return true;
  }

  /** Ends the server after a grace period, unless another page has been opened by then. */
  private synchronized void closePage() {
    openPages--;
    int known = pagesEverOpened;
    afterGrace.execute(() -> endUnlessOpenedSince(known));
  }

  private synchronized void endUnlessOpenedSince(int known) {
    if (openPages == 0 && pagesEverOpened == known) {
      closed.complete(null);
    }
  }

  /** Ends the streams, waits for unfinished answers, and closes the port. */
  @Override
  public void close() {
    closed.complete(null);
    threads.shutdown();
    try {
      threads.awaitTermination(CLOSING_MILLIS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    server.stop(0);
    threads.shutdownNow();
  }
}
