package org.hificamsim.core.scenario.spec;

import java.util.List;
import java.util.function.Function;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.declaration.Type;

/** The attributes that events of all kinds have in common. */
public final class EventHead {
  public static final Element<ScenarioEvent> ELEMENT =
      Element.<ScenarioEvent>of(
              "event",
              """
              Something that happens at the beginning of a step.
              timestep: the step, from 0
              participant: to whom it happens; `grc` is CamSim's global registration
              event: what happens
              """)
          .holds(TargetSpec.ADDED.content());

  public static final Property<ScenarioEvent, Integer> STEP =
      ELEMENT.required("timestep", Type.whole(0));
  public static final Property<ScenarioEvent, String> PARTICIPANT =
      ELEMENT.required("participant", oneOf(ScenarioEvent.kinds(), EventKind::participant));
  public static final Property<ScenarioEvent, String> HAPPENING =
      ELEMENT.required("event", oneOf(ScenarioEvent.kinds(), EventKind::happening));

  private EventHead() {}

  /** Returns the type of an attribute that is one of the words of these kinds of events. */
  public static Type<String> oneOf(
      List<EventKind<?, ?>> kinds, Function<EventKind<?, ?>, String> word) {
    return Type.word(kinds.stream().map(word).distinct().toList());
  }
}
