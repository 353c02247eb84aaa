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
 * Accepts requests only from pages that this server has sent, on this machine. The token keeps out
 * other users and programs of the machine; checking the host prevents DNS rebinding; checking the
 * origin keeps out other sites in the same browser.
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
   * Returns what is wrong with a request; null if nothing is. A navigation may come from another
   * origin, since the file that opens the page has another one. This is safe, because only the user
   * sees the answer to a navigation.
   */
  String objection(HttpExchange exchange) {
    Headers headers = exchange.getRequestHeaders();
    if (!hosts.contains(single(headers.get("Host")))) {
      return "another host";
    }
    String origin = single(headers.get("Origin"));
    boolean isPost = exchange.getRequestMethod().equals("POST");
    boolean sameOrigin = origin.equals("http://" + single(headers.get("Host")));
    if (isPost ? !sameOrigin : !(sameOrigin || origin.isEmpty())) {
      return "another origin";
    }
    String site = single(headers.get("Sec-Fetch-Site"));
    boolean isNavigation = !isPost && single(headers.get("Sec-Fetch-Mode")).equals("navigate");
    if (!isNavigation && !Set.of("", "same-origin", "none").contains(site)) {
      return "another site";
    }
    return hasToken(exchange.getRequestURI().getRawPath()) ? null : "no token";
  }

  private boolean hasToken(String path) {
    String[] parts = path.split("/", 3);
    byte[] given = (parts.length == 3 ? parts[1] : "").getBytes(StandardCharsets.UTF_8);
    return MessageDigest.isEqual(given, token.getBytes(StandardCharsets.UTF_8));
  }

  /** Returns the only value of a header; empty if it has none or several. */
  private static String single(List<String> values) {
    return values == null || values.size() != 1 ? "" : values.get(0);
  }
}
