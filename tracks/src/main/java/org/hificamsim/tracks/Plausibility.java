package org.hificamsim.tracks;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.InputException;

/**
 * Checks an import for signs that a file was not read as its author meant it. Each sign is a
 * sentence that names the likely cause and the setting that fixes it.
 */
public final class Plausibility {
  private final List<String> doubts = new ArrayList<>();
  private final List<String> faults = new ArrayList<>();

  private Plausibility() {}

  /** Checks the files, the tracks, the walls and the draft cameras of an import. */
  public static Plausibility of(ImportSummary summary, TrackedSite site) {
    Plausibility signs = of(summary.notes());
    summary.motionSigns().addTo(signs);
    new WallSigns(summary, site.obstacles()).addTo(signs);
    site.blindDraft().ifPresent(signs::doubt);
    return signs;
  }

  /** Checks the files of a recording. */
  static Plausibility of(ReadingNotes notes) {
    Plausibility signs = new Plausibility();
    notes.addTo(signs);
    return signs;
  }

  /** Checks the walls and the draft cameras of a site without a recording. */
  public static Plausibility of(DrawnSite site) {
    Plausibility signs = new Plausibility();
    new SiteSigns(site).addTo(signs);
    site.blindDraft().ifPresent(signs::doubt);
    return signs;
  }

  /** Adds a sign that the result may be wrong. */
  void doubt(String sentence) {
    doubts.add(sentence);
  }

  /**
   * Adds a sign that the result is useless.
   *
   * @param problem what was found, and its likely cause
   * @param cure what the user should do
   */
  void fault(String problem, String cure) {
    faults.add(problem + ", expected " + cure);
  }

  /**
   * Returns all signs, in sentences that may contain {@link
   * org.hificamsim.core.NamedSetting#setting names of settings}.
   *
   * @param forced whether signs that the result is useless are no errors
   * @throws InputException if the result is useless
   */
  public List<String> signs(boolean forced) {
    if (!forced && !faults.isEmpty()) {
      throw new InputException(faults.get(0) + ", or " + setting("force_reading"));
    }
    List<String> signs = new ArrayList<>(faults);
    signs.addAll(doubts);
    return signs;
  }
}
