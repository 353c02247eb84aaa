package org.hificamsim.network.agent;

import java.util.EnumMap;
import java.util.Map;
import org.hificamsim.core.world.Cameras;

/**
 * The hash codes that order the bids of CamSim's cameras (behaviour 4.5, quirk Q19): each that of a
 * text that describes the camera. The constant part of each text is hashed once.
 */
public final class BidderHashes {
  private final Cameras cameras;
  private final Sightings sightings;
  private final Agent[] agents;
  private final Map<ScheduleKind, int[]> hashes = new EnumMap<>(ScheduleKind.class);
  private final Map<ScheduleKind, int[]> revisions = new EnumMap<>(ScheduleKind.class);

  /**
   * Hash codes of agents as they will be when asked for.
   *
   * @param agents by camera; may be filled later
   */
  public BidderHashes(Cameras cameras, Sightings sightings, Agent[] agents) {
    this.cameras = cameras;
    this.sightings = sightings;
    this.agents = agents;
    for (ScheduleKind kind : ScheduleKind.values()) {
      hashes.put(kind, new int[agents.length]);
      revisions.put(kind, new int[agents.length]);
    }
  }

  /** The hash code of the camera's text as it is now. */
  public int of(int camera) {
    int hash = appendNumber(constantPart(camera), sightings.visible(camera).size());
    return appendNumber(append(hash, " neighbours="), agents[camera].neighbours.size());
  }

  /** Its hash code, computed again where a camera has changed since. */
  private int constantPart(int camera) {
    ScheduleKind schedule = agents[camera].schedule();
    int[] known = hashes.get(schedule);
    int[] revision = revisions.get(schedule);
    if (revision[camera] != cameras.revision() + 1) {
      revision[camera] = cameras.revision() + 1;
      known[camera] = text(camera, schedule).hashCode();
    }
    return known[camera];
  }

  private String text(int camera, ScheduleKind schedule) {
    int view = cameras.view(camera);
    return "<camera ai_algorithm=\"%s\" heading=\"%s\" name=\"%s\" range=\"%s\" "
            .formatted(
                schedule.canonicalName(),
                Math.toDegrees(cameras.pose(camera, view).heading()),
                cameras.name(camera),
                cameras.zoom(camera, view).radius())
        + "viewing_angle=\"%s\" x=\"%s\" y=\"%s\" comm=\"0\"/> visibleObjects="
            .formatted(
                Math.toDegrees(cameras.zoom(camera, view).viewingAngle()),
                cameras.x(camera),
                cameras.y(camera));
  }

  private static int append(int hash, String text) {
    int result = hash;
    for (int i = 0; i < text.length(); i++) {
      result = 31 * result + text.charAt(i);
    }
    return result;
  }

  private static int appendNumber(int hash, int number) {
    int result = number < 10 ? hash : appendNumber(hash, number / 10);
    return 31 * result + '0' + number % 10;
  }
}
