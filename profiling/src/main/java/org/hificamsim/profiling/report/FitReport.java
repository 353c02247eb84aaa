package org.hificamsim.profiling.report;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.Recommendation;
import org.hificamsim.profiling.measure.PipReading;
import org.hificamsim.profiling.trial.Trials;

/**
 * Writes {@code report.html}, a page in one file, and its pictures once more as files for papers.
 * Your numbers come first; the thesis's tables, with both, follow.
 */
public final class FitReport {
  private static final Map<String, String> DETECTOR_FIGURES =
      Map.of("orb", "5.3", "sift", "5.5", "surf", "5.7");

  private final FitResult result;
  private final List<Trials> trials;
  private final OutputFolder folder;
  private final HtmlPage page;
  private final ReportFigures figures;
  private final ThesisTables tables;
  private final OwnTables own;
  private final HeldOut heldOut;

  private FitReport(
      FitResult result, List<Trials> trials, PipReading pip, OutputFolder folder, String title) {
    this.trials = trials;
    this.heldOut = HeldOut.of(pip);
    this.result = result;
    this.folder = folder;
    this.page = new HtmlPage(title);
    this.figures = new ReportFigures(result);
    this.tables = new ThesisTables(result);
    this.own = new OwnTables(result);
  }

  /**
   * Writes the report on a data set of this name into a folder.
   *
   * @param trials how the recommended models do in the simulation
   * @param pip how its PIP was counted
   */
  public static void write(
      FitResult result, List<Trials> trials, PipReading pip, String name, OutputFolder folder)
      throws IOException {
    new FitReport(result, trials, pip, folder, "Detection models fitted to " + name).write();
  }

  private void write() throws IOException {
    advice();
    shapes();
    ownFeatures();
    models();
    scatters();
    simulation();
    data();
    page.heading("Beside the thesis");
    page.paragraph(
        "From here on the thesis's own methods, lines for g and all photos for every fit, on your"
            + " photos; its numbers stand in brackets or beside yours where it has any.");
    claims();
    variables();
    features();
    detectors();
    combinations();
    camSim();
    ball();
    folder.write(FitFolder.REPORT, page.text());
  }

  private void advice() {
    page.paragraph(Advice.headline(result));
    own.recommendations(page);
    Recommendation first = Advice.first(result);
    Recommendation.all(result).stream()
        .filter(one -> !one.detector().equals(first.detector()))
        .forEach(one -> page.paragraph(one.sentence()));
    page.paragraph(Recommendation.lens(result));
    trials.forEach(one -> page.paragraph(one.sentence()));
    page.paragraph(Advice.unseen(result));
  }

  private void shapes() throws IOException {
    page.heading("g: confidence by the share of the image");
    own.shapes(page);
    page.paragraph(Advice.SHAPES);
    own.slopes(page);
    page.paragraph(Advice.SLOPES);
    for (String detector : result.detectors()) {
      byte[] png = figures.objects(detector);
      picture("objects-" + detector + ".png", png);
      page.figure(png, detector + ": every photo, its object by colour; g, and its 95% band.");
    }
    page.heading("Objects");
    own.objects(page);
    page.paragraph(Advice.OBJECTS);
  }

  private void ownFeatures() {
    page.heading("f: the share of the image by size, distance and focal length");
    own.features(page);
    page.paragraph(Advice.FEATURES);
  }

  private void models() throws IOException {
    page.heading("Models g(f): the fidelity ladder");
    List<FidelityLadder.Step> steps =
        result.detectors().stream()
            .flatMap(detector -> FidelityLadder.of(result, detector).stream())
            .toList();
    OwnTables.models(page, steps);
    page.paragraph(Advice.decisions(result));
    page.paragraph(Advice.TIMES);
    String first = Advice.first(result).detector();
    byte[] png =
        ReportFigures.ladder(
            steps.stream().filter(step -> step.detector().equals(first)).toList(), first);
    picture("ladder.png", png);
    page.figure(png, "The fidelity ladder: what each step costs and buys.");
  }

