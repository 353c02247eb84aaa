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
 * The page of a session, its steps as server-sent events, and its commands, on the loopback device
 * alone. It ends when no page has been open for some seconds after one was.
 */
public final class ViewServer implements AutoCloseable {
  private static final String STREAM = "text/event-stream";
  private static final int MAX_BODY = 4096;
  private static final int MAX_PAGES = 8;

  /** One more is closed at once. */
  private static final int MAX_CONNECTIONS = 128;

  /** A thread for each connection: one whose request never ends must not keep others out. */
  private static final int MAX_REQUESTS = 2 * MAX_CONNECTIONS;

  private static final long IDLE_THREAD = 10;
  private static final int WAITING_CONNECTIONS = 32;
  private static final long MAX_COMMAND = 60;

  /** Milliseconds that answers have to get through when the server closes. */
  private static final long LAST_ANSWERS = 500;

  /** The least time between two events, ms; each has the steps since the one before. */
  private static final long BETWEEN_EVENTS = 25;

  static {
    System.setProperty("sun.net.httpserver.maxReqTime", "2"); // seconds, for a whole request
    System.setProperty("sun.net.httpserver.timerMillis", "200"); // between two looks for such
    System.setProperty("jdk.httpserver.maxConnections", Integer.toString(MAX_CONNECTIONS));
    System.setProperty("sun.net.httpserver.nodelay", "true");
  }

  private final LiveSession session;
  private final byte[] page;
  private final HttpServer server;
  private final ExecutorService threads =
      new ThreadPoolExecutor(
          0,
          MAX_REQUESTS,
          IDLE_THREAD,
          TimeUnit.SECONDS,
          new SynchronousQueue<>(), // one request more is not answered
          Parallel.daemons("view"));
  private final Guard guard;
  private final Executor afterGrace;
  private final CompletableFuture<Object> closed = new CompletableFuture<>();
  private int pages; // that are open
  private int visits; // pages that have ever been

  /**
   * Opens the port.
   *
   * @param html the page
   * @param port 0 for any that is free
   * @param grace how long after the last page was closed the server ends
   * @throws InputException when the port is in use
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

  /** Where the page is. */
  public String address() {
    return "http://127.0.0.1:" + server.getAddress().getPort() + "/" + guard.token() + "/";
  }

  /**
   * Waits until the page has been closed.
   *
   * @throws Error what broke the simulation, if that ended it
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

  /** Whatever happens, the exchange is closed last: nothing can be sent after that. */
  private void handle(HttpExchange exchange) {
    try (exchange) {
      answerOrTell(exchange);
    } catch (IOException e) {
      // the reader has gone
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void answerOrTell(HttpExchange exchange) throws IOException, InterruptedException {
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
      case "HEAD /events" -> Reply.send(exchange, 200, STREAM, new byte[0]);
      case "GET /events" -> events(exchange);
      case "GET /scenario.xml", "HEAD /scenario.xml" -> scenario(exchange);
      case "POST /command" -> command(exchange);
      default -> Reply.line(exchange, 404, "nothing here");
    }
  }

  private void command(HttpExchange exchange) throws IOException, InterruptedException {
    byte[] body = exchange.getRequestBody().readNBytes(MAX_BODY + 1);
    String type = exchange.getRequestHeaders().getFirst("Content-Type");
    if (body.length > MAX_BODY) {
      Reply.line(exchange, 413, "more than " + MAX_BODY + " bytes");
    } else if (!"application/json".equals(type)) {
      Reply.line(exchange, 415, "expected application/json");
    } else {
      await(session.submit(Command.read(body)));
      exchange.sendResponseHeaders(204, -1);
    }
  }

  private void scenario(HttpExchange exchange) throws IOException, InterruptedException {
    String xml = (String) await(session.scenario());
    exchange.getResponseHeaders().set("Content-Disposition", "attachment");
    Reply.send(exchange, 200, "application/xml", xml.getBytes(StandardCharsets.UTF_8));
  }

  private static Object await(Future<Object> answer) throws InterruptedException {
    try {
      return answer.get(MAX_COMMAND, TimeUnit.SECONDS);
    } catch (TimeoutException e) {
      throw new InputException("the step before takes longer than a minute", e);
    } catch (ExecutionException e) {
      if (e.getCause() instanceof Error error) {
        throw error;
      }
      throw (RuntimeException) e.getCause();
    }
  }

  private void events(HttpExchange exchange) throws IOException, InterruptedException {
    if (!opened()) {
      Reply.line(exchange, 503, "too many pages are open");
      return;
    }
    try {
      LiveFeed.Reader reader = session.feed().new Reader();
      Reply.begin(exchange, 200, STREAM, 0);
      OutputStream out = exchange.getResponseBody();
      while (!closed.isDone()) {
        out.write(reader.take().getBytes(StandardCharsets.UTF_8));
        out.flush();
        TimeUnit.MILLISECONDS.sleep(BETWEEN_EVENTS);
      }
    } finally {
      gone();
    }
  }

  private synchronized boolean opened() {
    if (pages == MAX_PAGES) {
      return false;
    }
    pages++;
    visits++;
    return true;
  }

  /** Ends the server unless a page is open after the grace, or was in between. */
  private synchronized void gone() {
    pages--;
    int known = visits;
    afterGrace.execute(() -> endUnlessVisited(known));
  }

  private synchronized void endUnlessVisited(int known) {
    if (pages == 0 && visits == known) {
      closed.complete(null);
    }
  }

  /** Ends the streams, lets answers that are under way get through, and closes the port. */
  @Override
  public void close() {
    closed.complete(null);
    threads.shutdown();
    try {
      threads.awaitTermination(LAST_ANSWERS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    server.stop(0);
    threads.shutdownNow();
  }
}
