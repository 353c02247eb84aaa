package org.hificamsim.onnx;

import java.net.URISyntaxException;
import java.nio.file.Path;

/** The networks of the tests, made by make_linear.py. */
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
