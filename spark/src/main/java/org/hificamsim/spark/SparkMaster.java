package org.hificamsim.spark;

import static org.hificamsim.core.NamedSetting.setting;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.UnknownHostException;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;

/**
 * The master of a cluster.
 *
 * @param url the URL in Spark's form
 */
record SparkMaster(String url) {
  private static final int TIMEOUT_MILLIS = 3000;
  private static final String STANDALONE = "spark://";
  private static final String HOST = "(?:[\\w.-]+|\\[[0-9a-fA-F:]+\\]):\\d{1,5}";
  private static final Pattern KNOWN =
      Pattern.compile(
          "local|local\\[(?:\\*|[1-9]\\d{0,3})(?:, ?[1-9]\\d{0,3})?\\]"
              + ("|" + STANDALONE + HOST + "(?:," + HOST + ")*")
              + "|yarn|k8s://.+");

  /** The system property that {@code spark-submit} sets. */
  private static final String SUBMITTED = "spark.master";

  /**
   * Returns the master that the user asks for, or else that of {@code spark-submit}.
   *
   * @throws InputException when there is no master, or its URL is malformed
   */
  static SparkMaster of(Optional<String> requested) {
    String url =
        requested
            .or(() -> Optional.ofNullable(System.getProperty(SUBMITTED)))
            .orElseThrow(
                () ->
                    InputException.of("%s is missing, expected %s", setting("master"), expected()));
    if (!KNOWN.matcher(url).matches() || !addresses(url).stream().allMatch(SparkMaster::hasPort)) {
      throw InputException.of("%s is '%s', expected %s", setting("master"), url, expected());
    }
    return new SparkMaster(url);
  }

  /** Whether driver and executors are one process. */
  boolean isLocal() {
    return url.startsWith("local");
  }

  /**
   * Checks that a standalone master accepts connections; Spark itself would try for a minute.
   *
   * @throws InputException when no address accepts a connection
   */
  void requireAnswer() {
    List<String> addresses = addresses(url);
    if (addresses.isEmpty()) {
      return;
    }
    IOException last = null;
    for (String address : addresses) {
      try (Socket socket = new Socket()) {
        socket.connect(new InetSocketAddress(host(address), port(address)), TIMEOUT_MILLIS);
        return;
      } catch (IOException e) {
        last = e;
      }
    }
    throw InputException.of(
            "%s '%s' does not answer (%s), expected the URL of a Spark master that" + " is running",
            setting("master"), url, reason(last))
        .because(last);
  }

  private static String reason(IOException fault) {
    return fault instanceof UnknownHostException
        ? "unknown host " + fault.getMessage()
        : fault.getMessage();
  }

  private static String expected() {
    return "spark://HOST:PORT, local[*], local[N], yarn or k8s://...";
  }

  private static List<String> addresses(String url) {
    return url.startsWith(STANDALONE)
        ? Arrays.asList(url.substring(STANDALONE.length()).split(","))
        : List.of();
  }

  private static boolean hasPort(String address) {
    return port(address) >= 1 && port(address) <= 65_535;
  }

  private static String host(String address) {
    return address.substring(0, address.lastIndexOf(':'));
  }

  private static int port(String address) {
    return Integer.parseInt(address.substring(address.lastIndexOf(':') + 1));
  }
}
