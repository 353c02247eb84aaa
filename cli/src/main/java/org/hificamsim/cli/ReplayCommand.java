package org.hificamsim.cli;

import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.hificamsim.tracks.mate.MateEpisode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim benchmark replay}: an episode of another simulator, with its poses. */
@Command(
    name = "replay",
    description = {
      "Prints the share of the targets that the cameras of a recorded episode cover.",
      "The poses are those of the recording; lines of sight are computed by this simulator."
    })
final class ReplayCommand implements Callable<Integer> {
  /** The simulators whose episodes are read. */
  private enum Format {
    MATE
  }

  @Parameters(paramLabel = "EPISODE.csv[.gz]", description = "The poses of each step.")
  private Path episode;

  @Option(names = "--format", required = true, paramLabel = "mate")
  @SuppressWarnings("UnusedVariable") // picocli refuses any other
  private Format format;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() {
    MateEpisode replayed = MateEpisode.replay(episode);
    spec.commandLine()
        .getOut()
        .printf(
            Locale.ROOT,
            "episode  %s: %d steps, %d cameras, %d targets%ncoverage %.4f%n",
            episode,
            replayed.steps(),
            replayed.cameras(),
            replayed.targets(),
            replayed.coverage());
    return 0;
  }
}
