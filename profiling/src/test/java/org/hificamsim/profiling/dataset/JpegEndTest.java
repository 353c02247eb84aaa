package org.hificamsim.profiling.dataset;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests JPEGs with data behind their end, and JPEGs that are cut short. */
class JpegEndTest {
  private static final byte[] VIDEO =
      "....ftypmp42 a video of a motion photo ".repeat(20).getBytes(StandardCharsets.US_ASCII);

  @TempDir Path folder;

  @Test
  void acceptsVideoBehindPicture() throws IOException {
    for (boolean progressive : new boolean[] {false, true}) {
      Path file = file(joined(jpeg(progressive), VIDEO));
      assertTrue(JpegEnd.isIn(file));
      assertEquals(new ImageHeader(60, 40), ImageHeader.read(file));
    }
  }

  @Test
  void acceptsMarkersOfEndInsideSegments() throws IOException {
    byte[] jpeg = jpeg(false);
    byte[] comment = {(byte) 0xFF, (byte) 0xFE, 0, 6, (byte) 0xFF, (byte) 0xD9, 1, 2};
    byte[] start = Arrays.copyOf(jpeg, 2);
    byte[] rest = Arrays.copyOfRange(jpeg, 2, jpeg.length);
    assertTrue(JpegEnd.isIn(file(joined(joined(start, comment), joined(rest, VIDEO)))));
    byte[] cut = Arrays.copyOf(rest, rest.length / 2);
    assertFalse(JpegEnd.isIn(file(joined(joined(start, comment), cut))));
  }

  @Test
  void rejectsPictureThatIsCut() throws IOException {
    for (boolean progressive : new boolean[] {false, true}) {
      byte[] jpeg = jpeg(progressive);
      for (int share = 1; share < 20; share++) {
        Path file = file(Arrays.copyOf(jpeg, Math.max(20, jpeg.length * share / 20)));
        assertFalse(JpegEnd.isIn(file), share + "/20");
      }
      Path file = file(Arrays.copyOf(jpeg, jpeg.length - 2));
      IOException error = assertThrows(IOException.class, () -> ImageHeader.read(file));
      assertEquals("the file is cut short", error.getMessage());
    }
  }

  private Path file(byte[] content) throws IOException {
    return Files.write(folder.resolve("photo.jpg"), content);
  }

  private static byte[] joined(byte[] first, byte[] second) {
    byte[] both = Arrays.copyOf(first, first.length + second.length);
    System.arraycopy(second, 0, both, first.length, second.length);
    return both;
  }

  private static byte[] jpeg(boolean progressive) throws IOException {
    BufferedImage picture = new BufferedImage(60, 40, BufferedImage.TYPE_INT_RGB);
    for (int x = 0; x < 60; x++) {
      for (int y = 0; y < 40; y++) {
        picture.setRGB(x, y, (x * 7919 + y * 104729) & 0xFFFFFF);
      }
    }
    ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
    ImageWriteParam settings = writer.getDefaultWriteParam();
    settings.setProgressiveMode(
        progressive ? ImageWriteParam.MODE_DEFAULT : ImageWriteParam.MODE_DISABLED);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ImageOutputStream out = ImageIO.createImageOutputStream(bytes)) {
      writer.setOutput(out);
      writer.write(null, new IIOImage(picture, null, null), settings);
    } finally {
      writer.dispose();
    }
    return bytes.toByteArray();
  }
}
