package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests that comments such as "behaviour 8.3" cite sections that docs/camsim-behaviour.md has. */
class BehaviourCitationTest {
  private static final Path ROOT = Path.of(System.getProperty("hificamsim.root", ".."));
  private static final Pattern HEADING = Pattern.compile("(?m)^#{2,3} (\\d+(\\.\\d+)?)");
  private static final Pattern CITATION =
      Pattern.compile("[Bb]ehaviour \\d+(\\.\\d+)?((, | and | to )\\d+(\\.\\d+)?)*");
  private static final Pattern NUMBER = Pattern.compile("\\d+(\\.\\d+)?");

  @Test
  void everySectionCitedInSourcesExists() throws IOException {
    String text = Files.readString(ROOT.resolve("docs/camsim-behaviour.md"));
    Set<String> headings =
        HEADING.matcher(text).results().map(found -> found.group(1)).collect(Collectors.toSet());
    Set<String> dangling = new TreeSet<>();
    int cited = 0;
    for (Path source : sources()) {
      for (String number : cited(Files.readString(source))) {
        cited++;
        if (!headings.contains(number)) {
          dangling.add(source.getFileName() + ": behaviour " + number);
        }
      }
    }
    assertEquals(Set.of(), dangling);
    assertTrue(cited > 40, cited + " citations checked");
  }

  private static List<Path> sources() throws IOException {
    try (Stream<Path> modules = Files.list(ROOT)) {
      return modules
          .map(
              module ->
                  module.getFileName().toString().equals("src") ? module : module.resolve("src"))
          .filter(Files::isDirectory)
          .flatMap(BehaviourCitationTest::javaFiles)
          .toList();
    }
  }

  private static Stream<Path> javaFiles(Path folder) {
    try (Stream<Path> files = Files.walk(folder)) {
      return files.filter(file -> file.toString().endsWith(".java")).toList().stream();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the cited numbers, including citations that span two lines of a comment. */
  private static List<String> cited(String source) {
    String text = source.replaceAll("\\s*\\R\\s*(\\*|//)?\\s*", " ");
    return CITATION
        .matcher(text)
        .results()
        .map(MatchResult::group)
        .flatMap(citation -> NUMBER.matcher(citation).results().map(MatchResult::group))
        .toList();
  }
}
