package org.hificamsim.runs.hints;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Texts;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.visibility.Body;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.Reach;
import org.hificamsim.runs.ShortNumber;

/** Warns of cameras with heights that have views in which they see no target anywhere. */
final class BlindViewHint {
  private BlindViewHint() {}

  static Optional<String> of(Scenario scenario, Detection detection, Catalogue catalogue) {
    if (!scenario.hasHeights()) {
      return Optional.empty();
    }
    World world = new World(scenario, catalogue.movements(), 0);
    world.sightLines().applyRuleOf(detection.model());
    List<Body> bodies =
        IntStream.range(0, world.targets().count())
            .mapToObj(world.targets()::body)
            .distinct()
            .toList();
    Cameras cameras = world.cameras();
    List<String> blind = new ArrayList<>();
    for (int camera = 0; camera < cameras.count(); camera++) {
      List<String> views = blindViews(cameras, camera, Visibility.of(detection), bodies);
      if (!bodies.isEmpty() && !views.isEmpty()) {
        blind.add("'%s' at %s".formatted(cameras.name(camera), Reach.listed(views)));
      }
    }
    return blind.isEmpty()
        ? Optional.empty()
        : Optional.of(
            Texts.format(
                "no target can be seen anywhere by camera %s: expected another tilt or height, or"
                    + " a smaller part of targets that has to be seen",
                String.join("; ", blind)));
  }

  private static List<String> blindViews(
      Cameras cameras, int camera, Visibility visibility, List<Body> bodies) {
    return IntStream.range(0, cameras.views(camera))
        .mapToObj(view -> cameras.zoom(camera, view))
        .distinct()
        .filter(zoom -> bodies.stream().allMatch(body -> visibility.at(zoom, body).isBlind()))
        .map(BlindViewHint::angles)
        .toList();
  }

  private static String angles(ZoomLevel zoom) {
    return "hfov "
        + ShortNumber.of(Math.toDegrees(zoom.viewingAngle()))
        + " tilt "
        + ShortNumber.of(Math.toDegrees(zoom.vertical().tilt()));
  }
}
