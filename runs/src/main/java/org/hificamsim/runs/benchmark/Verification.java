package org.hificamsim.runs.benchmark;

import com.fasterxml.jackson.annotation.JsonProperty;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Objects;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.runs.output.JsonOutput;

/**
 * The result of playing the policy of an entry on the fresh seeds of a maintainer.
 *
 * @param entryHash the SHA-256 of the entry's file
 * @param secretHash the SHA-256 of the secret from which seeds were drawn
 * @param confined whether the system kept the policy from files and other processes
 * @param tasks the finding for each task, by the task's name
 * @param all the finding over all tasks
 */
public record Verification(
    @JsonProperty("entry") String entryHash,
    @JsonProperty("secret") String secretHash,
    boolean confined,
    Map<String, Finding> tasks,
    Finding all) {
  /** The file in a folder of 'benchmark verify'. */
  public static final String FILE = "verified.json";

  private static final ObjectMapper MAPPER = new ObjectMapper();

  /** Rejects missing parts. */
  public Verification {
    if (entryHash == null || secretHash == null || all == null || isIncomplete(tasks)) {
      throw new InputException("something is missing, expected entry, secret, tasks and all");
    }
  }

  private static boolean isIncomplete(Map<String, Finding> tasks) {
    return tasks == null || tasks.isEmpty() || tasks.values().stream().anyMatch(Objects::isNull);
  }

  /**
   * A claimed score and that of fresh episodes, on the scale of the benchmark.
   *
   * @param claimed the score of the entry
   * @param fresh the mean score of fresh episodes
   * @param margin the most by which the two may differ by chance
   * @param reproduced whether the policy scores in testing episodes what the entry claims
   */
  public record Finding(double claimed, double fresh, double margin, boolean reproduced) {
    /**
     * Whether the policy reproduces the claimed score, and the score on fresh seeds is not lower by
     * more than chance explains.
     */
    boolean holds() {
      return reproduced && claimed - fresh <= margin;
    }

    /** Describes both scores, and what does not hold. */
    public String text() {
      String scores = Texts.format("%.3f claimed, %.3f on fresh seeds", claimed, fresh);
      String reason = reproduced ? "" : ": the policy scores otherwise in testing";
      return holds()
          ? scores
          : scores + Texts.format(", at most %.3f more by chance", margin) + reason;
    }
  }

  /** Whether the entry's scores hold, in each task and over all. */
  public boolean holds() {
    return all.holds() && tasks.values().stream().allMatch(Finding::holds);
  }

  /** The outcome that the leaderboard shows. */
  public VerificationOutcome outcome() {
    if (!holds()) {
      return VerificationOutcome.NOT_HELD;
    }
    return confined ? VerificationOutcome.HELD : VerificationOutcome.UNCONFINED;
  }

  /** Whether this is the verification of an entry, given the entry's folder or file. */
  public boolean isOf(Path path) {
    return Io.get(() -> Sha256.of(BenchmarkEntry.file(path))).equals(entryHash);
  }

  /** Writes {@value #FILE} into a folder. */
  public void write(OutputFolder folder) throws IOException {
    JsonOutput.write(folder, FILE, MAPPER.valueToTree(this));
  }

  /** Reads the file of a folder. */
  public static Verification read(Path folder) {
    Path file = folder.resolve(FILE);
    try {
      return MAPPER.readValue(file.toFile(), Verification.class);
    } catch (IOException e) {
      throw new InputException(
          file + " cannot be read, expected what 'benchmark verify' writes", e);
    }
  }
}
