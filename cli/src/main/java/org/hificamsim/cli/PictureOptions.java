package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.presentation.picture.Animation;
import org.hificamsim.presentation.picture.FrameScores;
import org.hificamsim.presentation.picture.HeatPicture;
import org.hificamsim.presentation.picture.Look;
import org.hificamsim.presentation.picture.RunFrames;
import org.hificamsim.presentation.picture.StepPicture;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.plot.Paintable;
import org.hificamsim.presentation.replay.RecordedRun;
import org.hificamsim.presentation.replay.Replay;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.runs.heat.HeatFigure;
import org.hificamsim.runs.heat.HeatTable;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParseResult;

/** The options of {@code report} for pictures, which need no browser. */
final class PictureOptions {
  private static final int PNG_WIDTH = 1600;
  private static final int GIF_WIDTH = 640;
  private static final int MIN_WIDTH = 200;
  private static final int MAX_WIDTH = 8000;
  private static final int MAX_GIF_WIDTH = 2000;
  private static final int MAX_PICTURES_PER_SECOND = 50;

  @Option(names = "--png", paramLabel = "FILE")
  private Path png;

  @Option(names = "--svg", paramLabel = "FILE")
  private Path svg;

  @Option(names = "--pdf", paramLabel = "FILE")
  private Path pdf;

  @Option(names = "--gif", paramLabel = "FILE")
  private Path gif;

  @Option(names = "--run", paramLabel = "N")
  private int repeat;

  @Option(names = "--step", paramLabel = "N")
  private Long step;

  @Option(names = "--from", paramLabel = "N")
  private long from;

  @Option(names = "--to", paramLabel = "N")
  private Long to;

  @Option(names = "--every", paramLabel = "N")
  private Integer every;

  @Option(names = "--per-second", paramLabel = "N")
  private int perSecond;

  @Option(names = "--density", paramLabel = "CAMERA")
  private Optional<String> density;

  @Option(names = "--floorplan", paramLabel = "OPACITY")
  private Optional<Double> floor;

  @Option(names = "--heatmap", paramLabel = "FIGURE")
  private Optional<String> heat;

  @Option(names = "--tracks")
  private boolean tracks;

  @Option(names = "--width", paramLabel = "PIXELS")
  private Integer width;

  private int repeats;

  /** Whether any picture is asked for. */
  boolean isAsked() {
    return asksForStill() || gif != null;
  }

  private boolean asksForStill() {
    return png != null || svg != null || pdf != null;
  }

  /**
   * Rejects options for pictures that are not asked for.
   *
   * @param words the command line
   */
  void check(ParseResult words) {
    require(words, asksForStill(), "--png, --svg or --pdf", "--step", "--heatmap", "--tracks");
    if (heat.isPresent() && words.hasMatchedOption("--step")) {
      throw new InputException("--heatmap shows all steps, expected no --step with it");
    }
    require(words, gif != null, "--gif", "--from", "--to", "--every", "--per-second");
    require(words, isAsked(), "--png, --svg, --pdf or --gif", "--run", "--density", "--floorplan");
    require(words, png != null || gif != null, "--png or --gif", "--width");
  }

  private static void require(ParseResult words, boolean isMet, String needed, String... options) {
    for (String option : options) {
      if (!isMet && words.hasMatchedOption(option)) {
        throw new InputException(option + " needs " + needed);
      }
    }
  }

  /** Checks that the pictures may be written. */
  void claim(Destination destination) throws IOException {
    String[] options = {"--png", "--svg", "--pdf", "--gif"};
    Path[] files = {png, svg, pdf, gif};
    for (int i = 0; i < files.length; i++) {
      if (files[i] != null) {
        destination.file(options[i], files[i]);
      }
    }
  }

