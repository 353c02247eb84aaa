package org.hificamsim.profiling.report;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.FittedModel;
import org.hificamsim.profiling.measure.PipReading;

/**
 * Writes {@code report.html}, a page in one file, and its pictures as separate files for papers.
 * The resource {@code report.txt} is its template of headings, paragraphs, and names of parts in
 * braces. Your numbers come first; the tables of the thesis, with both numbers, follow.
 */
public final class FitReport {
  /** The file name of the report. */
  public static final String REPORT = "report.html";

  private static final Map<String, String> DETECTOR_FIGURES =
      Map.of("orb", "5.3", "sift", "5.5", "surf", "5.7");

  private static final Pattern PART = Pattern.compile("\\{(figure (.*)|(.*))\\}(?: (.*))?");

  /** The heading of a section that is left out if no model is recommended. */
  private static final String SCATTER_HEADING =
      "# How confidences scatter, and how good the chances are";

  /** A part of the report that depends on the fit. */
  private interface Part {
    void add() throws IOException;
  }

  private final FitResult result;
  private final OutputFolder folder;
  private final HtmlPage page;
  private final ReportFigures figures;
  private final ThesisTables tables;
  private final OwnTables ownTables;
  private final HeldOut heldOut;
  private final Claims claims;

  private FitReport(FitResult result, PipReading pip, OutputFolder folder, String title) {
    this.heldOut = HeldOut.of(pip);
    this.result = result;
    this.folder = folder;
    this.page = new HtmlPage(title);
    this.figures = new ReportFigures(result);
    this.tables = new ThesisTables(result);
    this.ownTables = new OwnTables(result);
    this.claims = new Claims(result);
  }

  /**
   * Writes all files of a fit to the folder of its data set, or none. Files of earlier models that
   * are now rejected are deleted.
   *
   * @param pip the pixels that were counted as the object's
   * @param name the name of the data set
   * @param prefix the prefix of the models' names, before a colon
   * @return the number of models written
   */
  public static int write(Path folder, FitResult result, PipReading pip, String name, String prefix)
      throws IOException {
    try (OutputFolder files = new OutputFolder(folder)) {
      int models = FittedModel.writeAll(result, files, prefix);
      new FitReport(result, pip, files, "Detection models fitted to " + name).write();
      files.commit(FittedModel.all(result).stream().map(FittedModel::file).toList());
      return models;
    }
  }

  private void write() throws IOException {
    Map<String, Part> parts = parts();
    boolean leftOut = false;
    String template =
        new String(Io.resource(FitReport.class, "report.txt"), StandardCharsets.UTF_8);
    for (String block : template.split("\n\n")) {
      String text = block.strip().replace('\n', ' ');
      if (text.startsWith("# ")) {
        leftOut = text.equals(SCATTER_HEADING) && ownTables.recommended().isEmpty();
      }
      if (!leftOut) {
        add(text, parts);
      }
    }
    claims.write(folder);
    folder.write(REPORT, page.text());
  }

  private void add(String text, Map<String, Part> parts) throws IOException {
    Matcher part = PART.matcher(text);
    if (text.startsWith("# ")) {
      page.heading(text.substring(2));
    } else if (!part.matches()) {
      page.paragraph(text);
    } else if (part.group(2) == null) {
      parts.get(part.group(3)).add();
    } else {
      String title = title(part.group(2), part.group(4));
      picture("figure-" + part.group(2), figures.figure(part.group(2), title), title + ".");
    }
  }

  /** Returns the parts that the template names in braces. */
  private Map<String, Part> parts() {
    Map<String, Part> parts = new HashMap<>();
    parts.put("headline", () -> page.paragraph(Advice.headline(result)));
    parts.put("recommendations", () -> ownTables.recommendations(page));
    parts.put("reasons", () -> Advice.reasons(result).forEach(page::paragraph));
    parts.put("unseen", () -> page.paragraph(Advice.unseen(result)));
    parts.put("shapes", () -> ownTables.shapes(page));
    parts.put("slopes", () -> ownTables.slopes(page));
    parts.put("confidences", this::confidences);
    parts.put("objects", () -> ownTables.objects(page));
    parts.put("own features", () -> ownTables.features(page));
    parts.put("models", () -> ownTables.models(page));
    parts.put("decisions", () -> page.paragraph(Advice.decisions(result)));
    parts.put("scatters", () -> ownTables.scatters(page));
    parts.put("reliability", this::reliability);
    parts.put("claims", () -> ThesisTables.claims(page, claims.all()));
    parts.put("variables", () -> tables.variables(page));
    parts.put("features", () -> tables.features(page));
    parts.put("coefficients", () -> tables.coefficients(page));
    parts.put("detectors", () -> tables.detectors(page));
    parts.put("lines", this::lines);
    parts.put("combinations", () -> tables.combinations(page));
    parts.put("camsim", () -> tables.camSim(page));
    parts.put("ball", () -> heldOut.table(page, result));
    parts.put("remark", () -> page.paragraph(heldOut.remark()));
    return parts;
  }

  private void confidences() throws IOException {
    for (String detector : result.detectors()) {
      picture(
          "objects-" + detector,
          figures.objects(detector),
          detector + ": every photo, its object by colour, and g.");
    }
  }

  private void reliability() throws IOException {
    picture(
        "reliability",
        ReportFigures.reliability(ownTables.recommended()),
        "Reliability in fifths of the unseen photos: on the line, chances are right.");
  }

  private void lines() throws IOException {
    for (String detector : result.detectors()) {
      String number = DETECTOR_FIGURES.getOrDefault(detector, detector + "-line");
      String title = title(number, detector + " on measured PIP");
      picture("figure-" + number, figures.detector(detector, title), title + ".");
    }
  }

  private static String title(String number, String caption) {
    return "Figure " + number + ": " + caption;
  }

  private void picture(String name, Figure figure, String caption) throws IOException {
    FigureFile.Drawn drawn = FigureFile.draw(figure, Optional.empty());
    drawn.write(folder, name);
    page.figure(drawn.files().get(0), caption);
  }
}
