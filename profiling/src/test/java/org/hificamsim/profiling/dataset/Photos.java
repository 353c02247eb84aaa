package org.hificamsim.profiling.dataset;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;

/** Small photos and data sets for tests. */
public final class Photos {
  private Photos() {}

  /** Writes a grey picture of this size. */
  public static void write(Path file, int width, int height) throws IOException {
    Files.createDirectories(file.getParent());
    Files.write(file, bytes(width, height, file.toString().endsWith("png") ? "png" : "jpg"));
  }

  /** Writes a JPEG whose EXIF has a focal length. */
  public static void writeWithFocalLength(Path file, int width, int height, int millimetres)
      throws IOException {
    writeWithFocalLength(file, width, height, millimetres, 1);
  }

  /** Writes a JPEG whose EXIF has a focal length as a fraction. */
  public static void writeWithFocalLength(
      Path file, int width, int height, int millimetres, int over) throws IOException {
    writeWithExif(file, width, height, exif(millimetres, over));
  }

  /** Writes a JPEG whose EXIF rotates it by a quarter turn. */
  public static void writeTurned(Path file, int width, int height) throws IOException {
    ByteBuffer tiff = ByteBuffer.allocate(26);
    tiff.put(new byte[] {'M', 'M', 0, 42}).putInt(8);
    tiff.putShort((short) 1).putShort((short) 0x0112).putShort((short) 3).putInt(1);
    tiff.putShort((short) 6).putShort((short) 0).putInt(0);
    writeWithExif(file, width, height, segment(tiff.array()));
  }

  private static void writeWithExif(Path file, int width, int height, byte[] exif)
      throws IOException {
    byte[] jpeg = bytes(width, height, "jpg");
    ByteBuffer all = ByteBuffer.allocate(jpeg.length + exif.length);
    all.put(jpeg, 0, 2).put(exif).put(jpeg, 2, jpeg.length - 2);
    Files.write(file, all.array());
  }

  private static byte[] bytes(int width, int height, String format) throws IOException {
    BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImageIO.write(image, format, bytes);
    return bytes.toByteArray();
  }

  /**
   * Returns an APP1 segment: a TIFF header, a directory that points to the EXIF directory, and
   * that.
   */
  private static byte[] exif(int millimetres, int over) {
    ByteBuffer tiff = ByteBuffer.allocate(52);
    tiff.put(new byte[] {'M', 'M', 0, 42}).putInt(8);
    tiff.putShort((short) 1).putShort((short) 0x8769).putShort((short) 4).putInt(1).putInt(26);
    tiff.putInt(0);
    tiff.putShort((short) 1).putShort((short) 0x920A).putShort((short) 5).putInt(1).putInt(44);
    tiff.putInt(0);
    tiff.putInt(millimetres).putInt(over);
    return segment(tiff.array());
  }

  private static byte[] segment(byte[] tiff) {
    ByteBuffer segment = ByteBuffer.allocate(4 + 6 + tiff.length);
    segment.put((byte) 0xFF).put((byte) 0xE1).putShort((short) (2 + 6 + tiff.length));
    segment.put(new byte[] {'E', 'x', 'i', 'f', 0, 0}).put(tiff);
    return segment.array();
  }
}
