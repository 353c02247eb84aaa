package org.hificamsim.profiling.lab;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Core;
import org.opencv.core.Mat;
import org.opencv.core.MatOfByte;
import org.opencv.core.Rect;
import org.opencv.core.Size;
import org.opencv.imgcodecs.Imgcodecs;
import org.opencv.imgproc.Imgproc;

/**
 * Provides textures from photographs; {@code SOURCES.md} lists their sources. Each object has its
 * own photograph. Things and the wall show random parts of other photographs, so that the
 * background never contains a part of an object. Textures are square, 8 bits, BGR.
 */
final class PhotoSurfaces implements AutoCloseable {
  private static final List<String> BACKGROUNDS =
      List.of("ascent", "brick", "camera", "flower", "grass", "gravel", "retina");
  private static final double TILE_WIDTH = 5.2;
  private static final double TILE_HEIGHT = 4;
  private static final int TILES_RIGHT = 3;
  private static final int TILES_DOWN = 2;
  private static final int WALL_PARTS = 24;
  private static final int WALL_SIDE = 512;

  private final Mats mats = new Mats();
  private final List<Mat> backgrounds = new ArrayList<>();

  PhotoSurfaces() {
    BACKGROUNDS.forEach(name -> backgrounds.add(mats.own(read("backgrounds/" + name))));
  }

  /** Returns the texture of an object; the caller releases it. */
  Mat object(LabObject shown, int side) {
    try (Mats whole = new Mats()) {
      return resized(whole.own(read("targets/" + shown.photo())), side);
    }
  }

  /** Returns the texture of a thing in the room; the caller releases it. */
  Mat thingTexture(int index, int side, RandomGenerator random) {
    return part(backgrounds.get(index % backgrounds.size()), side, random);
  }

  /**
   * Returns the tiles of the far wall at this distance (metres): parts of photographs that fill the
   * widest view.
   */
  List<Board> wall(double distance, RandomGenerator random) {
    List<Mat> parts = new ArrayList<>();
    for (int i = 0; i < WALL_PARTS; i++) {
      parts.add(mats.own(thingTexture(i, WALL_SIDE, random)));
    }
    List<Board> tiles = new ArrayList<>();
    for (int down = -TILES_DOWN; down <= TILES_DOWN; down++) {
      for (int across = -TILES_RIGHT; across <= TILES_RIGHT; across++) {
        Mat part = parts.get(random.nextInt(WALL_PARTS));
        tiles.add(tile(part, across * TILE_WIDTH, down * TILE_HEIGHT, distance));
      }
    }
    return tiles;
  }

  private static Board tile(Mat part, double x, double y, double distance) {
    return new Board(part, false, TILE_WIDTH, TILE_HEIGHT, x, y, distance, Board.Pose.FRONTAL);
  }

  /** Returns a random square of a photograph, randomly mirrored. */
  private static Mat part(Mat photo, int side, RandomGenerator random) {
    int length = (int) (photo.cols() * random.nextDouble(0.35, 1));
    int x = random.nextInt(photo.cols() - length + 1);
    int y = random.nextInt(photo.rows() - length + 1);
    boolean mirrored = random.nextBoolean();
    try (Mats cut = new Mats()) {
      Mat part = resized(cut.own(photo.submat(new Rect(x, y, length, length))), side);
      if (mirrored) {
        Core.flip(part, part, 1);
      }
      return part;
    }
  }

  private static Mat resized(Mat picture, int side) {
    Mat resized = new Mat();
    int method = picture.cols() > side ? Imgproc.INTER_AREA : Imgproc.INTER_CUBIC;
    Imgproc.resize(picture, resized, new Size(side, side), 0, 0, method);
    return resized;
  }

  private static Mat read(String name) {
    try (InputStream in = PhotoSurfaces.class.getResourceAsStream("photos/" + name + ".jpg");
        Mats bytes = new Mats()) {
      return Imgcodecs.imdecode(
          bytes.own(new MatOfByte(in.readAllBytes())), Imgcodecs.IMREAD_COLOR);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() {
    mats.close();
  }
}
