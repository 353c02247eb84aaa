package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The parts of a document that follow from the code: each stands between {@code <!-- NAME -->} and
 * {@code <!-- end -->}.
 */
final class GeneratedParts {
  private static final Pattern PART =
      Pattern.compile("(<!-- (\\S+) -->\n).*?(<!-- end -->\n)", Pattern.DOTALL);

  private GeneratedParts() {}

  /**
   * Checks that a document has these parts and no others, as they are to be. Writes the document as
   * it is to be where it is not so.
   *
   * @param document its path in the project
   * @param parts what is to stand in each, by its name
   */
  static void check(String document, Map<String, String> parts) throws IOException {
    String text = Files.readString(Cli.ROOT.resolve(document));
    assertEquals(
        new TreeSet<>(parts.keySet()),
        new TreeSet<>(PART.matcher(text).results().map(part -> part.group(2)).toList()),
        "the parts that are generated between <!-- NAME --> and <!-- end --> in " + document);
    String wanted =
        PART.matcher(text)
            .replaceAll(
                part ->
                    Matcher.quoteReplacement(
                        part.group(1) + parts.get(part.group(2)) + part.group(3)));
    Path written = Cli.ROOT.resolve("build").resolve(document);
    if (!wanted.equals(text)) {
      Files.createDirectories(written.getParent());
      Files.writeString(written, wanted);
    }
    assertEquals(
        wanted,
        text,
        document + " does not say what the code does: cp build/" + document + " docs");
  }
}