  private void scatters() throws IOException {
    if (!own.recommended().isEmpty()) {
      page.heading("How confidences scatter, and how good the chances are");
      own.scatters(page);
      page.paragraph(Advice.SCATTERS);
      byte[] png = ReportFigures.reliability(own.recommended());
      picture("reliability.png", png);
      page.figure(
          png, "Reliability in fifths of the unseen photos: on the line, chances are right.");
    }
  }

  private void simulation() {
    if (!trials.isEmpty()) {
      page.heading("In the simulation");
      SimulationTables tables = new SimulationTables(trials);
      tables.photos(page);
      page.paragraph(SimulationTables.PHOTOS);
      tables.distances(page);
      tables.scenes(page);
      page.paragraph(SimulationTables.SCENES);
    }
  }

  private void data() throws IOException {
    page.heading("The photos");
    figure("4.1", figures.variables(), "the distributions of the variables");
    figure("4.2", figures.transformation(), "the density of PIP before and after -log10");
  }

  private void claims() throws IOException {
    Claims claims = new Claims(result);
    page.heading("What chapters 4 to 6 say, judged on these photos");
    ThesisTables.claims(page, claims.all());
    page.paragraph(
        "Shares are R2, reproduced when at most 0.05 away. The photos are not the thesis's, which"
            + " are not published.");
    claims.write(folder);
  }

  private void variables() {
    page.heading("The variables (Table 4.1)");
    tables.variables(page);
    page.paragraph(
        "The published mean and least zoom, 0.046 m and 0.015 m, do not go with the six focal"
            + " lengths from 0.010 m that section 3.5 names; yours are what the data set says.");
  }

  private void features() throws IOException {
    page.heading("Feature abstractions f (Table 4.2, Figures 4.3 to 4.7)");
    tables.features(page);
    page.paragraph(
        "A law that multiplies has logarithms that add up, so that a line in the raw z, q and d"
            + " bends away at both ends, the RBF kernel follows the bend and the power law is"
            + " straight.");
    tables.coefficients(page);
    figure("4.3", figures.transformedRegression(), "linear regression before and after -log10");
    figure("4.4", figures.residuals(List.of("lin")), "held-out residuals of lin");
    figure("4.5", figures.residuals(List.of("sr")), "held-out residuals of sr");
    List<String> vectors = List.of("svr-lin", "svr-rbf");
    figure("4.7", figures.residuals(vectors), "held-out residuals of support vectors");
  }

  private void detectors() throws IOException {
    page.heading("Detectors on ground-truth PIP (Eqs 5.2 to 5.4, Figures 5.3, 5.5 and 5.7)");
    tables.detectors(page);
    page.paragraph(
        "A slope depends on the template's resolution and texture, the share of the image's"
            + " features that a cluttered background takes, and the implementation of the detector;"
            + " none of these is published.");
    for (String detector : result.detectors()) {
      String number = DETECTOR_FIGURES.getOrDefault(detector, detector + "-line");
      figure(number, figures.detector(detector), detector + " on measured PIP");
    }
  }

  private void combinations() throws IOException {
    page.heading("Detectors on predicted PIP (Table 6.1, Figure 6.1)");
    tables.combinations(page);
    page.paragraph(
        "The lines are fitted on PIP = min(1, 10^-f), with every f fitted on all photos; the"
            + " thesis's f is the one of its best fold.");
    figure("6.1", figures.combinations(), "detectors on predicted PIP");
  }

  private void camSim() throws IOException {
    page.heading("CamSim's standard confidence (Table 6.2, Figure 6.2)");
    tables.camSim(page);
    page.paragraph(
        "It looks at the zoom alone, so that size and distance, which move PIP as much, are lost to"
            + " it.");
    figure("6.2", figures.camSim(), "detectors on CamSim's standard confidence");
  }

  private void ball() {
    page.heading("Held out: six real photos (Figure 3.7)");
    heldOut.table(page, result);
    page.paragraph(heldOut.remark());
  }

  private void figure(String number, byte[] png, String caption) throws IOException {
    String file = "figure-" + number + ".png";
    picture(file, png);
    page.figure(png, "Figure " + number + ": " + caption + ".");
  }

  private void picture(String file, byte[] png) throws IOException {
    folder.write(file, png);
  }
}
