package org.hificamsim.tracks;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The targets of one of a recording's files.
 *
 * @param file the path of the file
 * @param haveIds whether targets of the same name in another file may be the same ones
 * @param secondsPerTick the unit of the targets' times
 * @param notes the oddities of the file
 */
record FileTargets(
    Path file,
    boolean haveIds,
    Collection<RecordedTarget> targets,
    double secondsPerTick,
    ReadingNotes notes) {

  /**
   * Combines the targets of several files. Targets with the same id are one target, which comes and
   * goes, unless an id is in two files at the same time: then each file has its own ids.
   */
  static RecordedTargets combine(List<FileTargets> files) {
    ReadingNotes notes = new ReadingNotes();
    files.forEach(file -> notes.combine(file.notes));
    if (files.size() == 1) {
      FileTargets single = files.get(0);
      if (!single.haveIds && single.targets.size() == 1) {
        notes.addLine("ids: none, all samples are of one target");
      }
      return new RecordedTargets(single.targets, single.secondsPerTick, notes);
    }
    boolean idsAreShared = !overlap(files);
    if (files.stream().anyMatch(FileTargets::haveIds)) {
      notes.addLine(
          idsAreShared
              ? "ids: the same in all files"
              : "ids: each file has its own, because two have the same at the same time");
    }
    Map<String, List<RecordedTarget>> byName = new LinkedHashMap<>();
    for (int i = 0; i < files.size(); i++) {
      FileTargets file = files.get(i);
      for (RecordedTarget target : file.targets) {
        String name = idsAreShared && file.haveIds ? target.name() : file.ownName(target, i);
        byName
            .computeIfAbsent(name, key -> new ArrayList<>())
            .add(target.renamed(name, file.secondsPerTick));
      }
    }
    return new RecordedTargets(
        byName.values().stream().map(FileTargets::inOrder).toList(), 1, notes);
  }

  /** Whether two files have the same id at the same time. */
  private static boolean overlap(List<FileTargets> files) {
    Map<String, List<double[]>> spans = new HashMap<>();
    for (FileTargets file : files) {
      for (RecordedTarget target : file.haveIds ? file.targets : List.<RecordedTarget>of()) {
        double first = target.firstTime() * file.secondsPerTick;
        double last = target.lastTime() * file.secondsPerTick;
        List<double[]> others = spans.computeIfAbsent(target.name(), key -> new ArrayList<>());
        if (others.stream().anyMatch(other -> first <= other[1] && last >= other[0])) {
          return true;
        }
        others.add(new double[] {first, last});
      }
    }
    return false;
  }

  private String ownName(RecordedTarget target, int index) {
    return targets.size() == 1 && !haveIds
        ? file.getFileName() + " (" + (index + 1) + ")"
        : file.getFileName() + " (" + (index + 1) + ") " + target.name();
  }

  private static RecordedTarget inOrder(List<RecordedTarget> parts) {
    List<RecordedTarget> sorted = new ArrayList<>(parts);
    sorted.sort(Comparator.comparingDouble(RecordedTarget::firstTime));
    RecordedTarget joined = sorted.get(0);
    sorted.stream().skip(1).forEach(joined::append);
    return joined;
  }
}
