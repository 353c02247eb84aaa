package org.hificamsim.spark;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A file with a given name in a temporary folder; both are deleted when this object is closed.
 *
 * @param path the path of the file, which does not exist until it is written
 */
record TemporaryFile(Path path) implements Closeable {
  TemporaryFile(String name) throws IOException {
    this(Files.createTempDirectory("hificamsim").resolve(name));
  }

  @Override
  public void close() throws IOException {
    Files.deleteIfExists(path);
    Files.delete(path.getParent());
  }
}
