package org.hificamsim.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.hificamsim.profiling.lab.LabSettings;
import org.hificamsim.profiling.lab.Laboratory;
import org.hificamsim.profiling.lab.Texture;
import org.hificamsim.profiling.opencv.OpenCv;
import org.hificamsim.runs.Setting;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code hificamsim profile lab}: renders the laboratory of thesis 3.5. */
@Command(
    name = "lab",
    description = "Renders photos of textured objects: a data set for 'profile measure'.")
final class LabCommand implements Callable<Integer> {
  private static final int MAX_OBJECTS = 8;
  private static final int MAX_CLUTTER = 1000;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      required = true,
      description = "Where the data set goes.")
  private Path out;

  @Option(
      names = "--scale",
      paramLabel = "S",
      description = "Share of the sensor's 5184 x 3456 pixels across, 0.02 to 1.")
  private double scale;

  @Option(names = "--focal-lengths", paramLabel = "M,M", split = ",", description = "Metres.")
  private List<Double> focalLengths;

  @Option(names = "--distances", paramLabel = "M,M", split = ",", description = "Metres.")
  private List<Double> distances;

  @Option(
      names = "--objects",
      paramLabel = "N",
      description = "How many of the eight objects, from the smallest.")
  private int objects;

  @Option(
      names = "--texture",
      paramLabel = "photos|painted",
      description = "What is on the objects and behind them: photographs, or painted shapes.")
  private Texture texture;

  @Option(
      names = "--aperture",
      paramLabel = "N",
      description = "f-number: blur by distance, and diffraction; 0 for none.")
  private double aperture;

  @Option(
      names = "--focus-error",
      paramLabel = "P",
      description = "Standard deviation of the focused distance, as a share.")
  private double focusError;

  @Option(
      names = "--iso",
      paramLabel = "ISO",
      description = "Sensitivity, for the sensor's noise; 0 for none.")
  private double iso;

  @Option(
      names = "--vignetting",
      paramLabel = "P",
      description = "Share of the cos^4 fall-off, 0 to 1.")
  private double vignetting;

  @Option(
      names = "--distortion",
      paramLabel = "X",
      description = "Factor on the radial distortion; 0 for none.")
  private double distortion;

  @Option(
      names = "--pose",
      paramLabel = "DEG",
      description = "Standard deviation of the objects' yaw and pitch, degrees.")
  private double pose;

  @Option(
      names = "--offset",
      paramLabel = "P",
      description = "How far off the centre objects stand, as a share of the frame.")
  private double offset;

  @Option(
      names = "--lighting",
      paramLabel = "P",
      description = "Standard deviation of the brightness, as a share.")
  private double lighting;

  @Option(
      names = "--clutter",
      paramLabel = "N",
      description = "Things in the room behind the object.")
  private int clutter;

  @Mixin private ThreadsOption threads;

  @Mixin private Screen screen;

  @Mixin private final SettingOptions seed = SettingOptions.of(Setting.SEED);

  @Override
  public Integer call() {
    LabSettings settings = settings();
    int count = threads.count();
    Laboratory laboratory = new Laboratory(settings);
    Laboratory.PhotoCount photos;
    try (Progress progress = screen.progress("", " photos", laboratory.shots())) {
      photos = laboratory.render(out, count, progress::advance);
    }
    screen
        .out()
        .printf(
            "%s photos by OpenCV %s in %s; %s dropped, whose object is larger than the frame%n",
            photos.taken(), OpenCv.version(), out, photos.dropped());
    return 0;
  }

  /** Checks every option before anything is written. */
  private LabSettings settings() {
    Numbers.within("--scale", scale, 0.02, 1);
    focalLengths.forEach(z -> Numbers.within("--focal-lengths", z, 0.001, 1));
    distances.forEach(d -> Numbers.within("--distances", d, 0.2, 11));
    Numbers.inRange("--objects", objects, 1, MAX_OBJECTS);
    Numbers.within("--aperture", aperture, 0, 64);
    Numbers.within("--focus-error", focusError, 0, 0.2);
    Numbers.within("--iso", iso, 0, 1e6);
    Numbers.within("--vignetting", vignetting, 0, 1);
    Numbers.within("--distortion", distortion, -3, 3);
    Numbers.within("--pose", pose, 0, 20);
    Numbers.within("--offset", offset, 0, 0.4);
    Numbers.within("--lighting", lighting, 0, 0.3);
    Numbers.inRange("--clutter", clutter, 0, MAX_CLUTTER);
    return new LabSettings(
        seed.settings().seed(),
        scale,
        focalLengths,
        distances,
        objects,
        texture,
        new LabSettings.Optics(aperture, focusError, iso, vignetting, distortion),
        new LabSettings.Scene(pose, offset, lighting, clutter));
  }
}
