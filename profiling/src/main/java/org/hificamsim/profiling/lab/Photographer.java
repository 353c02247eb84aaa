package org.hificamsim.profiling.lab;

import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.hificamsim.profiling.lab.Laboratory.Shot;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.Scalar;
import org.opencv.imgproc.Imgproc;

/** Takes pictures of objects in the room. Thread-safe. */
final class Photographer {
  private static final double TEMPLATE_FRAME_SHARE = 0.82;
  private static final double CLOSE_UP_DISTANCE = 1;
  private static final double LONGEST_FOCAL_LENGTH = 0.085;

  private final LabSettings settings;
  private final Sensor sensor;
  private final Room room;
  private final Map<LabObject, Mat> textures;

  Photographer(LabSettings settings, Room room, Map<LabObject, Mat> textures) {
    this.settings = settings;
    this.sensor = Sensor.scaled(settings.scale());
    this.room = room;
    this.textures = textures;
  }

  /**
   * A picture and the silhouette of its object.
   *
   * @param image 8 bits, BGR
   * @param mask 255 where the object is, before blur
   */
  record Photo(Mat image, Mat mask) implements AutoCloseable {
    @Override
    public void close() {
      image.release();
      mask.release();
    }
  }

  /** Takes one picture. */
  Photo take(Shot shot) {
    RandomGenerator random =
        new SplittableRandom(settings.seed() + 1_000_003L * (shot.index() + 1));
    Pinhole camera = camera(shot.focalLength());
    double error = settings.optics().focusError() * clamped(random.nextGaussian());
    FocusedLens lens =
        new FocusedLens(
            shot.focalLength(), settings.optics().aperture(), shot.distance() * (1 + error));
    Board board = placedBoard(shot, camera, random);
    double gain = 1 + settings.scene().lighting() * clamped(random.nextGaussian());
    try (Mats mats = new Mats()) {
      Mat canvas = mats.own(new Mat(camera.canvas(), CvType.CV_32FC3));
      room.wall().paint(canvas, camera);
      LensBlur.apply(canvas, blur(lens, camera, room.wallDistance()));
      Layer layer = new Layer(canvas, camera);
      for (Board thing : room.behind(shot.distance())) {
        layer.paint(thing, blur(lens, camera, thing.distance()));
      }
      layer.paint(board, blur(lens, camera, shot.distance()));
      Mat mask = mask(mats.own(layer.silhouette(board)), camera);
      return new Photo(exposure(canvas, camera, lens, gain, random), mask);
    }
  }

  /** Takes the close-up of an object: sharp, upright, in front of a plain wall. */
  Mat template(LabObject object) {
    Pinhole camera = camera(LONGEST_FOCAL_LENGTH);
    double size =
        TEMPLATE_FRAME_SHARE
            * sensor.height()
            / camera.magnification(CLOSE_UP_DISTANCE)
            / object.aspect();
    Board board =
        new Board(
            textures.get(object),
            object.round(),
            size,
            size * object.aspect(),
            0,
            0,
            CLOSE_UP_DISTANCE,
            Board.Pose.FRONTAL);
    FocusedLens lens =
        new FocusedLens(LONGEST_FOCAL_LENGTH, settings.optics().aperture(), CLOSE_UP_DISTANCE);
    RandomGenerator random = new SplittableRandom(settings.seed() - object.name().hashCode());
    try (Mats mats = new Mats()) {
      Mat canvas = mats.own(new Mat(camera.canvas(), CvType.CV_32FC3, Scalar.all(0.4)));
      Layer layer = new Layer(canvas, camera);
      layer.paint(board, 0);
      Mat mask = mats.own(mask(mats.own(layer.silhouette(board)), camera));
      Mat picture = mats.own(exposure(canvas, camera, lens, 1, random));
      return picture.submat(Imgproc.boundingRect(mask)).clone();
    }
  }

  private Pinhole camera(double focalLength) {
    double largestShift = RadialDistortion.MAX * settings.optics().distortion();
    int margin = (int) Math.ceil(largestShift * Math.max(sensor.width(), sensor.height())) + 2;
    return new Pinhole(
        focalLength, Sensor.WIDTH, Sensor.HEIGHT, sensor.width(), sensor.height(), margin);
  }

  private RadialDistortion distortion(Pinhole camera) {
    return RadialDistortion.typical(camera.focalLength(), settings.optics().distortion());
  }

  private static double blur(FocusedLens lens, Pinhole camera, double distance) {
    return lens.circleOfConfusion(distance) * camera.pitch();
  }

  /** Places the object near the middle, but always within the frame. */
  private Board placedBoard(Shot shot, Pinhole camera, RandomGenerator random) {
    LabObject object = shot.object();
    double pixels = camera.magnification(shot.distance());
    Board.Pose pose =
        new Board.Pose(randomAngle(1, random), randomAngle(1, random), randomAngle(0.5, random));
    double x = offset(sensor.width() / pixels, object.size(), random);
    double y = offset(sensor.height() / pixels, object.height(), random);
    return new Board(
        textures.get(object),
        object.round(),
        object.size(),
        object.height(),
        x,
        y,
        shot.distance(),
        pose);
  }

  /** Returns a random angle in radians, with this share of the pose's standard deviation. */
  private double randomAngle(double share, RandomGenerator random) {
    return Math.toRadians(settings.scene().pose() * share * clamped(random.nextGaussian()));
  }

  private double offset(double frame, double length, RandomGenerator random) {
    double free = Math.max(0, (frame - length) / 2 * 0.5);
    return random.nextDouble(-1, 1) * Math.min(settings.scene().offset() * frame, free);
  }

  /** Limits a normal deviate, as a careful experimenter would discard outliers. */
  private static double clamped(double deviate) {
    return Math.max(-2.5, Math.min(2.5, deviate));
  }

  private Mat mask(Mat silhouette, Pinhole camera) {
    try (Mats mats = new Mats()) {
      Mat frame = mats.own(distortion(camera).frame(silhouette, camera, Imgproc.INTER_LINEAR));
      Mat mask = new Mat();
      Core.compare(frame, new Scalar(0.5), mask, Core.CMP_GE);
      return mask;
    }
  }

  private Mat exposure(
      Mat canvas, Pinhole camera, FocusedLens lens, double gain, RandomGenerator random) {
    try (Mats mats = new Mats()) {
      Mat light = mats.own(distortion(camera).frame(canvas, camera, Imgproc.INTER_CUBIC));
      Sensor.diffract(light, lens.diffraction() * camera.pitch());
      Core.multiply(light, tint(gain, random), light);
      sensor.vignette(light, camera.focalLength(), settings.optics().vignetting());
      sensor.addNoise(light, settings.optics().iso(), random.nextInt());
      return Sensor.developed(light);
    }
  }

  /** Returns the brightness with a slight colour cast. */
  private Scalar tint(double gain, RandomGenerator random) {
    double cast = settings.scene().lighting() / 3 * clamped(random.nextGaussian());
    return new Scalar(gain * (1 - cast), gain, gain * (1 + cast));
  }

  /** Whether the object of a mask lies within the frame: none of the border pixels is set. */
  static boolean isWithinFrame(Mat mask) {
    int right = mask.cols() - 1;
    int bottom = mask.rows() - 1;
    try (Mats mats = new Mats()) {
      return List.of(mask.row(0), mask.row(bottom), mask.col(0), mask.col(right)).stream()
          .allMatch(edge -> Core.countNonZero(mats.own(edge)) == 0);
    }
  }
}