  /** Draws the pictures, and prints the name of each file to {@code out}. */
  void write(Path folder, Destination destination, PrintWriter out) throws IOException {
    Numbers.inRange("--per-second", perSecond, 1, MAX_PICTURES_PER_SECOND);
    if (width != null) {
      Numbers.inRange("--width", width, MIN_WIDTH, gif == null ? MAX_WIDTH : MAX_GIF_WIDTH);
    }
    RunFrames run = frames(folder);
    Paintable still = still(folder, run);
    Animation animation = animation(run);
    if (png != null) {
      int pixels = width == null ? PNG_WIDTH : width;
      destination.file("--png", png).write(stream -> FigureFile.png(stream, still, pixels));
      out.println(png);
    }
    write("svg", svg, still, destination, out);
    write("pdf", pdf, still, destination, out);
    if (gif != null) {
      int pixels = width == null ? GIF_WIDTH : width;
      destination.file("--gif", gif).write(stream -> animation.write(stream, pixels, perSecond));
      out.printf(
          "%s (%s pictures, one for %s)%n",
          gif,
          animation.pictures(),
          animation.stepsApart() == 1 ? "each step" : animation.stepsApart() + " steps");
    }
  }

  private static void write(
      String format, Path file, Paintable still, Destination destination, PrintWriter out)
      throws IOException {
    if (file != null) {
      OutputFile claimed = destination.file("--" + format, file);
      claimed.write(stream -> FigureFile.write(stream, format, still));
      out.println(file);
    }
  }

  private Paintable still(Path folder, RunFrames run) throws IOException {
    if (heat.isEmpty()) {
      return new StepPicture(run, run.indexOf("--step", step == null ? run.last() : step));
    }
    HeatFigure figure = Spelling.require(HeatFigure.class, "--heatmap", heat.get());
    if (!HeatTable.TABLE.isIn(folder)) {
      throw InputException.of(
          "no file '%s', expected a folder that 'hificamsim run --record --heatmap' wrote",
          folder.resolve(HeatTable.TABLE.file()));
    }
    return new HeatPicture(run, HeatTable.read(folder, run.field()), figure, repeats);
  }

  private RunFrames frames(Path folder) throws IOException {
    Replay replay = Replay.read(folder);
    repeats = replay.repeat();
    for (int i = 0; i < replay.runs().size(); i++) {
      if (replay.runs().get(i).run() == repeat) {
        RecordedRun recording = replay.recording(folder, i);
        return new RunFrames(
            replay.setup(), recording, look(replay.setup()), FrameScores.read(folder, recording));
      }
    }
    throw InputException.of(
        "--run is %s, expected one of the %s repeats recorded, from 0",
        repeat, replay.runs().size());
  }

  private Look look(Setup setup) {
    double opacity = floor.orElse(Look.DEFAULT.floorOpacity());
    if (!(opacity >= 0 && opacity <= 1)) {
      throw new InputException("--floorplan is " + opacity + ", expected a number from 0 to 1");
    }
    return new Look(
        opacity,
        density.stream().mapToInt(name -> cameraWithDensity(setup, name)).findFirst(),
        tracks);
  }

  private static int cameraWithDensity(Setup setup, String name) {
    List<Setup.Camera> cameras = setup.cameras();
    return IntStream.range(0, cameras.size())
        .filter(i -> cameras.get(i).name().equals(name) && cameras.get(i).pose().hasDensity())
        .findFirst()
        .orElseThrow(
            () ->
                InputException.of(
                    "--density is '%s', expected a camera with pixels and a lens", name));
  }

  private Animation animation(RunFrames run) {
    int first = run.indexOf("--from", from);
    int last = run.indexOf("--to", to == null ? run.last() : to);
    if (last < first) {
      throw new InputException("--to is %s, expected a step from %s on".formatted(to, from));
    }
    if (every == null) {
      return Animation.of(run, first, last);
    }
    long recorded = run.stepsApart();
    if (every < 1 || every % recorded != 0) {
      throw InputException.of("--every is %s, expected a multiple of %s, above 0", every, recorded);
    }
    return new Animation(run, first, last, (int) (every / recorded));
  }
}
