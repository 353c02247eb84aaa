package org.hificamsim.profiling.dataset;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Finds the end of a JPEG by walking its marker segments (ITU-T T.81, annex B). A file may go on
 * behind it: phones append a video to a motion photo, or a depth map.
 */
final class JpegEnd {
  private static final int MARKER = 0xFF;
  private static final int END_OF_IMAGE = 0xD9;
  private static final int START_OF_SCAN = 0xDA;
  private static final int FIRST_WITHOUT_LENGTH = 0xD0; // restarts, start of image
  private static final int LAST_WITHOUT_LENGTH = 0xD8;
  private static final int LAST_RESTART = 0xD7;
  private static final int TEMPORARY = 0x01;

  private final DataInputStream in;

  private JpegEnd(DataInputStream in) {
    this.in = in;
  }

  /** Whether a JPEG has its end-of-image marker; false if it is cut short. */
  static boolean isIn(Path file) throws IOException {
    try (DataInputStream in =
        new DataInputStream(new BufferedInputStream(Files.newInputStream(file), 1 << 16))) {
      new JpegEnd(in).skipToEnd();
      return true;
    } catch (EOFException e) {
      return false;
    }
  }

  private void skipToEnd() throws IOException {
    int marker = nextMarker();
    while (marker != END_OF_IMAGE) {
      if (hasLength(marker)) {
        in.skipNBytes(Math.max(0, in.readUnsignedShort() - Short.BYTES));
      }
      marker = marker == START_OF_SCAN ? markerAfterScan() : nextMarker();
    }
  }

  private static boolean hasLength(int marker) {
    return marker != TEMPORARY && (marker < FIRST_WITHOUT_LENGTH || marker > LAST_WITHOUT_LENGTH);
  }

  private int nextMarker() throws IOException {
    while (in.readUnsignedByte() != MARKER) {
      // bytes between segments are skipped, as decoders do
    }
    int marker = in.readUnsignedByte();
    while (marker == MARKER) {
      marker = in.readUnsignedByte(); // fill bytes
    }
    return marker;
  }

  /** Skips entropy-coded data, in which 0 follows the byte 255 and restart markers may stand. */
  private int markerAfterScan() throws IOException {
    int marker = nextMarker();
    while (marker == 0 || (marker >= FIRST_WITHOUT_LENGTH && marker <= LAST_RESTART)) {
      marker = nextMarker();
    }
    return marker;
  }
}
