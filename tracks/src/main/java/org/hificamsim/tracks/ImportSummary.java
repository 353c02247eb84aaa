package org.hificamsim.tracks;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.scenario.Field;

/**
 * What an import found.
 *
 * @param targets how many
 * @param samples how many were written
 * @param duration from step 0 to the last sample, seconds
 * @param interval between most samples of a target, seconds
 * @param gap the longest time between two samples of a target that is there meanwhile, seconds
 * @param gaps how many longer ones there are
 * @param longestGap of them, seconds
 * @param speeds the quartiles, metres a second
 * @param box what holds all samples, metres
 * @param ownNames whether targets are known by the names that the file has
 * @param sized of how many targets the file says the size
 * @param odd what is odd, in lines
 */
public record ImportSummary(
    int targets,
    long samples,
    double duration,
    double interval,
    double gap,
    int gaps,
    double longestGap,
    List<Double> speeds,
    Field box,
    boolean ownNames,
    long sized,
    List<String> odd) {
  /** Copies what could change. */
  public ImportSummary {
    speeds = List.copyOf(speeds);
    odd = List.copyOf(odd);
  }

  static ImportSummary of(Collector collector, Findings found, TargetNames names, double gap) {
    List<String> odd = new ArrayList<>(found.odd());
    if (collector.duplicates() > 0) {
      odd.add(
          collector.duplicates()
              + " samples are there twice and count once, the first at "
              + collector.firstDuplicate());
    }
    return new ImportSummary(
        found.targets(),
        found.samples(),
        found.duration(),
        found.interval(),
        gap,
        found.gaps(),
        found.longestGap(),
        List.of(found.speed(0.25), found.speed(0.5), found.speed(0.75)),
        found.box(),
        names.own(),
        collector.targets().stream().filter(one -> one.extent().isPresent()).count(),
        odd);
  }

  /** All of it, in lines for people. */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    lines.add(
        "%s targets, %s samples, %s s".formatted(targets, samples, Figures.rounded(duration)));
    lines.add(
        "a sample every %s s (%s a second)"
            .formatted(Figures.rounded(interval), Figures.rounded(1 / interval)));
    lines.add(
        "speeds: a quarter up to %s m/s, half up to %s, three quarters up to %s"
            .formatted(
                Figures.rounded(speeds.get(0)),
                Figures.rounded(speeds.get(1)),
                Figures.rounded(speeds.get(2))));
    lines.add(gapLine());
    lines.add(
        "places: x from %s to %s m, y from %s to %s m"
            .formatted(
                Figures.rounded(box.minX()),
                Figures.rounded(box.maxX()),
                Figures.rounded(box.minY()),
                Figures.rounded(box.maxY())));
    odd.forEach(one -> lines.add("odd: " + one));
    return lines;
  }

  private String gapLine() {
    String limit = Figures.rounded(gap) + " s";
    return gaps == 0
        ? "no gap longer than " + limit
        : "%s gaps longer than %s, up to %s s: the target is away meanwhile"
            .formatted(gaps, limit, Figures.rounded(longestGap));
  }
}
