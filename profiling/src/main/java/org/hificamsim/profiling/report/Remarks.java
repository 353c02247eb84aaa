package org.hificamsim.profiling.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.hifi.feature.PowerLawAbstraction;
import org.hificamsim.profiling.fit.Coefficient;
import org.hificamsim.profiling.fit.Counted;
import org.hificamsim.profiling.fit.FeatureResult;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.LineFit;
import org.hificamsim.profiling.measure.PipReading;

/** Paragraphs on how your numbers compare with the published ones, worded by the data. */
final class Remarks {
  private static final double NOTABLE_R2 = 0.05;
  private static final String TIMES =
      "Times are those of the shipped lab models of the same kind, by JMH on one busy machine,"
          + " about 10 ns of each the benchmark's own; yours were not timed. Detections are"
          + " tabulated before a run, so that a slow model costs start-up and not steps.";

  private final FitResult result;
  private final HeldOut heldOut;

  Remarks(FitResult result, HeldOut heldOut) {
    this.result = result;
    this.heldOut = heldOut;
  }

  /** On Table 4.1. */
  String variables() {
    double mean = Moments.of(result.measuredPip()).mean();
    return said(
        "%s used (published: 426). Mean PIP is %.3f, %s the published 0.054. %s",
        photos(),
        mean,
        compared(mean, 0.054, 0.01),
        "The published mean and least zoom, 0.046 m and 0.015 m, do not go with the six focal"
            + " lengths from 0.010 m that section 3.5 names; yours are what the data set says.");
  }

  /** On Table 4.2 and the equations of chapter 4. */
  String features() {
    List<String> sentences = new ArrayList<>();
    for (FeatureResult f : result.features()) {
      Map<String, String> published = PublishedTables.feature(f.name());
      if (!published.isEmpty()) {
        double theirs = Double.parseDouble(published.get("r2_best"));
        double yours = f.scores().r2();
        sentences.add(
            said(
                "%s: R2 %.2f, %s the published %.2f.",
                f.name(), yours, compared(yours, theirs, NOTABLE_R2), theirs));
      }
    }
    sentences.add(why());
    return String.join(" ", sentences);
  }

  /** On Eqs 5.2 to 5.4. */
  String detectors() {
    List<String> sentences = new ArrayList<>();
    for (String detector : result.detectors()) {
      Map<String, String> published = PublishedTables.groundTruthLine(detector);
      LineFit line = result.line(detector, FitResult.GROUND_TRUTH);
      if (!published.isEmpty()) {
        double slope = Double.parseDouble(published.get("slope"));
        sentences.add(
            said(
                "%s: slope %s, published %.2f, which lies %s your interval.",
                detector,
                CellText.interval(line.slope()),
                slope,
                inside(line.slope(), slope) ? "in" : "outside"));
      }
    }
    sentences.add(
        "A slope depends on the template's resolution and texture, the share of the image's"
            + " features that a cluttered background takes, and the implementation of the detector;"
            + " none of these is published.");
    return String.join(" ", sentences);
  }

  /** On Table 6.1. */
  String combinations() {
    List<String> sentences = new ArrayList<>();
    String best = "";
    double most = Double.NEGATIVE_INFINITY;
    int higher = 0;
    int rows = 0;
    for (String detector : result.detectors()) {
      for (FeatureResult f : result.features()) {
        double yours = result.line(detector, f.name()).r2();
        Map<String, String> published = PublishedTables.line(detector, f.name());
        if (yours > most) {
          most = yours;
          best = detector + "-" + f.name();
        }
        if (!published.isEmpty()) {
          rows++;
          higher += yours > Double.parseDouble(published.get("r2")) ? 1 : 0;
        }
      }
    }
    if (!best.isEmpty()) {
      sentences.add(
          said(
              "The best line of these is that of %s with R2 %.3f; published, orb-svr-rbf with"
                  + " 0.71.",
              best, most));
    }
    if (rows > 0) {
      sentences.add(
          said("Yours is higher in %d of %s.", higher, Counted.of(rows, "published row")));
    }
    sentences.add(saturation());
    sentences.add(
        "The lines are fitted on PIP = min(1, 10^-f), with every f fitted on all photos; the"
            + " thesis's f is the one of its best fold.");
    return String.join(" ", sentences);
  }

  /** On Table 6.2. */
  String camSim() {
    List<String> sentences = new ArrayList<>();
    for (String detector : result.detectors()) {
      double camSim = result.line(detector, FitResult.CAMSIM).r2();
      double lin = result.line(detector, "lin").r2();
      sentences.add(
          said(
              "%s: CamSim's confidence captures %.0f%%, g(f_lin) %.0f%% (published: %s and %s).",
              detector,
              100 * camSim,
              100 * lin,
              percent(PublishedTables.camSimLine(detector)),
              percent(PublishedTables.line(detector, "lin"))));
    }
    sentences.add(
        "It looks at the zoom alone, so that size and distance, which move PIP as much, are"
            + " lost to it.");
    return String.join(" ", sentences);
  }

