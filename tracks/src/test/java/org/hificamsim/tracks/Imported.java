package org.hificamsim.tracks;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.tracks.format.FormatChoice;
import org.hificamsim.tracks.format.Recording;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.Homography;
import org.hificamsim.tracks.ground.LocalProjection;

/** Imports small files. */
final class Imported {
  private final Path folder;
  private OptionalDouble rate = OptionalDouble.empty();
  private Optional<Unit> unit = Optional.empty();
  private Map<String, String> columns = Map.of();
  private Optional<Homography> homography = Optional.empty();
  private OptionalDouble gap = OptionalDouble.empty();
  private double from;
  private double to = 1e9;
  private List<Obstacle> walls = List.of();

  Imported(Path folder) {
    this.folder = folder;
  }

  Imported rate(double value) {
    rate = OptionalDouble.of(value);
    return this;
  }

  Imported unit(Unit value) {
    unit = Optional.of(value);
    return this;
  }

  Imported columns(Map<String, String> value) {
    columns = value;
    return this;
  }

  Imported homography(String rows) {
    homography = Optional.of(Homography.read(written("homography.txt", rows)));
    return this;
  }

  Imported gap(double seconds) {
    gap = OptionalDouble.of(seconds);
    return this;
  }

  Imported cut(double fromSeconds, double toSeconds) {
    from = fromSeconds;
    to = toSeconds;
    return this;
  }

  Imported wall(double x1, double y1, double x2, double y2) {
    walls = List.of(new Obstacle.Wall(x1, y1, x2, y2, 0));
    return this;
  }

  /** Imports a file with this content, writes the tracks next to it, and returns the summary. */
  ImportSummary read(String format, String content) {
    return readFile(format, written("recording", content));
  }

  /** Imports as {@link #read}, and refuses a file with too many omissions. */
  ImportSummary checked(String format, String content) {
    ImportSummary summary = read(format, content);
    Plausibility signs = Plausibility.of(summary.notes());
    signs.signs(false);
    return summary;
  }

  /** Imports several files together. */
  ImportSummary readAll(String format, String... contents) {
    List<Path> files = new ArrayList<>();
    for (String content : contents) {
      files.add(written("recording-" + files.size(), content));
    }
    return readFiles(format, files);
  }

  ImportSummary readFile(String format, Path file) {
    return readFiles(format, List.of(file));
  }

  private ImportSummary readFiles(String format, List<Path> files) {
    List<FormatChoice> recordings =
        files.stream()
            .map(file -> FormatChoice.of(format, new Recording(file, rate, unit, columns)))
            .toList();
    TrackSettings settings =
        new TrackSettings(gap, from, to, TargetSpec.DEFAULT_SIZE, Optional.empty());
    TracksImport imported = new TracksImport(recordings, homography, new LocalProjection());
    try (OutputFolder out = new OutputFolder(folder)) {
      StringBuilder text = new StringBuilder();
      ImportSummary summary = imported.write(settings, new Obstacles(walls), text);
      out.write("made.tracks", text.toString());
      out.commit(List.of());
      return summary;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The tracks that were written, without the first two lines of the file. */
  String tracks() {
    try {
      return Files.readString(folder.resolve("made.tracks")).split("\n", 3)[2].replace('\n', ';');
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Path written(String name, String content) {
    try {
      return Files.write(folder.resolve(name), content.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
