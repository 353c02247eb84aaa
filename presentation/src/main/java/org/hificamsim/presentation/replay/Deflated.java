package org.hificamsim.presentation.replay;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.Base64;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;

/** Bytes that are deflated (zlib), in Base64. */
public final class Deflated {
  /** Up to five per cent larger than the best, in half the time. */
  static final int FAST = 6;

  private Deflated() {}

  /** Writes the bytes. */
  @FunctionalInterface
  public interface Content {
    void write(OutputStream out) throws IOException;
  }

  /**
   * Deflates what is written.
   *
   * @param level of {@link Deflater}
   */
  public static String base64(int level, Content content) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (OutputStream out = new DeflaterOutputStream(bytes, new Deflater(level), 1 << 16)) {
      content.write(out);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return Base64.getEncoder().encodeToString(bytes.toByteArray());
  }
}
