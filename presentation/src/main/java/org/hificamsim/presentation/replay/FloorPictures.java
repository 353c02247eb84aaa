package org.hificamsim.presentation.replay;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Base64;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Floorplan;

/** Reads the floor plan of a scenario, and makes it small enough for a page. */
public final class FloorPictures {
  private static final Set<String> TYPES = Set.of("png", "jpeg");
  private static final int MAX_SIDE = 2000; // pixels
  private static final int MAX_BYTES = 1_000_000;

  /** The greatest ratio of the pixels per side that are read to those that are kept. */
  private static final int OVERSAMPLING = 4;

  private static final String URI_START = "data:image/";
  private static final String BASE64 = ";base64,";

  private FloorPictures() {}

  /**
   * Reads the floor plan of a scenario; returns nothing if the scenario names none.
   *
   * @param scenarioFile the file of the scenario
   * @throws InputException if the picture is missing or is not a PNG or JPEG
   */
  public static List<Setup.Floor> of(Path scenarioFile, Scenario scenario) {
    return scenario.floorplan().stream()
        .map(plan -> new Setup.Floor(plan.area(), data(scenarioFile, plan)))
        .toList();
  }

  /**
   * Decodes a picture.
   *
   * @throws InputException if the data are not a picture
   */
  public static BufferedImage image(Setup.Floor picture) {
    try {
      String data = picture.data();
      byte[] bytes = Base64.getDecoder().decode(data.substring(data.indexOf(',') + 1));
      BufferedImage image = ImageIO.read(new ByteArrayInputStream(bytes));
      if (data.startsWith(URI_START) && image != null) {
        return image;
      }
      throw new InputException("the floor of a recording is not a picture, expected a PNG or JPEG");
    } catch (IOException | IllegalArgumentException e) {
      throw new InputException(
          "the floor of a recording cannot be read, expected a PNG or JPEG", e);
    }
  }

  private static String data(Path scenarioFile, Floorplan plan) {
    try {
      Path file = scenarioFile.resolveSibling(plan.file());
      if (!Files.isRegularFile(file)) {
        throw error(scenarioFile, plan, "there is no such file", null);
      }
      return data(Files.readAllBytes(file))
          .orElseThrow(() -> error(scenarioFile, plan, "it is neither of them", null));
    } catch (IOException | InvalidPathException e) {
      throw error(scenarioFile, plan, "it cannot be read", e);
    }
  }

  /** Returns the picture as a data URI; empty if it is neither PNG nor JPEG. */
  private static Optional<String> data(byte[] bytes) throws IOException {
    try (ImageInputStream in = ImageIO.createImageInputStream(new ByteArrayInputStream(bytes))) {
      Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
      ImageReader reader = readers.hasNext() ? readers.next() : null;
      String type = reader == null ? "" : reader.getFormatName().toLowerCase(Locale.ROOT);
      if (!TYPES.contains(type)) {
        return Optional.empty();
      }
      reader.setInput(in);
      BufferedImage image = read(reader);
      boolean small = Math.max(reader.getWidth(0), reader.getHeight(0)) <= MAX_SIDE;
      return Optional.of(small && bytes.length <= MAX_BYTES ? uri(type, bytes) : shrunkUri(image));
    } catch (RuntimeException e) {
      throw new IOException(e); // readers throw exceptions of any kind
    }
  }

  private static InputException error(
      Path scenarioFile, Floorplan plan, String reason, Throwable cause) {
    return InputException.of(
            "%s: floorplan is '%s', expected a PNG or JPEG, its path from the scenario's"
                + " folder; %s",
            scenarioFile, plan.file(), reason)
        .because(cause);
  }

  /** Reads a picture. A very large one is read with fewer pixels, so that it fits into memory. */
  private static BufferedImage read(ImageReader reader) throws IOException {
    int side = Math.max(reader.getWidth(0), reader.getHeight(0));
    int step = Math.max(1, side / (OVERSAMPLING * MAX_SIDE));
    ImageReadParam parameters = reader.getDefaultReadParam();
    parameters.setSourceSubsampling(step, step, 0, 0);
    return reader.read(0, parameters);
  }

  /**
   * Returns a PNG; if that is too large, a JPEG, whose sides are halved until it is small enough.
   */
  private static String shrunkUri(BufferedImage image) throws IOException {
    BufferedImage scaled = scaled(image, MAX_SIDE);
    byte[] png = bytes(scaled, "png");
    if (png.length <= MAX_BYTES) {
      return uri("png", png);
    }
    byte[] jpeg = bytes(scaled, "jpeg");
    while (jpeg.length > MAX_BYTES) {
      scaled = scaled(scaled, Math.max(scaled.getWidth(), scaled.getHeight()) / 2);
      jpeg = bytes(scaled, "jpeg");
    }
    return uri("jpeg", jpeg);
  }

  /** Returns the picture on white, with its longer side at most this long. */
  private static BufferedImage scaled(BufferedImage image, int maxSide) {
    double factor = Math.min(1, (double) maxSide / Math.max(image.getWidth(), image.getHeight()));
    int width = Math.max(1, (int) Math.round(factor * image.getWidth()));
    int height = Math.max(1, (int) Math.round(factor * image.getHeight()));
    BufferedImage scaled = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = scaled.createGraphics();
    Image averaged = image.getScaledInstance(width, height, Image.SCALE_AREA_AVERAGING);
    graphics.drawImage(averaged, 0, 0, Color.WHITE, null);
    graphics.dispose();
    return scaled;
  }

  private static byte[] bytes(BufferedImage image, String type) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    Io.run(() -> ImageIO.write(image, type, out));
    return out.toByteArray();
  }

  private static String uri(String type, byte[] bytes) {
    return URI_START + type + BASE64 + Base64.getEncoder().encodeToString(bytes);
  }
}
