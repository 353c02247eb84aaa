package org.hificamsim.core.scenario.file;

import java.util.List;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Spec;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.EventHead;
import org.hificamsim.core.scenario.spec.EventKind;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.xml.XmlElement;

/** Reads events by the declarations of their kinds. */
public final class EventReader {
  private final CameraReader cameras;
  private final TargetReader targets;

  /** Creates a reader that reads added cameras and targets by their own readers. */
  public EventReader(CameraReader cameras, TargetReader targets) {
    this.cameras = cameras;
    this.targets = targets;
  }

  /** Reads one event. */
  public ScenarioEvent event(XmlElement xml) {
    Attributes<ScenarioEvent> head = new Attributes<>(xml, EventHead.ELEMENT);
    int step = head.get(EventHead.STEP);
    String participant = head.get(EventHead.PARTICIPANT);
    List<EventKind<?, ?>> participantKinds =
        ScenarioEvent.kinds().stream()
            .filter(kind -> kind.participant().equals(participant))
            .toList();
    if (head.has(EventHead.HAPPENING)) {
      head.narrow("event", EventHead.oneOf(participantKinds, EventKind::happening));
    }
    String happening = head.get(EventHead.HAPPENING);
    return participantKinds.stream()
        .filter(kind -> kind.happening().equals(happening))
        .findFirst()
        .map(kind -> event(step, kind, xml))
        .orElseThrow();
  }

  private <E extends ScenarioEvent, B> E event(int step, EventKind<E, B> kind, XmlElement xml) {
    return kind.make().apply(step, body(kind.body(), xml));
  }

  /** Reads a camera or target that an event adds like one that is there from the start. */
  @SuppressWarnings("unchecked") // the spec has the type of the element
  private <B> Spec<B> body(Element<B> body, XmlElement xml) {
    if (body.type() == CameraSpec.class) {
      return (Spec<B>) cameras.camera(xml, CameraSpec.ADDED);
    }
    if (body.type() == TargetSpec.class) {
      return (Spec<B>) targets.added(xml);
    }
    Attributes<B> attributes = new Attributes<>(xml, body);
    cameras.narrow(attributes);
    Spec<B> spec = attributes.spec();
    attributes.warnOfUnknown();
    return spec;
  }
}
