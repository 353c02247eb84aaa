package org.hificamsim.presentation.view;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.List;
import java.util.Set;

/**
 * Who may ask for what: pages that this server has sent, on this machine, and nobody else. The
 * token keeps out other users and programs of the machine, the host name DNS rebinding, the origin
 * other sites in the same browser.
 */
final class Guard {
  private static final int TOKEN_BYTES = 24;

  private final String token;
  private final Set<String> hosts;

  Guard(int port) {
    byte[] bytes = new byte[TOKEN_BYTES];
    new SecureRandom().nextBytes(bytes);
    this.token = HexFormat.of().formatHex(bytes);
    this.hosts = Set.of("127.0.0.1:" + port, "localhost:" + port);
  }

  /** The secret part of every address. */
  String token() {
    return token;
  }

  /**
   * What is wrong with a request; null when nothing is. A window may be sent here from elsewhere,
   * as by the file that opens it: the page shows itself to nobody else.
   */
  String objection(HttpExchange exchange) {
    Headers headers = exchange.getRequestHeaders();
    if (!hosts.contains(only(headers.get("Host")))) {
      return "another host";
    }
    String origin = only(headers.get("Origin"));
    boolean posts = exchange.getRequestMethod().equals("POST");
    boolean own = origin.equals("http://" + only(headers.get("Host")));
    if (posts ? !own : !(own || origin.isEmpty())) {
      return "another origin";
    }
    String site = only(headers.get("Sec-Fetch-Site"));
    boolean opens = !posts && only(headers.get("Sec-Fetch-Mode")).equals("navigate");
    if (!opens && !Set.of("", "same-origin", "none").contains(site)) {
      return "another site";
    }
    return hasToken(exchange.getRequestURI().getRawPath()) ? null : "no token";
  }

  private boolean hasToken(String path) {
    String[] parts = path.split("/", 3);
    byte[] given = (parts.length == 3 ? parts[1] : "").getBytes(StandardCharsets.UTF_8);
    return MessageDigest.isEqual(given, token.getBytes(StandardCharsets.UTF_8));
  }

  /** The one value of a header; empty when there is none or more than one. */
  private static String only(List<String> values) {
    return values == null || values.size() != 1 ? "" : values.get(0);
  }
}
