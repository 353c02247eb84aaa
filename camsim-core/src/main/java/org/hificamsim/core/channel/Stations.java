package org.hificamsim.core.channel;

/** Cameras as senders and receivers of messages: where they are, and which take part. */
public interface Stations {
  /** The step that is under way, from 0. */
  long step();

  /** A number that changes whenever a camera is added, moved, refitted or switched off. */
  int revision();

  /** How many cameras there will ever be. */
  int cameras();

  /** Whether the camera takes part: it has been added, and no event has switched it off. */
  boolean online(int camera);

  /** Metres. */
  double cameraX(int camera);

  /** Metres. */
  double cameraY(int camera);
}
