package org.hificamsim.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.hificamsim.core.Ranges;
import org.hificamsim.profiling.lab.LabSettings;
import org.hificamsim.profiling.lab.Laboratory;
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

  @Option(names = "--out", paramLabel = "DIR", required = true)
  private Path out;

  @Option(names = "--scale", paramLabel = "S")
  private double scale;

  @Option(names = "--focal-lengths", paramLabel = "M,M", split = ",")
  private List<Double> focalLengths;

  @Option(names = "--distances", paramLabel = "M,M", split = ",")
  private List<Double> distances;

  @Option(names = "--objects", paramLabel = "N")
  private int objects;

  @Option(names = "--aperture", paramLabel = "N")
  private double aperture;

  @Option(names = "--focus-error", paramLabel = "P")
  private double focusError;

  @Option(names = "--iso", paramLabel = "ISO")
  private double iso;

  @Option(names = "--vignetting", paramLabel = "P")
  private double vignetting;

  @Option(names = "--distortion", paramLabel = "X")
  private double distortion;

  @Option(names = "--pose", paramLabel = "DEG")
  private double pose;

  @Option(names = "--offset", paramLabel = "P")
  private double offset;

  @Option(names = "--lighting", paramLabel = "P")
  private double lighting;

  @Option(names = "--clutter", paramLabel = "N")
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
    screen.say(
        "%s photos by OpenCV %s in %s; %s dropped, whose object is larger than the frame",
        photos.taken(), OpenCv.version(), out, photos.dropped());
    return 0;
  }

  /** Checks every option before anything is written. */
  private LabSettings settings() {
    Ranges.within("--scale", scale, 0.02, 1);
    focalLengths.forEach(length -> Ranges.within("--focal-lengths", length, 0.001, 1));
    distances.forEach(distance -> Ranges.within("--distances", distance, 0.2, 11));
    Numbers.inRange("--objects", objects, 1, MAX_OBJECTS);
    Ranges.within("--aperture", aperture, 0, 64);
    Ranges.within("--focus-error", focusError, 0, 0.2);
    Ranges.within("--iso", iso, 0, 1e6);
    Ranges.within("--vignetting", vignetting, 0, 1);
    Ranges.within("--distortion", distortion, -3, 3);
    Ranges.within("--pose", pose, 0, 20);
    Ranges.within("--offset", offset, 0, 0.4);
    Ranges.within("--lighting", lighting, 0, 0.3);
    Numbers.inRange("--clutter", clutter, 0, MAX_CLUTTER);
    return new LabSettings(
        seed.settings().seed(),
        scale,
        focalLengths,
        distances,
        objects,
        new LabSettings.Optics(aperture, focusError, iso, vignetting, distortion),
        new LabSettings.Scene(pose, offset, lighting, clutter));
  }
}
