package org.hificamsim.core.channel;

/** The cameras as senders and receivers of messages: positions, and which ones are online. */
public interface Stations {
  /** The step that is under way, from 0. */
  long step();

  /** The log of the bits that cameras send and receive; {@link Post} counts its own messages. */
  default RadioLog radio() {
    return RadioLog.NONE;
  }

  /** A number that changes whenever a camera is added, moved, refitted or switched. */
  int revision();

  /** The number of cameras that there will ever be. */
  int cameras();

  /** Whether the camera is online: added, and not switched off by an event. */
  boolean online(int camera);

  /** The x coordinate of a camera, in metres. */
  double cameraX(int camera);

  /** The y coordinate of a camera, in metres. */
  double cameraY(int camera);
}
