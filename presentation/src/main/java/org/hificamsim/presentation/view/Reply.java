package org.hificamsim.presentation.view;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;

/** Sends answers, all with the headers that keep them on this page. */
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

  /** One line of text. */
  static void line(HttpExchange exchange, int status, String text) throws IOException {
    send(exchange, status, "text/plain", (text + "\n").getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Bytes of this type; the head alone where that is asked for.
   *
   * @param type of a text in UTF-8
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

  /** The head of an answer whose body follows; a length of 0 for one that is not known. */
  static void begin(HttpExchange exchange, int status, String type, long length)
      throws IOException {
    HEADERS.forEach(exchange.getResponseHeaders()::set);
    exchange.getResponseHeaders().set("Content-Type", type + "; charset=utf-8");
    exchange.sendResponseHeaders(status, length);
  }

  /** One line of text, if the answer is not under way already and somebody waits for it. */
  static void lineIfPossible(HttpExchange exchange, int status, String text) {
    try {
      line(exchange, status, text);
    } catch (IOException e) {
      // the reader has gone
    }
  }
}
