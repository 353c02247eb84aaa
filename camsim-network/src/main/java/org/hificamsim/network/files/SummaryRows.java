package org.hificamsim.network.files;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.network.statistics.StepFigures;

/**
 * CamSim's summary file (behaviour 10.5): one row is appended per run, under a lock and in one
 * write, so that parallel runs may share it.
 */
public final class SummaryRows {
  /**
   * The columns. CamSim takes GLOBAL_UTILITY, COMMUNICATION, HANDOVER and VISIBLE from a step that
   * never began: they are 0.
   */
  private static final String HEADER =
      "SEED,TIME,GLOBAL_UTILITY,CUMULATIVE_UTILITY,COMMUNICATION,CUMULATIVE_COMM,HANDOVER,"
          + "CUMULATIVE_HANDOVER,CUMULATIVE_COMM_OH,VISIBLE,OVERLAP,CONFIDENCE,PROPORTION";

  private final Path path;

  /**
   * Prepares a summary file, which may exist already.
   *
   * @throws InputException if the path cannot be that of a file
   */
  SummaryRows(Path path) {
    this.path = path;
    Path folder = path.toAbsolutePath().getParent();
    if (Files.isDirectory(path) || !Files.isDirectory(folder)) {
      throw InputException.of(
          "summary file '%s' cannot be written, expected a file in an existing folder", path);
    }
  }

  /**
   * Returns the default path of the summary: {@code summary.csv} next to the output (quirk Q20 is
   * fixed).
   */
  static Path defaultPath(Path output) {
    return output.resolveSibling("summary.csv");
  }

  /** Appends the row of a run. */
  void append(long seed, StepFigures sums) throws IOException {
    try (FileChannel file =
        FileChannel.open(path, StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
      FileLock lock = file.lock();
      try {
        String end = System.lineSeparator();
        String header = file.size() == 0 ? HEADER + end : "";
        byte[] text = (header + row(seed, sums) + end).getBytes(StandardCharsets.UTF_8);
        file.write(ByteBuffer.wrap(text), file.size());
      } finally {
        lock.release();
      }
    }
  }

  /** Returns the text of the summary file of several runs with consecutive seeds. */
  public static String text(long firstSeed, List<StepFigures> runs) {
    StringBuilder text = new StringBuilder(HEADER).append(System.lineSeparator());
    for (int i = 0; i < runs.size(); i++) {
      text.append(row(firstSeed + i, runs.get(i))).append(System.lineSeparator());
    }
    return text.toString();
  }

  private static String row(long seed, StepFigures sums) {
    return Stream.of(
            seed,
            sums.step(),
            0.0,
            sums.utility(),
            0.0,
            (double) sums.communication(),
            0.0,
            (double) sums.handovers(),
            (double) sums.attempts(),
            0,
            sums.overlap(),
            sums.confidence(),
            sums.proportion())
        .map(String::valueOf)
        .collect(Collectors.joining(","));
  }
}
