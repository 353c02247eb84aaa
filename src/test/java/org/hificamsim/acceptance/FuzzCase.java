package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.regex.Pattern;

/** A valid file and the changes that break it. */
record FuzzCase(FuzzKind kind, Path seed, List<FuzzEdit> edits) {
  private static final Duration LONGEST = Duration.ofSeconds(60); // on a busy machine
  private static final Path FOUND = Cli.ROOT.resolve("build/fuzz");
  private static final Pattern PLACE = Pattern.compile("error: [^:]*:(\\d+:\\d+:)? .*");
  private static final int LONGEST_LINE = 1000;
  private static final int MOST_EDITS = 4;

  /** Breaks one of the valid files of a kind in one to four places. */
  static FuzzCase of(FuzzKind kind, Random random) {
    List<Path> corpus = kind.corpus();
    Path seed = corpus.get(random.nextInt(corpus.size()));
    List<FuzzEdit> edits = new ArrayList<>();
    for (int i = random.nextInt(MOST_EDITS); i >= 0; i--) {
      FuzzEdit edit = FuzzEdit.of(random);
      edits.add(kind.isBinary() && random.nextInt(8) > 0 ? edit.flip() : edit);
    }
    return new FuzzCase(kind, seed, edits);
  }

  /**
   * Fails unless the content is accepted, or properly rejected; keeps content that fails.
   *
   * @return the exit code
   */
  int check() {
    byte[] content = content();
    try {
      return check(kind, seed.getFileName().toString(), content);
    } catch (AssertionError | RuntimeException e) {
      throw new AssertionError("kept for the corpus as " + keep(content) + ": " + e, e);
    }
  }

  /** Checks that content is accepted (0), or rejected (2) with its place and the expectation. */
  static int check(FuzzKind kind, String name, byte[] content) {
    Cli read = assertTimeoutPreemptively(LONGEST, () -> kind.read(name, content));
    assertTrue(read.exit() == 0 || read.exit() == 2, read.exit() + ": " + read.err());
    assertFalse(read.err().contains("Exception") || read.err().contains("\tat "), read.err());
    List<String> errors = read.err().lines().filter(line -> line.startsWith("error: ")).toList();
    assertTrue(read.exit() == 0 || !errors.isEmpty(), "rejected without an error line");
    errors.forEach(line -> checkLine(kind, line));
    return read.exit();
  }

  private static void checkLine(FuzzKind kind, String line) {
    assertTrue(line.length() < LONGEST_LINE || !kind.isCommand(), line);
    boolean usage = kind == FuzzKind.COMMAND && line.endsWith(" --help");
    assertTrue(usage || line.contains("expected"), line);
    assertTrue(!kind.hasPlaces() || PLACE.matcher(line).matches(), line);
  }

  private byte[] content() {
    try {
      String text =
          Files.readString(seed, StandardCharsets.ISO_8859_1); // a character for each byte
      for (FuzzEdit edit : edits) {
        text = edit.apply(text);
      }
      return text.getBytes(StandardCharsets.ISO_8859_1);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Path keep(byte[] content) {
    try {
      String name =
          String.format(Locale.ROOT, "%08x-%s", List.of(edits).hashCode(), seed.getFileName());
      Path folder = Files.createDirectories(FOUND.resolve(kind.name().toLowerCase(Locale.ROOT)));
      return Files.write(folder.resolve(name), content);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
