package org.hificamsim.core.scenario;

import java.util.List;
import java.util.function.Function;

/** Reads events, each as its kind is declared. */
final class EventReader {
  /** What all kinds have in common. */
  static final Element<ScenarioEvent> ELEMENT =
      Element.<ScenarioEvent>of(
              "event",
              """
              Something that happens at the beginning of a step.
              timestep: the step, from 0
              participant: to whom it happens; `grc` is CamSim's global registration
              event: what happens
              """)
          .holds(TargetSpec.ADDED.content());

  static final Property<ScenarioEvent, Integer> STEP = ELEMENT.required("timestep", Type.whole(0));
  static final Property<ScenarioEvent, String> PARTICIPANT =
      ELEMENT.required("participant", oneOf(ScenarioEvent.kinds(), EventKind::participant));
  static final Property<ScenarioEvent, String> HAPPENING =
      ELEMENT.required("event", oneOf(ScenarioEvent.kinds(), EventKind::happening));

  private final CameraReader cameras;
  private final TargetReader targets;

  EventReader(CameraReader cameras, TargetReader targets) {
    this.cameras = cameras;
    this.targets = targets;
  }

  private static Type<String> oneOf(
      List<EventKind<?, ?>> kinds, Function<EventKind<?, ?>, String> word) {
    return Type.word(kinds.stream().map(word).distinct().toList());
  }

  /** Reads one. */
  ScenarioEvent event(XmlElement xml) {
    Attributes<ScenarioEvent> head = new Attributes<>(xml, ELEMENT);
    int step = head.get(STEP);
    String participant = head.get(PARTICIPANT);
    List<EventKind<?, ?>> its =
        ScenarioEvent.kinds().stream()
            .filter(one -> one.participant().equals(participant))
            .toList();
    if (head.has(HAPPENING)) {
      head.narrow("event", oneOf(its, EventKind::happening));
    }
    String happening = head.get(HAPPENING);
    return its.stream()
        .filter(one -> one.happening().equals(happening))
        .findFirst()
        .map(kind -> event(step, kind, xml))
        .orElseThrow();
  }

  private <E extends ScenarioEvent, B> E event(int step, EventKind<E, B> kind, XmlElement xml) {
    return kind.make().apply(step, body(kind.body(), xml));
  }

  /** Who comes by an event is read as who is there from the start. */
  @SuppressWarnings("unchecked") // a spec of its type
  private <B> Spec<B> body(Element<B> body, XmlElement xml) {
    if (body.type() == CameraSpec.class) {
      return (Spec<B>) cameras.camera(xml, CameraSpec.ADDED);
    }
    if (body.type() == TargetSpec.class) {
      return (Spec<B>) targets.added(xml);
    }
    Attributes<B> attributes = new Attributes<>(xml, body);
    cameras.narrow(attributes);
    Spec<B> said = attributes.said();
    attributes.warnOfUnknown();
    return said;
  }
}
