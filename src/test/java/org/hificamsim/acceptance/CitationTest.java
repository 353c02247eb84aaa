package org.hificamsim.acceptance;

import static java.util.stream.Collectors.toCollection;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/**
 * Tests that {@code CITATION.cff} agrees with the changelog, and the paper with its bibliography.
 */
class CitationTest {
  private static final Path CHANGELOG = Cli.ROOT.resolve("CHANGELOG.md");

  @Test
  void namesLastReleaseAndItsDate() throws IOException {
    String released = found("CHANGELOG.md", "(?m)^## ([0-9.]+), ");
    assertEquals(released, found("CITATION.cff", "(?m)^version: (\\S+)$"));
    String date = found("CHANGELOG.md", "(?m)^## " + Pattern.quote(released) + ", (\\S+)$");
    assertEquals(date, found("CITATION.cff", "(?m)^date-released: '(\\S+)'$"));
  }

  @Test
  void buildVersionFollowsLastRelease() throws IOException {
    String built = found("build.gradle", "version = '([^']+)'");
    String released = found("CHANGELOG.md", "(?m)^## ([0-9.]+), ");
    assertEquals(Files.readString(CHANGELOG).contains("## Unreleased"), !built.equals(released));
    assertTrue(built.equals(released) || built.endsWith("-dev"), built);
  }

  @Test
  void hasRequiredKeys() throws IOException {
    String cff = Files.readString(Cli.ROOT.resolve("CITATION.cff"));
    for (String key : List.of("cff-version: 1.2.0", "message: ", "title: ", "authors:")) {
      assertTrue(cff.lines().anyMatch(line -> line.startsWith(key)), key);
    }
  }

  @Test
  void paperCitesWholeBibliography() throws IOException {
    String paper = Files.readString(Cli.ROOT.resolve("paper/paper.md"));
    String bibliography = Files.readString(Cli.ROOT.resolve("paper/paper.bib"));
    assertEquals(keys("(?m)^@\\w+\\{(\\w+),", bibliography), keys("(?:[\\[ ]|^)@(\\w+)", paper));
    for (String picture : keys("\\]\\((\\.\\./[^)]+)\\)", paper)) {
      assertTrue(Files.exists(Cli.ROOT.resolve("paper").resolve(picture)), picture);
    }
  }

  private static Set<String> keys(String pattern, String text) {
    return Pattern.compile(pattern)
        .matcher(text)
        .results()
        .map(found -> found.group(1))
        .collect(toCollection(TreeSet::new));
  }

  private static String found(String file, String pattern) throws IOException {
    Matcher matcher = Pattern.compile(pattern).matcher(Files.readString(Cli.ROOT.resolve(file)));
    assertTrue(matcher.find(), file);
    return matcher.group(1);
  }
}
