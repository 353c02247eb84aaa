package org.hificamsim.profiling.boxes;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.hificamsim.core.Texts;
import org.hificamsim.hifi.FittedOn.Span;
import org.hificamsim.hifi.Provenance;
import org.hificamsim.hifi.boxes.BoxDetection;
import org.hificamsim.hifi.boxes.FittedBoxes;
import org.hificamsim.hifi.boxes.FoundCurve;
import org.hificamsim.hifi.model.PublishedModels;
import org.hificamsim.profiling.fit.OneStandardError;
import org.hificamsim.profiling.fit.Reliability;

/**
 * The model that fits measured boxes, and the quality of its predictions for boxes that its fit has
 * not seen.
 *
 * @param form the simplest form that is as good as the best on unseen people
 * @param curve the curve of that form, fitted to all boxes
 * @param unseenPeople for each form, the reliability of its chances for boxes of unseen people
 * @param unseenRecordings the same for unseen recordings; empty if there is one recording
 * @param unseenTenths for each form of a model, the same with a tenth of the people left out at a
 *     time
 * @param rejected whether the model is not surely better than a constant on unseen people
 */
public record BoxFit(
    MeasuredBoxes measured,
    FoundForm form,
    FoundCurve curve,
    Map<FoundForm, Reliability> unseenPeople,
    Map<FoundForm, Reliability> unseenRecordings,
    Map<FoundForm, Reliability> unseenTenths,
    boolean rejected) {
  /** Fits measured boxes. */
  public static BoxFit of(MeasuredBoxes measured) {
    UnseenChances unseen = UnseenChances.withoutPeople(measured);
    UnseenChances tenths = UnseenChances.withoutTenths(measured);
    List<FoundForm> models = FoundForm.models();
    FoundForm form =
        models.get(OneStandardError.simplest(models.stream().map(tenths::lossesByPerson).toList()));
    Map<FoundForm, Reliability> people = unseen.reliabilities();
    boolean rejected =
        OneStandardError.isAsGood(
                unseen.lossesByPerson(FoundForm.CONSTANT), unseen.lossesByPerson(form))
            || people.get(form).logLoss() >= people.get(FoundForm.CONSTANT).logLoss();
    return new BoxFit(
        measured,
        form,
        FoundFit.fit(form, measured.boxes()),
        people,
        measured.recordings().size() > 1
            ? UnseenChances.withoutRecordings(measured).reliabilities()
            : Map.of(),
        tenths.reliabilities(),
        rejected);
  }

  /** Returns the reliability of the model for boxes of people that its fit has not seen. */
  public Reliability modelReliability() {
    return unseenPeople.get(form);
  }

  /** Returns a sentence on whether the width of boxes counts in the model. */
  public String width() {
    double with = unseenTenths.get(form.withWidth(true)).logLoss();
    double without = unseenTenths.get(form.withWidth(false)).logLoss();
    return Texts.format(
        "width of the boxes: %s; log loss on unseen people %.3f with it, %.3f without",
        form.hasWidth() ? "counts" : "left out, since it does not surely help", with, without);
  }

  /** Returns the log losses of the model and of simpler ones on unseen boxes, for readers. */
  public List<String> losses() {
    return unseenRecordings.isEmpty()
        ? List.of(losses("people", unseenPeople))
        : List.of(losses("people", unseenPeople), losses("recordings", unseenRecordings));
  }

  private String losses(String parts, Map<FoundForm, Reliability> unseen) {
    return Texts.format(
        "log loss on unseen %s: %.3f; a constant %.3f, height alone %.3f, hidden share alone %.3f",
        parts,
        unseen.get(form).logLoss(),
        unseen.get(FoundForm.CONSTANT).logLoss(),
        unseen.get(FoundForm.HEIGHT).logLoss(),
        unseen.get(FoundForm.HIDDEN).logLoss());
  }

  /** Explains why the model is rejected. */
  public String refusal(String name) {
    return Texts.format(
        "%s is no detector: on people that it has not seen its log loss is %.3f, and that of a"
            + " constant %.3f; expected a surely lower one",
        name, modelReliability().logLoss(), unseenPeople.get(FoundForm.CONSTANT).logLoss());
  }

  /** Returns the model under a name. */
  public BoxDetection detection(String name) {
    List<PersonBox> boxes = measured.boxes();
    FittedBoxes fitted =
        new FittedBoxes(
            Span.of(boxes.stream().mapToDouble(PersonBox::height).toArray()),
            Span.of(boxes.stream().mapToDouble(PersonBox::hidden).toArray()),
            measured.recordings().size(),
            measured.people());
    return new BoxDetection(
        name,
        curve,
        PublishedModels.published().optics(),
        measured.falseAlarmsPerFrame(),
        Optional.of(fitted),
        provenance());
  }

  private Provenance provenance() {
    String recordings =
        measured.recordings().stream()
            .map(RecordingCounts::recording)
            .collect(Collectors.joining(", "));
    return Provenance.UNKNOWN
        .with(
            "source",
            Texts.format(
                "profile boxes, %s boxes of %s people", measured.boxes().size(), measured.people()))
        .with("recordings", recordings)
        .with("unseen", String.join("; ", losses()))
        .with("width", width());
  }
}
