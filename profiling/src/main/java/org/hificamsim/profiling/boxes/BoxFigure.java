package org.hificamsim.profiling.boxes;

import java.awt.Color;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.Texts;
import org.hificamsim.hifi.boxes.FoundCurve;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.LegendEntry.Mark;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.profiling.boxes.BoxBins.Bin;

/** Draws the share found over height, over hidden share, and over both. */
final class BoxFigure {
  private static final int WIDTH = 450;
  private static final int HEIGHT = 320;
  private static final int POINTS = 60;

  private final MeasuredBoxes measured;
  private final Optional<FoundCurve> model;
  private final List<Bin> heights;
  private final List<Bin> hidden = BoxBins.hidden();

  BoxFigure(MeasuredBoxes measured, Optional<FoundCurve> model) {
    this.measured = measured;
    this.model = model;
    this.heights = BoxBins.heights(measured.boxes());
  }

  Figure figure() {
    return new Figure(
        "Share of people found",
        "Dots: measured, with 95 % intervals over people; the first panel has people who are not"
            + " hidden. The last panel has a number for each cell with a box: the share in per"
            + " cent.",
        legend(),
        List.of(overHeight(), overHidden(), overBoth()),
        3,
        WIDTH,
        HEIGHT);
  }

  private List<LegendEntry> legend() {
    List<LegendEntry> recordings =
        IntStream.range(0, measured.recordings().size())
            .mapToObj(
                i ->
                    new LegendEntry(
                        measured.recordings().get(i).recording(), Palette.line(i), Mark.DOT))
            .toList();
    return model.isEmpty()
        ? recordings
        : Stream.concat(
                recordings.stream(), Stream.of(new LegendEntry("model", Palette.BLACK, Mark.LINE)))
            .toList();
  }

  private XyPanel overHeight() {
    double most = heights.get(heights.size() - 1).to();
    XyPanel panel = new XyPanel("not hidden", "height, pixels", "found").x(0, most).y(0, 1);
    double least = heights.get(0).from();
    curve(panel, Math.max(1, least), most, pixels -> model.orElseThrow().found(pixels, 0));
    Bin notHidden = hidden.get(0);
    List<PersonBox> boxes =
        measured.boxes().stream().filter(box -> notHidden.contains(box.hidden())).toList();
    dots(panel, boxes, heights, PersonBox::height, bin -> (bin.from() + bin.to()) / 2);
    return panel;
  }

  private XyPanel overHidden() {
    XyPanel panel = new XyPanel("all heights", "hidden share", "found").x(0, 1).y(0, 1);
    double median = median();
    curve(panel, 0, 1, share -> model.orElseThrow().found(median, share));
    dots(panel, measured.boxes(), hidden, PersonBox::hidden, Bin::middle);
    return panel;
  }

  private double median() {
    double[] sorted = measured.boxes().stream().mapToDouble(PersonBox::height).sorted().toArray();
    return sorted[sorted.length / 2];
  }

  private void curve(XyPanel panel, double from, double to, DoubleUnaryOperator value) {
    if (model.isPresent()) {
      double[] x =
          IntStream.rangeClosed(0, POINTS)
              .mapToDouble(i -> from + (to - from) * i / POINTS)
              .toArray();
      panel.straight(new Curve(x, DoubleStream.of(x).map(value).toArray()), Palette.BLACK);
    }
  }

  private void dots(
      XyPanel panel,
      List<PersonBox> boxes,
      List<Bin> bins,
      ToDoubleFunction<PersonBox> quantity,
      ToDoubleFunction<Bin> position) {
    for (int i = 0; i < measured.recordings().size(); i++) {
      String recording = measured.recordings().get(i).recording();
      Color color = Palette.line(i);
      for (Bin bin : bins) {
        FoundShare share =
            FoundShare.of(
                boxes.stream()
                    .filter(box -> box.recording().equals(recording))
                    .filter(box -> bin.contains(quantity.applyAsDouble(box)))
                    .toList());
        if (share.boxes() > 0) {
          double x = position.applyAsDouble(bin);
          panel.interval(x, share.low(), share.high(), color);
          panel.dots(new Curve(new double[] {x}, new double[] {share.found()}), color);
        }
      }
    }
  }

  /** Draws a cell for each range of height and hidden share, the darker the more were found. */
  private XyPanel overBoth() {
    XyPanel panel =
        new XyPanel("found, per cent", "height, pixels", "hidden share")
            .edges(edges(heights, "%.0f"), edges(hidden, "%.2f"));
    for (int column = 0; column < heights.size(); column++) {
      for (int row = 0; row < hidden.size(); row++) {
        cell(panel, column, row);
      }
    }
    return panel;
  }

  /** Returns the ends of ranges, the first of which begins at 0 or where its values do. */
  private static List<String> edges(List<Bin> bins, String form) {
    double first = Math.max(0, bins.get(0).from());
    return DoubleStream.concat(DoubleStream.of(first), bins.stream().mapToDouble(BoxFigure::end))
        .mapToObj(edge -> Texts.format(form, edge))
        .toList();
  }

  private static double end(Bin bin) {
    return bin.label().endsWith("px") ? bin.to() : Math.min(1, bin.to());
  }

  private void cell(XyPanel panel, int column, int row) {
    FoundShare share =
        FoundShare.of(
            measured.boxes().stream()
                .filter(box -> heights.get(column).contains(box.height()))
                .filter(box -> hidden.get(row).contains(box.hidden()))
                .toList());
    if (share.boxes() > 0) {
      panel.cell(column, row, Palette.BLUE, share.found(), Math.round(100 * share.found()) + "");
    }
  }
}
