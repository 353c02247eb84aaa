package org.hificamsim.network.agent;

import java.util.EnumMap;
import java.util.Map;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.world.Cameras;

/**
 * The hash codes that order the bids of CamSim's cameras (behaviour 4.5, quirk Q19). Each is the
 * hash code of a text that describes the camera and its view. The part of the text that does not
 * change is hashed once for each pose and zoom level.
 */
public final class BidderHashes {
  private final Cameras cameras;
  private final Sightings sightings;
  private final Agent[] agents;
  private final Map<ScheduleKind, CachedHash[]> cacheBySchedule = new EnumMap<>(ScheduleKind.class);

  /** The hash code of the constant part of a camera's text, for one pose and zoom level. */
  private record CachedHash(Pose pose, ZoomLevel zoom, int hash) {
    boolean matches(Pose currentPose, ZoomLevel currentZoom) {
      return pose.equals(currentPose) && zoom.equals(currentZoom);
    }
  }

  /**
   * Creates the hash codes of agents.
   *
   * @param agents the agents by camera; may be filled later
   */
  public BidderHashes(Cameras cameras, Sightings sightings, Agent[] agents) {
    this.cameras = cameras;
    this.sightings = sightings;
    this.agents = agents;
    for (ScheduleKind kind : ScheduleKind.values()) {
      cacheBySchedule.put(kind, new CachedHash[agents.length]);
    }
  }

  /** Returns the hash code of the current text of a camera. */
  public int hash(int camera) {
    int hash = appendNumber(constantPart(camera), sightings.visibleCount(camera));
    return appendNumber(append(hash, " neighbours="), agents[camera].neighbours());
  }

  /**
   * Returns the hash code of the constant part, computed anew if pose or zoom level have changed.
   */
  private int constantPart(int camera) {
    ScheduleKind schedule = agents[camera].schedule();
    CachedHash[] cache = cacheBySchedule.get(schedule);
    Pose pose = cameras.pose(camera, cameras.view(camera));
    ZoomLevel zoom = cameras.zoom(camera, cameras.view(camera));
    if (cache[camera] == null || !cache[camera].matches(pose, zoom)) {
      String text = text(cameras.name(camera), schedule, pose, zoom);
      cache[camera] = new CachedHash(pose, zoom, text.hashCode());
    }
    return cache[camera].hash();
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
