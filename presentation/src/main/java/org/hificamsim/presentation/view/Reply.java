package org.hificamsim.presentation.view;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;

/** Sends answers with headers that keep other sites from reading them. */
final class Reply {
  private static final Map<String, String> HEADERS =
      Map.of(
          "Cache-Control", "no-store",
          "Referrer-Policy", "no-referrer",
          "X-Content-Type-Options", "nosniff",
          "Cross-Origin-Resource-Policy", "same-origin",
          "Cross-Origin-Opener-Policy", "same-origin",
          "Content-Security-Policy", "frame-ancestors 'none'");

  private Reply() {}

  /** Sends one line of text. */
  static void line(HttpExchange exchange, int status, String text) throws IOException {
    send(exchange, status, "text/plain", (text + "\n").getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Sends a body, or only its headers if the request is a HEAD.
   *
   * @param type the media type of the body, which is text in UTF-8
   */
  static void send(HttpExchange exchange, int status, String type, byte[] body) throws IOException {
    if (exchange.getRequestMethod().equals("HEAD")) {
      exchange.getResponseHeaders().set("Content-Length", Integer.toString(body.length));
      begin(exchange, status, type, -1);
    } else {
      begin(exchange, status, type, body.length);
      exchange.getResponseBody().write(body);
    }
  }

  /** Sends the headers of an answer; a length of 0 means that it is not known. */
  static void begin(HttpExchange exchange, int status, String type, long length)
      throws IOException {
    HEADERS.forEach(exchange.getResponseHeaders()::set);
    exchange.getResponseHeaders().set("Content-Type", type + "; charset=utf-8");
    exchange.sendResponseHeaders(status, length);
  }

  /** Sends one line of text, unless the answer has been begun or nobody waits for it. */
  static void lineIfPossible(HttpExchange exchange, int status, String text) {
    try {
      line(exchange, status, text);
    } catch (IOException e) {
      // the page was closed
    }
  }
}
