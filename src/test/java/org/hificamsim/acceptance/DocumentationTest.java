package org.hificamsim.acceptance;

import static java.util.regex.Pattern.quote;
import static java.util.stream.Collectors.counting;
import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.toSet;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Tests that the map in {@code CONTRIBUTING.md} names what exists, and that links lead somewhere.
 */
class DocumentationTest {
  private static final Pattern LINK = Pattern.compile("\\]\\((?!https?:)([^)#\\s]+)");
  private static final Pattern ANCHOR = Pattern.compile("\\]\\((?!https?:)([^)#\\s]*)#([^)\\s]+)");
  private static final Pattern HEADING = Pattern.compile("(?m)^#+ +(.+)$");
  private static final Pattern CLASS = Pattern.compile("`([A-Z][A-Za-z0-9]*[a-z][A-Za-z0-9]*)`");
  private static final Pattern PICTURE = Pattern.compile(".*\\.(png|jpg|svg)");
  private static final Set<String> NO_CLASSES = Set.of("Impl", "Base");

  @Test
  void everyLinkLeadsToAFile() throws IOException {
    for (Path document : documents()) {
      List<Path> missing =
          found(LINK, document)
              .map(link -> document.resolveSibling(link.group(1)).normalize())
              .filter(file -> !Files.exists(file))
              .toList();
      assertEquals(List.of(), missing, document.toString());
    }
  }

  @Test
  void everyAnchorIsAHeading() throws IOException {
    for (Path document : documents()) {
      for (MatchResult link : found(ANCHOR, document).toList()) {
        Path target = link.group(1).isEmpty() ? document : document.resolveSibling(link.group(1));
        assertTrue(
            anchors(target).contains(link.group(2)), document + " links to #" + link.group(2));
      }
    }
  }

  /** The anchors of a page's headings, as GitHub makes them. */
  private static Set<String> anchors(Path page) throws IOException {
    return found(HEADING, page)
        .map(heading -> heading.group(1).toLowerCase(Locale.ROOT))
        .map(text -> text.replaceAll("[^\\p{L}\\p{N} _-]", "").replace(' ', '-'))
        .collect(toSet());
  }

  @Test
  void everyClassNamedInContributingExists() throws IOException {
    Set<String> classes = classes();
    assertTrue(classes.size() > 500, "found " + classes.size());
    assertEquals(
        List.of(),
        found(CLASS, Cli.ROOT.resolve("CONTRIBUTING.md"))
            .map(name -> name.group(1))
            .filter(name -> !classes.contains(name) && !NO_CLASSES.contains(name))
            .distinct()
            .toList());
  }

  @Test
  void everyClassNameHasOneMeaning() throws IOException {
    Map<String, Long> places =
        sources()
            .filter(file -> file.toString().replace('\\', '/').contains("/src/main/"))
            .map(DocumentationTest::className)
            .filter(name -> !name.equals("package-info"))
            .collect(groupingBy(name -> name, TreeMap::new, counting()));
    assertTrue(places.size() > 500, "found " + places.size());
    assertEquals(List.of(), places.keySet().stream().filter(name -> places.get(name) > 1).toList());
  }

  @Test
  void everyModuleIsOnMapAndPicture() throws IOException {
    String map = Files.readString(Cli.ROOT.resolve("CONTRIBUTING.md"));
    String picture = Files.readString(Cli.ROOT.resolve("docs/img/modules.svg"));
    for (Module module : Module.values()) {
      assertTrue(map.contains("| `" + module.folder + "` |"), module.folder);
      assertTrue(picture.contains(">" + module.folder + "</text>"), module.folder);
    }
  }

  /**
   * The script names a picture in full, or by the end of its name if a variable has the beginning.
   */
  @Test
  void oneScriptMakesEveryPicture() throws IOException {
    String script = Files.readString(Cli.ROOT.resolve("docs/make-figures"));
    try (Stream<Path> pictures = Files.list(Cli.ROOT.resolve("docs/img"))) {
      assertEquals(
          List.of(),
          pictures
              .map(picture -> picture.getFileName().toString())
              .filter(name -> PICTURE.matcher(name).matches() && !isMade(name, script))
              .toList());
    }
  }

  private static boolean isMade(String name, String script) {
    String stem = name.substring(0, name.lastIndexOf('.'));
    return script.contains(name)
        || IntStream.range(0, stem.length())
            .filter(i -> script.contains("/" + stem.substring(0, i) + "$"))
            .anyMatch(i -> script.matches("(?s).*[ =]" + quote(stem.substring(i)) + "[ ;].*"));
  }

  @Test
  void everyPageWithAPictureNamesTheScript() throws IOException {
    for (Path document : documents()) {
      String page = Files.readString(document);
      boolean shows = found(LINK, document).anyMatch(link -> PICTURE.matcher(link.group(1)).find());
      assertTrue(!shows || page.contains("docs/make-figures"), document.toString());
    }
  }

  private static Stream<MatchResult> found(Pattern pattern, Path file) throws IOException {
    return pattern.matcher(Files.readString(file)).results();
  }

  private static List<Path> documents() throws IOException {
    try (Stream<Path> docs = Files.walk(Cli.ROOT.resolve("docs"))) {
      return Stream.concat(
              Stream.of("README.md", "CONTRIBUTING.md", "CHANGELOG.md").map(Cli.ROOT::resolve),
              docs)
          .filter(file -> file.toString().endsWith(".md"))
          .toList();
    }
  }

  /** Returns every class that has its own file, including tests. */
  private static Set<String> classes() throws IOException {
    return sources().map(DocumentationTest::className).collect(toSet());
  }

  private static Stream<Path> sources() throws IOException {
    try (Stream<Path> files = Files.walk(Cli.ROOT, 12)) {
      return files.filter(file -> file.toString().endsWith(".java")).toList().stream();
    }
  }

  private static String className(Path file) {
    return file.getFileName().toString().replaceFirst("\\.java$", "");
  }
}
