package org.hificamsim.profiling.check;

/**
 * How large a picture is.
 *
 * @param width pixels
 * @param height pixels
 */
public record ImageSize(int width, int height) {
  @Override
  public String toString() {
    return width + "x" + height;
  }
}