  /** On Figure 3.7. */
  String ball() {
    HeldOut.Check best =
        heldOut.checks(result).stream()
            .min(Comparator.comparingDouble(HeldOut.Check::rmse))
            .orElseThrow();
    return said(
        "In these photos PIP grows with the focal length to the power %.2f, not 2 as a pinhole"
            + " camera's would, so that no f that is true to optics fits them all. Nearest comes"
            + " %s, off by a factor of %.1f (root mean square). The ball's size is not published"
            + " and taken as %.2f m; another one shifts every f alike and does not change the"
            + " power. %s",
        heldOut.exponent(), best.f(), Math.pow(10, best.rmse()), HeldOut.BALL, counted());
  }

  private String counted() {
    return heldOut.reading() == PipReading.RECTANGLE
        ? "PIP counts the rectangle around the ball, in the thesis and in these measurements."
        : "The thesis counts the rectangle around the ball, these measurements the object alone:"
            + " they are held against the disc in it, pi/4 of the rectangle (0.10 less in log10)."
            + " pinhole predicts the square of side q, whatever was counted. profile measure --pip"
            + " rectangle counts as the thesis does.";
  }

  /** On the ladder. */
  String ladder(List<FidelityLadder.Step> steps, String detector) {
    Optional<FidelityLadder.Step> best =
        steps.stream()
            .filter(s -> Double.isFinite(s.unseen().r2()))
            .max(Comparator.comparingDouble(s -> s.unseen().r2()));
    return best.map(step -> ladder(steps, step, detector)).orElse("") + TIMES;
  }

  private static String ladder(
      List<FidelityLadder.Step> steps, FidelityLadder.Step best, String detector) {
    List<String> near =
        steps.stream()
            .filter(s -> !s.equals(best) && s.unseen().r2() > best.unseen().r2() - NOTABLE_R2)
            .map(s -> said("%s (%.3f)", s.model(), s.unseen().r2()))
            .toList();
    return said(
        "Of the %s confidence of what they have not seen, %s tells most (R2 %.3f)%s. ",
        detector,
        best.model(),
        best.unseen().r2(),
        near.isEmpty()
            ? "; none other comes within 0.05"
            : "; within 0.05 of it: " + String.join(", ", near));
  }

  private String photos() {
    long count = result.measurements().size();
    return Counted.of(count, "photo") + (count == 1 ? " was" : " were");
  }

  /** Why the fits of f differ: how close the data are to the pinhole law. */
  private String why() {
    FeatureResult power = result.feature("power");
    if (!(power.fit().f() instanceof PowerLawAbstraction law)) {
      return "";
    }
    return said(
        "These photos follow PIP ~ z^%.2f q^%.2f d^-%.2f with R2 %.3f (a pinhole camera has 2, 2"
            + " and 2); the thesis's own photos of Figure 3.7 have z^%.2f. %s A law that multiplies"
            + " has logarithms that add up, so that a line in the raw z, q and d bends away at both"
            + " ends, the RBF kernel follows the bend and the power law is straight.",
        law.a(),
        law.b(),
        law.e(),
        power.scores().r2(),
        heldOut.exponent(),
        law.a() > heldOut.exponent() + 0.2
            ? "Zoom therefore moves your PIP more than theirs."
            : "Zoom moves both alike.");
  }

  /** How far f_lin runs into its ceiling. */
  private String saturation() {
    long full = java.util.Arrays.stream(result.predictedPip("lin")).filter(p -> p >= 1).count();
    return full == 0
        ? "No prediction of f_lin reaches the ceiling of 1."
        : said(
            "f_lin predicts a full image for %s, whose largest PIP is in truth %.2f: that"
                + " caps its R2.",
            Counted.of(full, "photo"), Moments.of(result.measuredPip()).max());
  }

  private static boolean inside(Coefficient c, double value) {
    return value >= c.low() && value <= c.high();
  }

  private static String percent(Map<String, String> row) {
    return row.isEmpty() ? "-" : Math.round(100 * Double.parseDouble(row.get("r2"))) + "%";
  }

  private static String compared(double yours, double theirs, double notable) {
    return yours > theirs + notable ? "above" : yours < theirs - notable ? "below" : "near";
  }

  private static String said(String sentence, Object... values) {
    return String.format(Locale.ROOT, sentence, values);
  }
}
