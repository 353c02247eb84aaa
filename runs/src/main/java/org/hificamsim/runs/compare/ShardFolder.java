package org.hificamsim.runs.compare;

import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.output.ResultFolder;

/**
 * Where a shard's runs are kept: {@code shard.json} says which part of which comparison, {@code
 * runs.jsonl} is its journal.
 *
 * @param content of {@code shard.json}
 */
public record ShardFolder(Path path, Content content) {
  private static final String RUNS = "runs.jsonl";
  private static final String NAME = "shard.json";
  private static final int MAX_BYTES = 1 << 16;

  /**
   * Which part of which comparison, the comparison as a digest of all that its results depend on.
   */
  record Content(String comparison, int shard, int of) {}

  private static final ObjectMapper MAPPER =
      new ObjectMapper().enable(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES);

  /**
   * What is in a folder.
   *
   * @throws InputException when its {@code shard.json} cannot be read
   */
  static Optional<ShardFolder> read(Path path) throws IOException {
    Path file = path.resolve(NAME);
    OutputFolder.settle(path);
    if (!Files.isRegularFile(file)) {
      return Optional.empty();
    }
    if (Files.size(file) <= MAX_BYTES) {
      try {
        Content content = MAPPER.readValue(Files.readAllBytes(file), Content.class);
        if (content != null
            && content.comparison != null
            && Shard.isOne(content.shard, content.of)) {
          return Optional.of(new ShardFolder(path, content));
        }
      } catch (com.fasterxml.jackson.core.JsonProcessingException e) {
        throw new InputException(file + ": expected what --shard writes", e);
      }
    }
    throw new InputException(file + ": expected what --shard writes");
  }

  /**
   * The journal of a folder for one part of a comparison; the folder says so from then on.
   *
   * @param plans of the whole comparison, made by {@link ReferencePolicies#with}
   * @param resume whether runs that are in the folder already count
   * @throws InputException when the folder holds another part
   */
  public static Journal open(OutputFolder folder, Shard shard, List<RunPlan> plans, boolean resume)
      throws IOException {
    Optional<ShardFolder> found = read(folder.path());
    if (found.isPresent()) {
      found.get().requireFor(shard, plans, resume);
    } else if (Files.exists(folder.path().resolve(RUNS), LinkOption.NOFOLLOW_LINKS)) {
      throw InputException.of(
          "'%s' would be replaced, and no --shard wrote it: expected another folder",
          folder.path().resolve(RUNS));
    }
    folder.claim(List.of(NAME, ResultFolder.MANIFEST));
    Journal journal = Journal.open(folder, RUNS, resume);
    try (Writer out = folder.open(NAME)) {
      out.write(MAPPER.writeValueAsString(content(shard, plans)) + "\n");
    }
    folder.commit(List.of());
    return journal;
  }

  private void requireFor(Shard shard, List<RunPlan> plans, boolean resume) throws IOException {
    if (!content.equals(content(shard, plans)) && (isOf(plans) || resume)) {
      String comparison = isOf(plans) ? "" : " of another comparison" + changed(plans);
      throw InputException.of(
          "--out '%s' holds shard %s%s, expected a folder of its own for %s",
          path, shard(), comparison, shard);
    }
  }

  /** Whether it holds a part of this comparison. */
  boolean isOf(List<RunPlan> plans) {
    return content.comparison().equals(RunKey.comparison(plans));
  }

  /** The input that another comparison has, for error lines; empty where that cannot be named. */
  String changed(List<RunPlan> plans) throws IOException {
    try (Journal runs = runs()) {
      return runs.changed(RunKey.of(plans)).map(input -> " (another " + input + ")").orElse("");
    }
  }

  Shard shard() {
    return new Shard(content.shard(), content.of());
  }

  /**
   * The runs that are there.
   *
   * @throws InputException when their file is missing
   */
  Journal runs() throws IOException {
    Path file = path.resolve(RUNS);
    if (!Files.isRegularFile(file)) {
      throw new InputException("no file '" + file + "', expected what --shard writes");
    }
    return Journal.read(file);
  }

  private static Content content(Shard shard, List<RunPlan> plans) {
    return new Content(RunKey.comparison(plans), shard.number(), shard.of());
  }
}
