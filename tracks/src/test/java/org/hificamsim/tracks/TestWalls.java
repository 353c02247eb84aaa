package org.hificamsim.tracks;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;
import org.hificamsim.tracks.place.Drawing;
import org.hificamsim.tracks.place.DrawingSettings;
import org.hificamsim.tracks.place.LayerChoice;
import org.hificamsim.tracks.place.PictureFrame;
import org.hificamsim.tracks.place.WallFile;

/** Reads walls with default settings, for tests. */
final class TestWalls {
  private TestWalls() {}

  static List<Obstacle> obstacles(Path file, Unit usualUnit, Optional<PictureFrame> frame) {
    return drawing(file, usualUnit, frame).obstacles(false);
  }

  static Drawing drawing(Path file, Unit usualUnit, Optional<PictureFrame> frame) {
    return WallFile.read(
        file,
        new DrawingSettings(
            Optional.empty(), usualUnit, new LocalProjection(), frame, LayerChoice.ALL));
  }
}
