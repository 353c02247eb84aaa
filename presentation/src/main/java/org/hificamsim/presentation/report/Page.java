package org.hificamsim.presentation.report;

import java.nio.charset.StandardCharsets;
import java.util.Base64;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.presentation.figures.SpokenNames;
import org.hificamsim.presentation.plot.Palette;

/**
 * A page that needs no other file: it contains its script, style, data and uPlot. Its content
 * security policy lets it run only these scripts and load nothing, so that names in the data cannot
 * change what it does.
 *
 * @param title the title of the window
 * @param module the script of the page
 * @param function the function that the module exports and that is called with the page's element
 *     and the data
 * @param data JSON
 * @param connections the value of {@code connect-src}: {@code 'none'} for a file
 */
public record Page(String title, String module, String function, String data, String connections) {
  private static final String PAGE =
      """
<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="%s">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>%s</title>
<link rel="icon" href="data:,">
<style>%s</style>
</head>
<body>
<main id="page"><noscript>This page is drawn by a script, which your browser does not run.</noscript></main>
<script type="application/json" id="data">%s</script>
<!-- uPlot %s -->
<script>%s</script>
<script type="module">%s</script>
</body>
</html>
""";

  /** Creates a page that connects to nothing. */
  public Page(String title, String module, String function, String data) {
    this(title, module, function, data, "'none'");
  }

  /** The page as HTML. */
  public String html() {
    String style =
        Scripts.text("uplot/uPlot.min.css") + Palette.style() + Scripts.text("style.css");
    String plot = Scripts.text("uplot/uPlot.iife.min.js");
    String script = Scripts.bundle(module) + spokenNames(data) + start();
    return PAGE.formatted(
        policy(style, plot, script),
        Place.escaped(escaped(title), "\\"),
        style,
        Scripts.escaped(Place.escaped(data, "\\\\")),
        Scripts.text("uplot/LICENSE"),
        plot,
        script);
  }

  private static String spokenNames(String data) {
    String names = Scripts.escaped(SpokenNames.json(data));
    return "const SPOKEN = new Map(Object.entries(%s));\n".formatted(names);
  }

  private String start() {
    return Scripts.variable("dom.js")
        + ".start("
        + Scripts.variable(module)
        + "."
        + function
        + ");\n";
  }

  private String policy(String style, String... scripts) {
    StringBuilder policy =
        new StringBuilder("default-src 'none'; base-uri 'none'; form-action 'none'");
    policy.append("; img-src data: blob:; connect-src ").append(connections);
    policy.append("; style-src ").append(hash(style)).append("; script-src");
    for (String script : scripts) {
      policy.append(' ').append(hash(script));
    }
    return policy.toString();
  }

  private static String hash(String text) {
    byte[] digest = Sha256.bytes(text.getBytes(StandardCharsets.UTF_8));
    return "'sha256-" + Base64.getEncoder().encodeToString(digest) + "'";
  }

  private static String escaped(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
  }
}
