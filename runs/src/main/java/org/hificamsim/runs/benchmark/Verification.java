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
 * What a maintainer found who played the policy of an entry on fresh seeds.
 *
 * @param entryHash the SHA-256 of the entry's file
 * @param secretHash the SHA-256 of the secret from which seeds were drawn
 * @param confined whether the system kept the policy from files and other processes
 * @param tasks by name, what was found
 * @param all the same over all tasks
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
   * What was found of a score, on the scale of the benchmark.
   *
   * @param claimed the score of the entry
   * @param fresh the mean score of fresh episodes
   * @param margin by how much they may differ by chance
   * @param reproduced whether the policy scores in testing episodes what the entry says
   */
  public record Finding(double claimed, double fresh, double margin, boolean reproduced) {
    /**
     * Whether the policy reproduces the claimed score, and fresh seeds are lower only by chance.
     */
    boolean holds() {
      return reproduced && claimed - fresh <= margin;
    }

    /** Says both scores, and what does not hold. */
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

  /** What the board says of the entry. */
  public VerificationOutcome outcome() {
    if (!holds()) {
      return VerificationOutcome.NOT_HELD;
    }
    return confined ? VerificationOutcome.HELD : VerificationOutcome.UNCONFINED;
  }

  /** Whether this is of an entry, given its folder or file. */
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
