package org.hificamsim.spark;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SparkMasterTest {
  @ParameterizedTest
  @ValueSource(
      strings = {
        "local",
        "local[*]",
        "local[4]",
        "local[2,3]",
        "spark://node-1.example.org:7077",
        "spark://a:1,b:65535",
        "spark://[::1]:7077",
        "yarn",
        "k8s://https://10.0.0.1:443"
      })
  void acceptsUrlsOfSpark(String url) {
    assertEquals(url, SparkMaster.of(Optional.of(url)).url());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "local[0]",
        "local[x]",
        "spark://host",
        "spark://host:0",
        "spark://host:65536",
        "spark://a:1,",
        "http://host:7077",
        "mesos://host:5050"
      })
  void rejectsOtherUrls(String url) {
    InputException fault =
        assertThrows(InputException.class, () -> SparkMaster.of(Optional.of(url)));
    assertTrue(fault.getMessage().startsWith("master is '" + url + "', expected spark://"));
  }

  @Test
  void acceptsOpenPortAndRejectsClosedOne() throws IOException {
    ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    SparkMaster master = master("127.0.0.1:" + server.getLocalPort());
    master.requireAnswer();
    master("127.0.0.1:1,127.0.0.1:" + server.getLocalPort()).requireAnswer();
    server.close();
    InputException fault = assertThrows(InputException.class, master::requireAnswer);
    assertTrue(fault.getMessage().contains("does not answer (Connection refused)"));
  }

  @Test
  void namesUnknownHost() {
    InputException fault =
        assertThrows(
            InputException.class, () -> master("no-such-host.invalid:7077").requireAnswer());
    assertTrue(fault.getMessage().contains("unknown host no-such-host.invalid"));
  }

  private static SparkMaster master(String addresses) {
    return SparkMaster.of(Optional.of("spark://" + addresses));
  }
}
