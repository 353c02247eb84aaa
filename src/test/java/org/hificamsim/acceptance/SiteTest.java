package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that the documentation site has no dead links and accessible pages. */
class SiteTest {
  private static final Path PYTHON = Cli.ROOT.resolve("build/site-venv/bin/python");
  private static final Path HTML = Cli.ROOT.resolve("build/site/html");

  @BeforeAll
  static void build() throws Exception {
    assumeTrue(
        Files.exists(PYTHON), "skipped: MkDocs Material from PyPI is not here (build/site-venv)");
    Files.createDirectories(Cli.ROOT.resolve("build/site/pages"));
    Path log = Cli.ROOT.resolve("build/site/log");
    ProcessBuilder site =
        new ProcessBuilder(PYTHON.toString(), "-m", "mkdocs", "build", "--strict", "--quiet")
            .directory(Cli.ROOT.toFile())
            .redirectErrorStream(true)
            .redirectOutput(log.toFile());
    site.environment().put("NO_MKDOCS_2_WARNING", "1");
    assertEquals(0, site.start().waitFor(), () -> Cli.text(log));
  }

  @Test
  void everyDeclarationHasAnEntry() {
    assertTrue(
        Cli.text(HTML.resolve("docs/data.html")).contains("<code>expected_covered_k</code>"));
    assertTrue(
        Cli.text(HTML.resolve("docs/scenario-format.html")).contains("<code>pan_speed</code>"));
    assertTrue(Cli.text(HTML.resolve("docs/commands.html")).contains("id=\"profile-fit\""));
    assertTrue(
        Cli.text(HTML.resolve("docs/python-reference.html")).contains("id=\"hificamsim.make\""));
  }

  @ParameterizedTest
  @ValueSource(strings = {"index", "docs/data", "docs/world"})
  void pageIsAccessibleOnAllScreens(String page) {
    Browser browser = Browser.shared();
    browser.open(HTML.resolve(page + ".html").toUri().toString());
    Accessibility.checkEverywhere(browser);
  }
}
