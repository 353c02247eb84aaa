package org.hificamsim.profiling.opencv;

/** OpenCV's native library does not load here: reported in one line, with what helps. */
public final class OpenCvMissingException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  OpenCvMissingException(String reasons) {
    super(
        "OpenCV does not load, expected Debian's libopencv-java or org.openpnp:opencv for this"
            + " machine ("
            + reasons
            + "). Maybe install libopencv-java and build again");
  }
}
