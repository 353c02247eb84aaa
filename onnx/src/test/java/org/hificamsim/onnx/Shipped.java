package org.hificamsim.onnx;

import java.net.URISyntaxException;
import java.nio.file.Path;

/** Finds the test networks, which make_linear.py has written. */
final class Shipped {
  private Shipped() {}

  static Path file(String name) {
    try {
      return Path.of(Shipped.class.getResource(name).toURI());
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }
}
