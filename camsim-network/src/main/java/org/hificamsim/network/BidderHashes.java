package org.hificamsim.network;

import java.util.EnumMap;
import java.util.Map;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.Sightings;

/**
 * The hash codes that order the bids of CamSim's cameras (behaviour 4.5, quirk Q19): each that of a
 * text that describes the camera. The constant part of each text is hashed once.
 */
final class BidderHashes {
  /**
   * The hash codes of the cameras' constant parts.
   *
   * @param revisions each camera's, plus 1, when its hash code was computed; 0 before
   */
  @SuppressWarnings("ArrayRecordComponent")
  private record Constants(int[] hashes, int[] revisions) {}

  private final Cameras cameras;
  private final Sightings sightings;
  private final Agent[] agents;
  private final ScheduleKind[] schedules;
  private final Map<ScheduleKind, Constants> known = new EnumMap<>(ScheduleKind.class);

  /**
   * @param agents by camera; may be filled later
   * @param schedules by camera, as they are now; may change
   */
  BidderHashes(Cameras cameras, Sightings sightings, Agent[] agents, ScheduleKind[] schedules) {
    this.cameras = cameras;
    this.sightings = sightings;
    this.agents = agents;
    this.schedules = schedules;
    for (ScheduleKind kind : ScheduleKind.values()) {
      known.put(kind, new Constants(new int[agents.length], new int[agents.length]));
    }
  }

  /** The hash code of the camera's text as it is now. */
  int of(int camera) {
    Constants constants = known.get(schedules[camera]);
    int now = cameras.revision() + 1;
    if (constants.revisions()[camera] != now) {
      constants.revisions()[camera] = now;
      constants.hashes()[camera] = constantPart(camera).hashCode();
    }
    int hash = appendNumber(constants.hashes()[camera], sightings.visible(camera).size());
    return appendNumber(append(hash, " neighbours="), agents[camera].neighbours().count());
  }

  private String constantPart(int camera) {
    return "<camera ai_algorithm=\"%s\" heading=\"%s\" name=\"%s\" range=\"%s\" "
            .formatted(
                schedules[camera].canonicalName(),
                Math.toDegrees(cameras.heading(camera)),
                cameras.name(camera),
                cameras.zoom(camera, cameras.level(camera)).radius())
        + "viewing_angle=\"%s\" x=\"%s\" y=\"%s\" comm=\"0\"/> visibleObjects="
            .formatted(
                Math.toDegrees(cameras.zoom(camera, 0).viewingAngle()),
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
