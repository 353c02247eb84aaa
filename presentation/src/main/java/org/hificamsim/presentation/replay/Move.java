package org.hificamsim.presentation.replay;

/**
 * A new pose that a camera has from a step on.
 *
 * @param camera the number of the camera
 */
public record Move(long step, int camera, CameraPose pose) {}
