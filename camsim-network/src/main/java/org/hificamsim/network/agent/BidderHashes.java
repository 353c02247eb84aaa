package org.hificamsim.network.agent;

import java.util.EnumMap;
import java.util.Map;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.world.Cameras;

/**
 * The hash codes that order the bids of CamSim's cameras (behaviour 4.5, quirk Q19): each that of a
 * text that describes the camera in its view. The constant part of each text is hashed once.
 */
public final class BidderHashes {
  private final Cameras cameras;
  private final Sightings sightings;
  private final Agent[] agents;
  private final Map<ScheduleKind, Known[]> known = new EnumMap<>(ScheduleKind.class);

  /** How a camera looked, and the hash code of the constant part of its text then. */
  private record Known(Pose pose, ZoomLevel zoom, int hash) {
    boolean isOf(Pose now, ZoomLevel through) {
      return pose.equals(now) && zoom.equals(through);
    }
  }

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
      known.put(kind, new Known[agents.length]);
    }
  }

  /** The hash code of the camera's text as it is now. */
  public int of(int camera) {
    int hash = appendNumber(constantPart(camera), sightings.visible(camera));
    return appendNumber(append(hash, " neighbours="), agents[camera].neighbours());
  }

  /** Its hash code, computed again where the camera looks otherwise now. */
  private int constantPart(int camera) {
    ScheduleKind schedule = agents[camera].schedule();
    Known[] all = known.get(schedule);
    Pose pose = cameras.pose(camera, cameras.view(camera));
    ZoomLevel zoom = cameras.zoom(camera, cameras.view(camera));
    if (all[camera] == null || !all[camera].isOf(pose, zoom)) {
      String text = text(cameras.name(camera), schedule, pose, zoom);
      all[camera] = new Known(pose, zoom, text.hashCode());
    }
    return all[camera].hash();
  }

  private static String text(String name, ScheduleKind schedule, Pose pose, ZoomLevel zoom) {
    return "<camera ai_algorithm=\"%s\" heading=\"%s\" name=\"%s\" range=\"%s\" "
            .formatted(
                schedule.canonicalName(), Math.toDegrees(pose.heading()), name, zoom.radius())
        + "viewing_angle=\"%s\" x=\"%s\" y=\"%s\" comm=\"0\"/> visibleObjects="
            .formatted(Math.toDegrees(zoom.viewingAngle()), pose.x(), pose.y());
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
