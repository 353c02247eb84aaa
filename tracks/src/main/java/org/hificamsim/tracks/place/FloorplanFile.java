package org.hificamsim.tracks.place;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.TextLines;
import org.hificamsim.core.scenario.Field;

/** A picture of a place, with its size in pixels. */
public final class FloorplanFile {
  private FloorplanFile() {}

  /**
   * The ground that a picture shows.
   *
   * @throws org.hificamsim.core.InputException when it is missing or no PNG or JPEG
   */
  public static Field area(Path file, PictureFrame frame) {
    try (ImageInputStream in = ImageIO.createImageInputStream(TextLines.stream(file))) {
      Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
      if (readers.hasNext()) {
        ImageReader reader = readers.next();
        reader.setInput(in);
        return frame.area(reader.getWidth(0), reader.getHeight(0));
      }
    } catch (IOException e) {
      throw TextLines.unreadable(file.toString(), 1, e);
    }
    throw new Place(file.toString(), 1, 1).error("no picture, expected a PNG or JPEG");
  }
}
