package org.hificamsim.presentation.replay;

import static org.hificamsim.core.NamedSetting.setting;

import com.fasterxml.jackson.core.JsonProcessingException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.data.JsonFault;
import org.hificamsim.runs.output.ResultFolder;

/**
 * The content of {@code replay.json}: a recording of repeated runs for pages and pictures.
 *
 * @param repeat the number of repeats
 * @param runs the first repeats, 1 or more
 */
public record Replay(String format, int repeat, Setup setup, List<PackedRun> runs) {
  static final String FORMAT = "hificamsim-replay-1";

  /**
   * Reads the recording in the folder of a run.
   *
   * @throws InputException if the file is missing or is not a recording
   */
  public static Replay read(Path folder) throws IOException {
    Path file = new ResultFolder(folder).file(ResultFolder.REPLAY);
    try {
      return ReplayJson.mapper().readValue(file.toFile(), Replay.class).checked(file);
    } catch (JsonProcessingException e) {
      throw JsonFault.of(file, e, "what 'run' with " + setting("record") + " writes");
    }
  }

  /**
   * Unpacks one run.
   *
   * @param index the index of the run in {@link #runs}
   * @throws InputException if its data are broken
   */
  public RecordedRun recording(Path folder, int index) {
    try {
      return runs.get(index).unpack(setup);
    } catch (IOException e) {
      throw broken(folder.resolve(ResultFolder.REPLAY), "the data of run " + index, e);
    }
  }

  private Replay checked(Path file) {
    if (!format.equals(FORMAT)) {
      throw InputException.of(
          "%s: format is '%s', expected %s; maybe record the run again", file, format, FORMAT);
    }
    if (runs.isEmpty()) {
      throw broken(file, "runs", null);
    }
    boolean fits = setup.widths().isEmpty() || setup.widths().size() == setup.targets().size();
    if (!fits || !setup.cameras().stream().allMatch(camera -> camera.pose().isConsistent())) {
      throw broken(file, "setup", null);
    }
    int maxFrames = ReplayRecorder.Limits.DEFAULT.frames(setup, false) + 2;
    for (PackedRun run : runs) {
      if (run.frames() < 1 || run.frames() > maxFrames || run.steps() < run.frames()) {
        throw broken(file, "frames of run " + run.run(), null);
      }
      for (Move move : run.moves()) {
        if (move.camera() < 0
            || move.camera() >= setup.cameras().size()
            || !move.pose().isConsistent()) {
          throw broken(file, "moves of run " + run.run(), null);
        }
      }
    }
    return this;
  }

  private static InputException broken(Path file, String part, Throwable cause) {
    return InputException.of(
            "%s: %s cannot be read, expected what 'run' with %s writes",
            file, part, setting("record"))
        .because(cause);
  }
}
